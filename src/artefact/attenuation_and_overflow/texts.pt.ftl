title = A lei do inverso do quadrado excede a faixa de luminância da tela
claim =
    Perto de uma luz pontual, a luz atenuada por 1/d² varia demais; longe dela, varia de menos. O fator 1/(d + k) tem
    melhor aspecto. Componentes de cor acima de 1 são truncadas, ou a cor é dividida por sua maior componente.
source-1 = Aulas: 1.3.1.7, 1.6.6, 1.6.11, 1.6.17, 1.6.26, 1.6.41
formula-1 = {"I(ρ) = \\frac{I_0 h}{\\sqrt{h^2 + ρ^2}} f(\\sqrt{h^2 + ρ^2})"}
formula-1-says = reflexão difusa num chão, à distância ρ do ponto abaixo de uma luz pontual à altura h
formula-2 = {"ρ^2 < (I_0 h)^{2/3} − h^2"}
formula-2-says = região em que f = 1/d² torna I maior que 1; com f = 1/(d + k), I é no máximo I₀/(h + k)
formula-3 = {"\\frac{I_1}{I_2} = \\frac{d_2 + k}{d_1 + k}"}
formula-3-says = depth cueing: razão entre as luminâncias da mesma superfície a duas distâncias do observador
shown-by = Use uma imagem maior (--size) ou uma luz mais intensa (--intensity 1.5) para mostrá-lo.
inverse-square-title = inverso do quadrado: 1/d²
quadratic-title = quadrática: 1/(1 + d + d²)
offset-title = deslocada: 1/(d + k)
share-inverse-square-measure = 1/d²: parcela do chão com luminância acima de 1
share-inverse-square-by = π [(I₀h)^(2/3) − h²] dividido pela área da janela; tolerância: meio pixel ao longo da borda
share-offset-measure = 1/(d + k): parcela do chão com luminância acima de 1
share-offset-by =
    π (ρ² − h²) sobre a área da janela, com ρ (ρ + k) = I₀h; nenhuma se I₀/(h + k) ≤ 1. Tolerância: meio pixel ao longo da
    borda
contrast-inverse-square-measure = 1/d²: razão entre a luminância abaixo da luz e a da borda do chão
contrast-offset-measure = 1/(d + k): razão entre a luminância abaixo da luz e a da borda do chão
clamped-measure = truncada: razão verde/vermelho abaixo da luz
clamped-by = a luz no centro deste pixel, cada componente truncada em 1; tolerância: o passo de 8 bits nesta cor
divided-measure = dividida pela maior componente: razão verde/vermelho abaixo da luz
exercise-clamped-measure = exercício 1.6.17: vermelho depois do truncamento
exercise-clamped-by = o valor das aulas, (0,9; 1; 0,3)
exercise-divided-measure = exercício 1.6.17: vermelho depois da divisão
exercise-divided-by = 0,9/1,1; o texto das aulas traz 0,818
depth-cue-measure = depth cueing: razão entre as luminâncias da placa mais próxima e da mais distante
depth-cue-by =
    (d₂ + k)/(d₁ + k), com d a distância ao centro de um pixel no meio de cada placa; tolerância: arestas ajustadas a
    1/256 de pixel
peak-measure = 1/d²: maior luminância
overflow-effect = parcela do chão com luminância acima de 1
why-half-pixel = meio pixel
overflow-cure = 1/(d + k) com k = 1
hue-effect = diferença entre a razão verde/vermelho abaixo da luz e a da cor da luz, { $hue }
why-hue = uma diferença visível de matiz
depth-cue-effect =
    diferença entre a razão das luminâncias da placa mais próxima e da mais distante e a da fórmula, { $law }
why-plate = um décimo da luminância de uma placa
holds-only-if =
    as cores forem exibidas como calculadas. A lei 1/d² resulta da geometria de uma fonte de luz pequena, e não da
    atmosfera, como dizem as aulas; seus valores excedem a faixa de luminância da tela. 1/(d + k) com k ≥ I₀ − h fica
    nessa faixa, mas não é a lei de nenhuma fonte de luz real.
fails =
    k = { $k } é menor que I₀ − h = { $least }: abaixo da luz, 1/(d + k) também ultrapassa a faixa da tela. Isso vale para
    qualquer lei sem limite, se a luz for bastante intensa.
inverse-square-caption = Um chão abaixo de uma luz pontual de intensidade I₀ = { $intensity } à altura h = { $height }.
inverse-square-seen =
    Abaixo da luz há um disco branco de borda nítida, onde a luminância passa de 1. Mais longe, o chão é escuro.
quadratic-caption = Atenuação com um termo constante, um linear e um quadrático.
quadratic-seen = Não há disco, mas o chão continua escuro ao longe.
offset-caption = A mesma luz com 1/(d + k), k = { $k }.
offset-seen = Não há disco, e o chão é visível até os cantos.
clamped-title = luz laranja, truncada
clamped-caption = Uma luz pontual laranja com componentes truncadas.
clamped-seen = Vermelho e verde são truncados em 1: em direção ao meio, a cor fica amarela e depois branca.
divided-title = luz laranja, dividida
divided-caption = Cada cor acima de 1 é dividida por sua maior componente.
divided-seen =
    O matiz é correto em toda parte. Só se perde luminância: o resultado é um disco uniforme, do tamanho do disco branco
    de 1/d².
no-depth-cue-title = sem depth cueing
no-depth-cue-caption =
    Três placas a distâncias diferentes. As mais distantes são maiores, e por isso todas têm o mesmo tamanho na imagem.
no-depth-cue-seen = Todas as placas parecem iguais; não se percebe a distância de cada uma.
depth-cue-title = com depth cueing
depth-cue-caption = Luminância dividida pela distância ao observador mais k.
depth-cue-seen = A placa próxima é clara e a distante é escura.
note-1 =
    Com 1/d², a luz quadruplica quando a distância cai à metade. Uma luz adequada ao longe excede o branco da tela perto
    da fonte e ali é truncada. Uma constante somada a d mantém a luz abaixo do branco e a faz cair mais devagar ao
    longe. O truncamento de uma luz colorida age em cada canal, e por isso o matiz se desloca para o branco.
note-2 = As aulas usam a letra d para duas distâncias: à luz na atenuação, e ao observador no depth cueing.
contrast-inverse-square-by =
    a fórmula nos centros desses pixels; tolerância: posições em precisão simples, a 100 unidades do observador
white-curve = branco da tela
light-on-the-floor-title = Luz no chão
light-on-the-floor-caption =
    Luminância em função da distância ao ponto abaixo da luz. Nesse ponto, 1/d² é { $overflow } vezes o branco da tela.
    A curva fica abaixo da de 1/(d + k) a partir de ρ = { $crossing }.
light-on-the-floor-x = distância ao ponto abaixo da luz
light-on-the-floor-y = luminância
contrast-offset-by = { contrast-inverse-square-by }
divided-by = a razão da cor da luz; tolerância: o passo de 8 bits nesta cor
hue-cure = cores divididas por sua maior componente
depth-cue-cure = { depth-cue-title }
inverse-square-curve = { inverse-square-title }
quadratic-curve = { quadratic-title }
offset-curve = { offset-title }
