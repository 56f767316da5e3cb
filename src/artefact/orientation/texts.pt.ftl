title = A interpolação por varredura depende da orientação
claim =
    A interpolação por linhas de varredura depende da orientação do polígono. O centro do losango do exercício 1.6.25
    tem a cor (0,1; 0,5; 0,5) numa posição e (0,2; 0,3; 0,1) depois de uma rotação de 90°.
source-1 = Aulas: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25
source-2 = Ting 2008: “Resultados distintos para diferentes triangulações”
formula-1 = {"c(θ) = \\frac{|\\cos(θ)| (c_1 + c_3)/2 + |\\sin(θ)| (c_2 + c_4)/2}{|\\cos(θ)| + |\\sin(θ)|}"}
formula-1-says =
    cor no centro do losango girado de θ; c₁ a c₄ são as cores dos cantos, em sentido anti-horário a partir do direito.
    θ = 0 é a posição 1
own-mesh = a primeira face com quatro cantos ou mais, com cores nos vértices se houver
shown-by = Para mostrá-lo, use um polígono com quatro cantos ou mais cujas cores não estejam num mesmo plano.
law-by = a fórmula da linha de varredura; tolerância: os cantos se ajustam a 1/256 de pixel
law-measure = maior diferença em relação à fórmula em 72 rotações
largest-change-measure = maior mudança da cor no centro
mean-change-measure = mudança média da cor no centro
triangles-change-measure = triângulos: maior mudança da cor no centro
triangles-change-by = 0, pois coordenadas baricêntricas não mudam; tolerância: os cantos se ajustam a 1/256 de pixel
centre-effect = maior mudança da cor no centro numa rotação completa
centre-cure = triangulação
holds =
    para polígonos com quatro cantos ou mais cujas cores não estejam num mesmo plano. Triângulos não dependem da
    orientação, mas as cores de um polígono passam a depender de sua triangulação.
note-1 =
    Numa vista frontal, nenhum triângulo depende da orientação. Numa vista oblíqua, as cores dos triângulos precisam de
    interpolação correta em perspectiva (1/profundidade). Com interpolação afim, elas também mudam com a rotação, mas
    menos que com a interpolação por varredura.
note-2 =
    O algoritmo interpola ao longo das duas arestas que a linha de varredura cruza, e depois entre elas. Se o polígono
    gira, a linha que passa pelo centro cruza outras arestas em outros pontos.
note-3 =
    A animação (--animate) mostra a rotação. Com --interpolation affine ou perspective, ela mostra triângulos, e as
    cores não mudam.
note-4 =
    A divisão em triângulos cura isso, pois três cantos determinam um plano de cores. O resultado passa a depender da
    diagonal: o centro do losango tem a média dos dois cantos que a diagonal liga.
short-edges = não comparado: este polígono tem arestas menores que um pixel, que as linhas de varredura podem perder
exercise-by = exercício 1.6.25 b, resposta C
diagonal-by = média dos cantos que a diagonal liga
position-1 = posição 1
position-2 = posição 2
diagonal-13-cut = diagonal 1–3 (triângulos)
diagonal-24-cut = diagonal 2–4 (triângulos)
oblique-scanline-measure = vista oblíqua, mudança com uma rotação de 90°: varredura
oblique-scanline-by = a linha do canto 3 ao 1, depois a do 2 ao 4, interpolada pelas distâncias na imagem
oblique-triangles-measure = vista oblíqua, mudança com uma rotação de 90°: triângulos
oblique-triangles-by =
    s/2d da diferença entre os cantos 1 e 3, pois a aresta entre eles muda de profundidade em só uma das posições
oblique-perspective-measure = vista oblíqua, mudança com uma rotação de 90°: triângulos, corretos em perspectiva
oblique-perspective-by = 0, pois a interpolação por 1/profundidade segue o polígono
back-scanline-by =
    a fórmula da linha de varredura em cada pixel, 0 em triângulos; tolerância: os cantos se ajustam a 1/256 de pixel
