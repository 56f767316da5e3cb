title = Dependência da orientação
claim =
    A interpolação por linhas de varredura depende da orientação do polígono: o centro do losango do exercício 1.6.25
    tem a cor (0,1; 0,5; 0,5) numa posição e (0,2; 0,3; 0,1) um quarto de volta depois.
source-1 = Aulas: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25
source-2 = Ting 2008: “Resultados distintos para diferentes triangulações”
formula-1 = {"c(θ) = \\frac{|\\cos(θ)| (c_1 + c_3)/2 + |\\sin(θ)| (c_2 + c_4)/2}{|\\cos(θ)| + |\\sin(θ)|}"}
formula-1-says =
    a cor no centro do losango girado de θ; c₁ a c₄ são as cores dos cantos, no sentido anti-horário a partir do
    direito, e θ = 0 é a posição 1
own-mesh = a sua primeira face de quatro cantos ou mais, com as cores dos seus vértices se as tiver
shown-by = um polígono de quatro cantos ou mais, cujas cores não estão num plano sobre ele, o mostraria.
law-scanline-corners = a lei da linha de varredura; os cantos se ajustam a 1/256 de pixel
measure-largest-distance-law = maior distância da lei, em 72 giros
measure-largest-change-centre = maior mudança da cor do centro
measure-mean-change-centre = mudança média da cor do centro
measure-largest-change-triangles = maior mudança, em triângulos
by-barycentric-coordinates-do = coordenadas baricêntricas não giram; os cantos se ajustam a 1/256 de pixel
moved = maior mudança da cor do centro durante o giro
cure = cortado em triângulos
holds-polygons-four-corners =
    para polígonos de quatro cantos ou mais, cujas cores não são as de um plano. Triângulos não dependem de como são
    girados, mas as cores de um polígono passam a depender de como ele é cortado neles.
note-seen-front-all =
    Vistos de frente todos os triângulos são iguais. Em vista oblíqua as suas cores têm de ser misturadas por
    1/profundidade (perspectiva): misturadas por distâncias na imagem também mudam com o giro, menos que as da linha de
    varredura.
note-algorithm-interpolates-down =
    O algoritmo interpola ao longo das duas arestas que a linha de varredura corta, e depois entre elas. Gire o
    polígono, e a linha pelo seu centro corta outras arestas em outros lugares.
note-animation-animate-shows =
    A animação (--animate) mostra o giro; --interpolation affine ou perspective o mostra em triângulos, onde nada muda
    senão o lugar.
note-triangles-cure-three =
    Triângulos curam isso: três cantos determinam um plano de cores. O preço é a escolha da diagonal: o centro do
    losango tem a média dos cantos que a diagonal liga.
polygon-edges-shorter = este polígono tem arestas menores que um pixel, que as linhas de varredura podem saltar
exercise-b-answer = exercício 1.6.25 b, resposta C
mean-corners-diagonal = a média dos cantos que a diagonal liga
position = posição 1
position-v2 = posição 2
diagonal-triangles = diagonal 1–3 (triângulos)
diagonal-triangles-v2 = diagonal 2–4 (triângulos)
oblique-change-quarter = em vista oblíqua, mudança por um quarto de volta: varredura
line-corner-mixed = a linha do canto 3 ao 1, depois a do 2 ao 4, misturada por distâncias na imagem
oblique-change-quarter-turn = em vista oblíqua, mudança por um quarto de volta: triângulos
s-d-corners = s/2d da diferença dos cantos 1 e 3: a aresta entre eles entra na profundidade numa posição só
oblique-change-quarter-turn-triangles = em vista oblíqua, mudança por um quarto de volta: triângulos com perspectiva
colours-mixed-depth = cores misturadas por 1/profundidade são do lugar no polígono
law-scanline-every = a lei da linha de varredura em cada pixel, 0 em triângulos; os cantos se ajustam a 1/256 de pixel
moved-largest-change-pixel = maior mudança da cor de um pixel por um quarto de volta, girado de volta
same-colours-however = As mesmas cores como quer que seja girado.
also-same-however = Também as mesmas como quer que seja girado, mas não as do outro.
halves-title = varredura: 0° acima, 90° abaixo
halves-caption-above-diamond-stands =
    Acima, o losango como está; abaixo, desenhado girado de 90° e girado de volta. O canto 1 está à direita, o 2 acima,
    o 3 à esquerda (o mais claro), o 4 abaixo (oliva).
