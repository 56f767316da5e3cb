title = Atenuação e estouro
claim =
    A luz que cai com o quadrado da distância varia demais perto da lâmpada e de menos longe dela; 1/(d + k) é melhor.
    Cores acima de 1 são truncadas, ou divididas pela maior componente.
source-1 = Aulas: 1.3.1.7, 1.6.6, 1.6.11, 1.6.17, 1.6.26, 1.6.41
formula-1 = {"I(ρ) = \\frac{I_0 h}{\\sqrt{h^2 + ρ^2}} f(\\sqrt{h^2 + ρ^2})"}
formula-1-says = luz difusa no chão à distância ρ do ponto sob uma lâmpada à altura h
formula-2 = {"ρ^2 < (I_0 h)^{2/3} − h^2"}
formula-2-says = onde f = 1/d² a faz maior que 1; com f = 1/(d + k) ela é no máximo I₀/(h + k)
formula-3 = {"\\frac{I_1}{I_2} = \\frac{d_2 + k}{d_1 + k}"}
formula-3-says = depth cueing: a mesma superfície a duas distâncias do observador
shown-by = uma imagem maior o mostraria.
inverse-square-title = inverso do quadrado: 1/d²
quadratic-title = quadrática: 1/(1 + d + d²)
offset-title = deslocada: 1/(d + k)
share-inverse-square-measure = 1/d²: parcela do chão que estoura
share-inverse-square-by = π [(I₀h)^(2/3) − h²] sobre a janela; meio pixel ao longo da borda
share-offset-measure = 1/(d + k): parcela do chão que estoura
share-offset-by = I₀/(h + k) ≤ 1: nenhuma, salvo arredondamento em precisão simples
contrast-inverse-square-measure = 1/d²: luz sob a lâmpada sobre a da borda
contrast-offset-measure = 1/(d + k): luz sob a lâmpada sobre a da borda
clamped-measure = truncada: verde sobre vermelho sob a lâmpada
clamped-by = ambas são cortadas em 1
divided-measure = dividida pela maior: verde sobre vermelho sob a lâmpada
exercise-clamped-measure = exercício 1.6.17: vermelho truncado
exercise-clamped-by = o (0,9; 1; 0,3) das aulas
exercise-divided-measure = exercício 1.6.17: vermelho dividido
exercise-divided-by = 0,9/1,1, impresso 0,818
depth-cue-measure = depth cueing: placa mais próxima sobre a mais distante
depth-cue-by =
    (d₂ + k)/(d₁ + k), d a distância ao centro do pixel no meio de cada placa; arestas ajustadas a 1/256 pixel
peak-measure = 1/d²: maior luminância
overflow-effect = parcela do chão que estoura
why-half-pixel = metade de um pixel
overflow-cure = 1/(d + k) com k = 1
hue-effect = quanto verde sobre vermelho sob a lâmpada dista do { $hue } da própria lâmpada
why-hue = um tom que se vê diferir
depth-cue-effect = quanto a luz da placa mais próxima sobre a da mais distante dista do { $law } da lei
why-plate = um décimo da luz de uma placa
holds-only-if =
    as cores são mostradas como calculadas. 1/d² é o que a geometria diz de uma lâmpada pequena (não a atmosfera, como
    nas aulas); o que falha é o alcance da tela. 1/(d + k) com k ≥ I₀ − h cabe nele, ao preço de não ser a lei de
    lâmpada alguma.
inverse-square-caption = Um chão sob uma lâmpada de força I₀ = { $strength } à altura h = { $height }.
inverse-square-seen =
    Há um disco branco de borda dura sob a lâmpada, onde a luz passa de 1, e escuridão logo depois.
quadratic-caption = Termos constante, linear e quadrático juntos.
quadratic-seen = Sem disco, e ainda escuro ao longe.
offset-caption = A mesma lâmpada, k = { $k }.
offset-seen = Sem disco, e vê-se o chão até os cantos.
clamped-title = lâmpada quente, truncada
clamped-caption = Uma lâmpada laranja.
clamped-seen =
    O seu vermelho e o seu verde são ambos cortados em 1: perto do meio ela fica amarela e depois branca.
divided-title = lâmpada quente, dividida
divided-caption = Dividida pela maior componente.
divided-seen =
    O tom é o da lâmpada em toda parte. Só se perde o brilho: resta um disco liso, do tamanho do branco sob 1/d².
no-depth-cue-title = sem depth cueing
no-depth-cue-caption =
    Três placas a distâncias diferentes, tanto maiores quanto mais longe, de modo que aqui têm o mesmo tamanho.
no-depth-cue-seen = Todas são iguais: qual é a mais próxima?
depth-cue-title = com depth cueing
depth-cue-caption = Divididas pela distância ao observador mais k.
depth-cue-seen = A placa próxima é clara e a distante é escura.
note-1 =
    Sob 1/d² a luz quadruplica a cada metade da distância: o que está certo ao longe passa do branco da tela de perto, e
    ali é cortado. Um termo somado a d mantém a luz abaixo do branco junto à lâmpada, e cai mais devagar ao longe. Onde
    se corta uma luz colorida, corta-se canal por canal, e o tom vai para o branco.
note-2 =
    As aulas usam a letra d duas vezes: para a distância à lâmpada na atenuação, e ao observador no depth cueing.
contrast-inverse-square-by =
    a fórmula nos centros desses pixels; posições em precisão simples a partir de um observador a 100 unidades
white-curve = o que a tela mostra
light-on-the-floor-title = Luz no chão
light-on-the-floor-caption =
    Luminância em função da distância ao ponto sob a lâmpada: 1/d² é ali { $overflow } vezes o que a tela mostra, e cai
    abaixo de 1/(d + k) em ρ = { $crossing }.
light-on-the-floor-x = distância ρ
light-on-the-floor-y = luminância
contrast-offset-by = { contrast-inverse-square-by }
divided-by = o passo de 8 bits nesta cor
hue-cure = cores divididas pela sua maior componente
depth-cue-cure = { depth-cue-title }
inverse-square-curve = { inverse-square-title }
quadratic-curve = { quadratic-title }
offset-curve = { offset-title }