seam-effect = maior mudança da cor de um pixel depois de uma rotação de 90° e da rotação inversa
diagonal-13-seen = As cores são as mesmas em qualquer orientação.
halves-title = varredura: 0° acima, 90° abaixo
halves-seen = As duas metades não combinam na emenda.
halves-triangles-title = triângulos: 0° acima, 90° abaixo
halves-triangles-caption = A mesma comparação com triângulos.
halves-triangles-seen = Não há emenda.
position-1-title = varredura, 0°
position-1-seen = Depois de uma rotação, o polígono tem outras cores.
turned-title = varredura, { $turn }°
turned-seen = As cores mudam com a rotação.
position-2-title = varredura, 90°
position-2-seen = O mesmo polígono tem outras cores.
difference-title = diferença, 90° e volta
difference-caption =
    Diferença entre o polígono sem rotação e o polígono desenhado a 90° e girado de volta. Escuro é 0, amarelo é
    { $full } da faixa total numa componente.
diagonals-title =
    { $shape ->
        [diamond] diferença das diagonais
       *[polygon] diferença da triangulação
    }
diagonals-caption = Diferença entre as duas triangulações. Amarelo é { $full } da faixa total numa componente.
r-scanline-curve = R, varredura
g-scanline-curve = G, varredura
b-scanline-curve = B, varredura
g-triangles-curve = G, triângulos
r-law-curve = R, fórmula
g-law-curve = G, fórmula
b-law-curve = B, fórmula
centre-title = Cor no centro numa rotação
centre-caption =
    Com o algoritmo de varredura, a cor no centro muda em até { $bad } numa rotação completa, como na fórmula. Com
    triângulos, ela muda em até { $cured }.
centre-x = rotação, graus
centre-y = componente linear
turned-scanline-measure = varredura: mudança da cor no centro com uma rotação de { $turn }°
turned-triangles-measure = triângulos: mudança da cor no centro com uma rotação de { $turn }°
turned-scanline-by = { law-by }
turned-triangles-by = { triangles-change-by }
largest-change-by = { law-by }
mean-change-by = { law-by }
seam-cure = { centre-cure }
back-scanline-measure = varredura: mudança depois de uma rotação de 90° e da rotação inversa (rms)
back-triangles-measure = triângulos: mudança depois de uma rotação de 90° e da rotação inversa (rms)
back-perspective-measure =
    triângulos, corretos em perspectiva: mudança depois de uma rotação de 90° e da rotação inversa (rms)
back-triangles-by = { back-scanline-by }
back-perspective-by = { back-scanline-by }
exercise-measure = { $case }: { $component } no centro
diagonal-measure = { exercise-measure }
diagonal-24-seen = { diagonal-13-seen }
halves-caption =
    Acima: o polígono sem rotação. Abaixo: o polígono desenhado a 90° e girado de volta.{ $shape ->
        [diamond] {" "}O canto 1 está à direita, o 2 acima, o 3 à esquerda (o mais claro), o 4 abaixo (oliva).
       *[polygon] {""}
    }
position-1-caption =
    { $shape ->
        [diamond] Posição 1: a linha de varredura pelo centro vai do canto 3 ao canto 1.
       *[polygon] Sem rotação: cada pixel é interpolado entre as duas arestas que sua linha encontra primeiro.
    }
turned-caption =
    { $shape ->
        [diamond] Girado de { $turn }°: a linha pelo centro cruza outras arestas, em outros pontos.
       *[polygon] Girado de { $turn }°: as linhas cruzam as arestas em outros pontos.
    }
position-2-caption =
    { $shape ->
        [diamond] Posição 2: a linha de varredura pelo centro vai do canto 2 ao canto 4.
       *[polygon] Girado de 90°: as linhas cruzam outras arestas.
    }
diagonal-13-title =
    { $shape ->
        [diamond] triângulos, diagonal 1–3
       *[polygon] primeira triangulação
    }
diagonal-13-caption =
    { $shape ->
        [diamond]
            Diagonal do canto 1 ao canto 3: o resultado das linhas de varredura na posição 1, cuja linha do meio é esta
            diagonal.
       *[polygon] O polígono dividido em triângulos.
    }
diagonal-24-title =
    { $shape ->
        [diamond] triângulos, diagonal 2–4
       *[polygon]
            { $cuts ->
                [one] mesma triangulação
               *[two] segunda triangulação
            }
    }
diagonal-24-caption =
    { $shape ->
        [diamond] Diagonal do canto 2 ao canto 4: o resultado das linhas de varredura na posição 2.
       *[polygon]
            { $cuts ->
                [one] Nenhuma outra triangulação cabe neste polígono; esta é a mesma.
               *[two] Outra triangulação do mesmo polígono.
            }
    }
