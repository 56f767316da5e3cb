title = Normais quantizadas são visíveis primeiro nos brilhos
claim =
    O arredondamento das normais é visível primeiro nos brilhos. Uma normal com erro δ muda a reflexão difusa em no
    máximo k_d δ. Ela muda o brilho de Blinn em até cerca de k_s √(n/e) δ. No brilho de Phong a mudança é o dobro, pois
    o raio refletido gira o dobro do ângulo.
source-1 = Aulas: 1.3.1.2, 1.6.21 (normais e expoentes; a precisão dos números não é discutida)
source-2 =
    Artigo: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = mudança do brilho de Blinn se a normal tem o erro δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    erro rms da normal de um triângulo de lados a, b, c e área A, com posições arredondadas a múltiplos de u. Em
    precisão simples, u é a distância à origem sobre 2²³ a 2²⁴
shown-by = Use um brilho nítido de alguns pixels (expoentes de 100 a 10 000) para mostrá-lo.
mean-error-measure = 3 × 8 bits: erro médio nos vértices
mean-error-by =
    cada componente arredondada a um múltiplo de 1/127. O erro médio perto de um eixo, como aqui, é (√2 + ln(1 + √2))/6
    desse passo, ou 0,1726°; em todas as direções é 0,1701°
largest-error-measure = 3 × 8 bits: maior erro nos vértices
largest-error-by = o mesmo arredondamento; no máximo meio passo em cada uma de três componentes, √3/254 ou 0,391°
change-over-bound-measure = 3 × 8 bits: mudança da luz dividida pelo seu limite
change-over-bound-by = o limite (k_d + k_s M(n)) δ
change-measure = 3 × 8 bits: maior mudança da luz
change-diffuse-measure = 3 × 8 bits: maior mudança só da reflexão difusa, k_d = 1
change-blinn-measure = 3 × 8 bits: maior mudança só do brilho de Blinn, k_s = 1
change-phong-measure = 3 × 8 bits: maior mudança só do brilho de Phong, k_s = 1
change-phong-by = 2 M(n) δ, o dobro do limite do brilho de Blinn com k_s = 1, pois o raio refletido gira 2 δ
change-sixteen-measure = 2 × 16 bits: maior mudança da luz
change-sixteen-by = o limite para 0,0037°, o maior erro desta codificação, mais a precisão simples vezes n
needle-plain-measure = lasca de 1 : 10⁶, produtos simples: erro da normal
needles-exact-measure = lascas, diferenças exatas de produtos: maior erro
needles-exact-by = um arredondamento do resultado
pixels-eight-measure = pixels, 3 × 8 bits: erro médio
pixels-sixteen-measure = pixels, 2 × 16 bits: erro médio
pixels-single-measure = pixels, precisão simples: erro médio
pixels-far-measure = pixels, longe da origem: erro médio
bits-effect = maior mudança da luz em relação às normais exatas da esfera
bits-cure = normais guardadas como 2 × 16 bits
far-cure = posições centradas antes de arredondar
eight-bits-title = 3 × 8 bits por normal
eight-bits-caption = Um brilho visto de perto. Cada componente das normais é arredondada a 8 bits.
eight-bits-seen = O brilho fica deformado e manchado.
sixteen-bits-title = 2 × 16 bits por normal
sixteen-bits-caption = As mesmas normais em codificação octaédrica com 2 × 16 bits, um byte a mais.
sixteen-bits-seen = O brilho é quase liso.
far-away-title = longe da origem
far-away-seen = As normais calculadas com essas posições tornam a luz irregular.
centred-title = posições centradas
centred-caption = A mesma esfera com as posições centradas antes do arredondamento.
centred-seen = A luz é lisa.
note-1 =
    Longe da origem, uma aritmética melhor não ajuda. As diferenças entre posições arredondadas são exatas; a precisão
    se perdeu quando as posições foram guardadas. Para lascas, uma aritmética melhor ajuda. Com produtos simples, o
    produto vetorial de duas arestas quase paralelas sofre cancelamento; com diferenças exatas de produtos, ele é
    correto até o último dígito.
fails =
    a reflexão difusa muda mais que o brilho aqui. √(n/e) é a inclinação no ponto mais íngreme de cos^n; num brilho tão
    largo, esse ponto não é visível.
few-faces = não comparado: as faces não bastam para uma média de erros de arredondamento
far-faces-by =
    u √(a² + b² + c²)/(2A√12) de cada face, com u a distância entre números vizinhos ali; tolerância: três desvios
    padrão da amostra dos erros de arredondamento
needles-title = Normais de lascas
needles-caption =
    Maior erro da normal de um triângulo em função da razão altura/comprimento, com posições em precisão simples. Com
    produtos simples, uma lasca dez vezes mais fina tem um erro dez vezes maior. Com diferenças exatas de produtos, o
    erro não cresce.
needles-x = razão altura/comprimento
needles-y = maior erro em graus
plain-curve = produtos simples
exact-curve = diferenças exatas de produtos
rounding-curve = um arredondamento em precisão simples sobre r
plate-effect = maior mudança da luz em relação à única normal exata da placa
plate-measure = placa de lascas, produtos simples: mudança da luz dividida pelo seu limite
plate-by = o limite (k_d + k_s M(n)) δ para o maior erro, { $largest }°
needles-plain-title = lascas, produtos simples
needles-plain-caption =
    Uma placa plana sob uma luz pontual próxima. Cada faixa é o meio de uma lasca 300 000 vezes mais comprida que alta,
    com a normal de produtos simples em precisão simples.
needles-plain-seen = O brilho se divide em faixas.
needles-exact-title = lascas, diferenças exatas
needles-exact-caption = As mesmas lascas com normais de diferenças exatas de produtos.
needles-exact-seen = O brilho é uma mancha redonda.
plate-cure = { exact-curve }
far-effect = { bits-effect }
far-faces-measure = a { $distance } raios da origem: erro das normais das faces (rms)
far-away-caption = Posições guardadas em precisão simples a { $distance } raios da origem.
holds =
    para erros pequenos. Para manter este brilho (Blinn, n = { $exponent }, k_s = { $strength }) dentro de meio passo de
    8 bits, as normais devem ter exatidão de { $needed }°. Com 3 × 8 bits o maior erro é { $eight }°, { $eight-times }
    vezes isso; com 2 × 16 bits é { $sixteen }°, { $sixteen-times } vezes isso.
