title = Normais com poucos dígitos
claim =
    O arredondamento aparece primeiro nos brilhos: uma normal com erro δ muda a luz difusa no máximo por k_d δ, mas o
    brilho de Blinn por até cerca de k_s √(n/e) δ, e o de Phong pelo dobro, pois o raio espelhado gira o dobro da
    normal.
source-1 = Aulas: 1.3.1.2, 1.6.21 (normais e expoentes; não falam de dígitos)
source-2 = Artigo: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = a mudança do brilho de Blinn quando a normal erra por δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    o erro da normal de um triângulo de lados a, b, c e área A quando as posições são arredondadas a múltiplos de u, que
    em precisão simples é a distância à origem sobre 2²³ a 2²⁴
shown-by = um brilho nítido de alguns pixels (expoentes de 100 a 10 000) o mostraria.
measure-three-times-bits = três vezes 8 bits: erro médio nos vértices
by-every-component-nearest =
    cada componente ao 1/127 mais próximo; para normais perto de um eixo, como estas, em média (√2 + ln(1 + √2))/6 de um
    tal passo, 0,1726°, e 0,1701° em normais de todas as direções
measure-three-times-bits-largest = três vezes 8 bits: maior erro nos vértices
by-same-half-step = o mesmo; no máximo meio passo em cada uma de três componentes, √3/254 ou 0,391°
measure-bits-change-highlight = 8 bits: mudança do brilho sobre o seu limite
by-bound-k-d = o limite (k_d + k_s M(n)) δ vale
measure-bits-largest-change = 8 bits: maior mudança da luz
measure-bits-largest-change-diffuse = 8 bits: maior mudança só da luz difusa, k_d = 1
measure-bits-largest-change-blinn = 8 bits: maior mudança só do brilho de Blinn, k_s = 1
measure-bits-largest-change-phong = 8 bits: maior mudança só do brilho de Phong, k_s = 1
by-m-n-twice = 2 M(n) δ: o dobro do limite do de Blinn, k_s = 1, pois o raio espelhado gira 2 δ
measure-twice-bits-largest = duas vezes 16 bits: maior mudança da luz
by-bound-largest-error = limite para 0,0037°, o maior erro deste código; e precisão simples, n vezes maior
measure-needle-plain-arithmetic = agulha de 1 : 10⁶, aritmética simples: erro
measure-needles-exact-differences = agulhas, diferenças exatas de produtos: maior erro
by-rounding-result = um arredondamento do resultado
measure-pixels-bits-mean = pixels, 8 bits: erro médio
measure-pixels-twice-bits = pixels, duas vezes 16 bits: erro médio
measure-pixels-single-precision = pixels, precisão simples: erro médio
measure-pixels-far-origin = pixels, longe da origem: erro médio
moved = maior mudança da luz em relação à das normais da própria esfera
cure = normais como duas vezes 16 bits
cure-positions-centred-before = posições centradas antes de arredondar
eight-bits-title = 3 × 8 bits por normal
eight-bits-caption-highlight-seen-close = Um brilho visto de perto, normais arredondadas a 8 bits por componente.
eight-bits-caption-dented-blotchy = Ele fica amassado e manchado.
sixteen-bits-title = 2 × 16 bits por normal
sixteen-bits-caption-same-normals-octahedron = As mesmas normais num octaedro com duas vezes 16 bits, com um byte a mais.
sixteen-bits-caption-dents-all-but = Os amassados quase sumiram.
far-away-title = posições distantes
far-away-caption-normals-computed-them = As normais calculadas delas tornam a luz áspera.
centred-title = posições centradas
centred-caption-same-sphere-positions = A mesma esfera com as posições centradas antes de arredondar.
centred-caption-nothing-rough = Nada é áspero.
note-far-origin-no =
    Longe da origem nenhuma aritmética melhor ajuda: as diferenças das posições arredondadas são exatas, o que se perdeu
    foi ao guardá-las. Para agulhas ajuda: com produtos simples o produto vetorial de duas arestas quase paralelas se
    cancela, com diferenças exatas de produtos ele está certo até o último dígito.
fails-diffuse-light-changes =
    a luz difusa muda mais aqui: √(n/e) é a inclinação onde cos^n é mais íngreme, o que está fora de vista num brilho
    tão largo.
untested-few-faces-no = tão poucas faces não são uma média de erros de arredondamento
by-u-b-c =
    u √(a² + b² + c²)/(2A√12) de cada face, u a distância entre números vizinhos ali; três desvios padrão da amostra dos
    erros de arredondamento
chart-title = Normais de agulhas
chart-caption =
    Maior erro da normal de um triângulo em função da altura sobre o comprimento, posições em precisão simples: produtos
    simples perdem um dígito a cada dígito de finura, diferenças exatas de produtos nenhum.
axis-height-over-length = altura sobre comprimento
axis-largest-error-degrees = maior erro em graus
curve-plain-products = produtos simples
curve-exact-differences-products = diferenças exatas de produtos
curve-rounding-over-r = um arredondamento sobre r: 2⁻²⁴/r
moved-largest-change-light = maior mudança da luz em relação à da única normal da placa
measure-plate-needles-plain = placa de agulhas, aritmética simples: mudança do brilho sobre o seu limite
by-bound-k-d-k = o limite (k_d + k_s M(n)) δ vale para o maior erro, { $largest }°
needles-plain-title = agulhas, produtos simples
needles-plain-caption-flat-plate-light =
    Uma placa plana sob uma luz próxima. Cada faixa é o meio de uma agulha 300 000 vezes mais comprida que alta, com a
    normal que lhe dão produtos simples em precisão simples.
needles-plain-caption-highlight-torn-into = O brilho se rasga em faixas.
needles-exact-title = agulhas, diferenças exatas
needles-exact-caption-same-needles-normals = As mesmas agulhas com normais de diferenças exatas de produtos.
needles-exact-caption-highlight-round-spot = O brilho é uma mancha redonda.
