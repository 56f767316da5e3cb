title = Normais com poucos dígitos
claim =
    O arredondamento aparece primeiro nos brilhos: uma normal com erro δ muda a luz difusa no máximo por k_d δ, mas o
    brilho de Blinn por até cerca de k_s √(n/e) δ, e o de Phong pelo dobro, pois o raio espelhado gira o dobro da
    normal.
source-1 = Aulas: 1.3.1.2, 1.6.21 (normais e expoentes; não falam de dígitos)
source-2 =
    Artigo: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = a mudança do brilho de Blinn quando a normal erra por δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    o erro da normal de um triângulo de lados a, b, c e área A quando as posições são arredondadas a múltiplos de u, que
    em precisão simples é a distância à origem sobre 2²³ a 2²⁴
shown-by = um brilho nítido de alguns pixels (expoentes de 100 a 10 000) o mostraria.
mean-error-measure = três vezes 8 bits: erro médio nos vértices
mean-error-by =
    cada componente ao 1/127 mais próximo; para normais perto de um eixo, como estas, em média (√2 + ln(1 + √2))/6 de um
    tal passo, 0,1726°, e 0,1701° em normais de todas as direções
largest-error-measure = três vezes 8 bits: maior erro nos vértices
largest-error-by = o mesmo; no máximo meio passo em cada uma de três componentes, √3/254 ou 0,391°
change-over-bound-measure = 8 bits: mudança do brilho sobre o seu limite
change-over-bound-by = o limite (k_d + k_s M(n)) δ vale
change-measure = 8 bits: maior mudança da luz
change-diffuse-measure = 8 bits: maior mudança só da luz difusa, k_d = 1
change-blinn-measure = 8 bits: maior mudança só do brilho de Blinn, k_s = 1
change-phong-measure = 8 bits: maior mudança só do brilho de Phong, k_s = 1
change-phong-by = 2 M(n) δ: o dobro do limite do de Blinn, k_s = 1, pois o raio espelhado gira 2 δ
change-sixteen-measure = duas vezes 16 bits: maior mudança da luz
change-sixteen-by = limite para 0,0037°, o maior erro deste código; e precisão simples, n vezes maior
needle-plain-measure = agulha de 1 : 10⁶, aritmética simples: erro
needles-exact-measure = agulhas, diferenças exatas de produtos: maior erro
needles-exact-by = um arredondamento do resultado
pixels-eight-measure = pixels, 8 bits: erro médio
pixels-sixteen-measure = pixels, duas vezes 16 bits: erro médio
pixels-single-measure = pixels, precisão simples: erro médio
pixels-far-measure = pixels, longe da origem: erro médio
bits-effect = maior mudança da luz em relação à das normais da própria esfera
bits-cure = normais como duas vezes 16 bits
far-cure = posições centradas antes de arredondar
eight-bits-title = 3 × 8 bits por normal
eight-bits-caption = Um brilho visto de perto, normais arredondadas a 8 bits por componente.
eight-bits-seen = Ele fica amassado e manchado.
sixteen-bits-title = 2 × 16 bits por normal
sixteen-bits-caption = As mesmas normais num octaedro com duas vezes 16 bits, com um byte a mais.
sixteen-bits-seen = Os amassados quase sumiram.
far-away-title = posições distantes
far-away-seen = As normais calculadas delas tornam a luz áspera.
centred-title = posições centradas
centred-caption = A mesma esfera com as posições centradas antes de arredondar.
centred-seen = Nada é áspero.
note-1 =
    Longe da origem nenhuma aritmética melhor ajuda: as diferenças das posições arredondadas são exatas, o que se perdeu
    foi ao guardá-las. Para agulhas ajuda: com produtos simples o produto vetorial de duas arestas quase paralelas se
    cancela, com diferenças exatas de produtos ele está certo até o último dígito.
fails =
    a luz difusa muda mais aqui: √(n/e) é a inclinação onde cos^n é mais íngreme, o que está fora de vista num brilho
    tão largo.
few-faces = tão poucas faces não são uma média de erros de arredondamento
far-faces-by =
    u √(a² + b² + c²)/(2A√12) de cada face, u a distância entre números vizinhos ali; três desvios padrão da amostra dos
    erros de arredondamento
needles-title = Normais de agulhas
needles-caption =
    Maior erro da normal de um triângulo em função da altura sobre o comprimento, posições em precisão simples: produtos
    simples perdem um dígito a cada dígito de finura, diferenças exatas de produtos nenhum.
needles-x = altura sobre comprimento
needles-y = maior erro em graus
plain-curve = produtos simples
exact-curve = diferenças exatas de produtos
rounding-curve = um arredondamento sobre r: 2⁻²⁴/r
plate-effect = maior mudança da luz em relação à da única normal da placa
plate-measure = placa de agulhas, aritmética simples: mudança do brilho sobre o seu limite
plate-by = o limite (k_d + k_s M(n)) δ vale para o maior erro, { $largest }°
needles-plain-title = agulhas, produtos simples
needles-plain-caption =
    Uma placa plana sob uma luz próxima. Cada faixa é o meio de uma agulha 300 000 vezes mais comprida que alta, com a
    normal que lhe dão produtos simples em precisão simples.
needles-plain-seen = O brilho se rasga em faixas.
needles-exact-title = agulhas, diferenças exatas
needles-exact-caption = As mesmas agulhas com normais de diferenças exatas de produtos.
needles-exact-seen = O brilho é uma mancha redonda.
plate-cure = { exact-curve }
far-effect = { bits-effect }
far-faces-measure = a { $distance } raios da origem: erro das normais das faces (rms)
far-away-caption = Posições guardadas em precisão simples a { $distance } raios da origem.
holds =
    para erros pequenos. Meio passo de 8 bits deste brilho (de Blinn, n = { $exponent }, k_s = { $strength }) exige
    normais certas até { $needed }°. Com 8 bits por componente elas erram aqui até { $eight }°, { $eight-times } vezes
    isso; com duas vezes 16 bits até { $sixteen }°, { $sixteen-times } vezes isso.