halves-caption-above-polygon-stands = Acima, o polígono como está; abaixo, desenhado girado de 90° e girado de volta.
halves-caption-colours-own-would = Se as cores fossem dele, não haveria emenda.
halves-triangles-title = triângulos: 0° acima, 90° abaixo
halves-triangles-caption-same-triangles = O mesmo em triângulos.
halves-triangles-caption-no-seam = Não há emenda.
position-1-title = linha de varredura, 0°
position-1-caption-position-scanline-through = Posição 1: a linha de varredura pelo centro vai do canto 3 ao canto 1.
position-1-caption-stands-every-pixel =
    Como está: cada pixel fica entre as duas arestas que a sua linha de varredura encontra primeiro.
position-1-caption-turned-other-colours = Girado ele tem outras cores.
turned-45-title = linha de varredura, 45°
turned-45-caption-eighth-turn-scanline =
    Um oitavo de volta: a linha corta duas arestas nos seus meios, e o centro é a média de todos os cantos.
turned-45-caption-eighth-turn-scanlines = Um oitavo de volta: as linhas encontram as arestas em outros lugares.
turned-45-caption-colours-change-turn = As cores mudam com o giro.
position-2-title = linha de varredura, 90°
position-2-caption-position-scanline-runs = Posição 2: a linha vai do canto 2 ao canto 4.
position-2-caption-quarter-turn-scanlines = Um quarto de volta: as linhas encontram outras arestas.
position-2-caption-same-polygon-other = O mesmo polígono tem outras cores.
difference-title = diferença, 90° girado de volta
difference-caption-position-turned-back =
    A posição 2 girada de volta, menos a posição 1: escuro é nenhuma, amarelo 0,4 da faixa numa componente.
difference-caption-drawn-turned-turned =
    Desenhado girado e girado de volta, menos como está: escuro é nenhuma, amarelo 0,4 da faixa numa componente.
diagonal-13-title = triângulos, diagonal 1–3
diagonal-13-caption-triangles-cut-way = triângulos, um corte
diagonal-13-caption-cut-corner-corner =
    Cortado do canto 1 ao canto 3: o que as linhas de varredura desenham na posição 1, cuja linha do meio é esta
    diagonal.
diagonal-13-caption-cut-way = Cortado de um modo.
diagonal-24-title = triângulos, diagonal 2–4
diagonal-24-caption-triangles-same-cut = triângulos, o mesmo corte
diagonal-24-caption-triangles-cut-another = triângulos, outro corte
diagonal-24-caption-cut-corner-corner = Cortado do canto 2 ao canto 4: o que as linhas de varredura desenham na posição 2.
diagonal-24-caption-no-other-cut = Nenhum outro corte fica dentro deste polígono: o mesmo mais uma vez.
diagonal-24-caption-cut-another-way = Cortado de outro modo.
diagonals-title = diferença das diagonais
diagonals-caption-difference-cuts = diferença dos cortes
diagonals-caption-diagonal-less-other =
    Uma diagonal menos a outra: o que o corte decide, e é o que o giro decide nas linhas de varredura. Amarelo é 0,4 da
    faixa numa componente.
diagonals-caption-cut-less-other = Um corte menos o outro: o que o corte decide. Amarelo é 0,4 da faixa numa componente.
r-scanline = R, linha de varredura
g-scanline = G, linha de varredura
b-scanline = B, linha de varredura
g-triangles = G, triângulos
r-law = R, a lei
g-law = G, a lei
b-law = B, a lei
chart-title = Cor do centro numa volta inteira
chart-caption =
    No algoritmo de linhas de varredura a cor do centro muda até { $bad } numa volta, como diz a lei; em triângulos até
    { $cured }.
axis-turned-degrees = giro, graus
axis-linear-component = componente linear
