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
law-by = a lei da linha de varredura; os cantos se ajustam a 1/256 de pixel
law-measure = maior distância da lei, em 72 giros
largest-change-measure = maior mudança da cor do centro
mean-change-measure = mudança média da cor do centro
triangles-change-measure = maior mudança, em triângulos
triangles-change-by = coordenadas baricêntricas não giram; os cantos se ajustam a 1/256 de pixel
centre-effect = maior mudança da cor do centro durante o giro
centre-cure = cortado em triângulos
holds =
    para polígonos de quatro cantos ou mais, cujas cores não são as de um plano. Triângulos não dependem de como são
    girados, mas as cores de um polígono passam a depender de como ele é cortado neles.
note-1 =
    Vistos de frente todos os triângulos são iguais. Em vista oblíqua as suas cores têm de ser misturadas por
    1/profundidade (perspectiva): misturadas por distâncias na imagem também mudam com o giro, menos que as da linha de
    varredura.
note-2 =
    O algoritmo interpola ao longo das duas arestas que a linha de varredura corta, e depois entre elas. Gire o
    polígono, e a linha pelo seu centro corta outras arestas em outros lugares.
note-3 =
    A animação (--animate) mostra o giro; --interpolation affine ou perspective o mostra em triângulos, onde nada muda
    senão o lugar.
note-4 =
    Triângulos curam isso: três cantos determinam um plano de cores. O preço é a escolha da diagonal: o centro do
    losango tem a média dos cantos que a diagonal liga.
short-edges = este polígono tem arestas menores que um pixel, que as linhas de varredura podem saltar
exercise-by = exercício 1.6.25 b, resposta C
diagonal-by = a média dos cantos que a diagonal liga
position-1 = posição 1
position-2 = posição 2
diagonal-13-cut = diagonal 1–3 (triângulos)
diagonal-24-cut = diagonal 2–4 (triângulos)
oblique-scanline-measure = em vista oblíqua, mudança por um quarto de volta: varredura
oblique-scanline-by = a linha do canto 3 ao 1, depois a do 2 ao 4, misturada por distâncias na imagem
oblique-triangles-measure = em vista oblíqua, mudança por um quarto de volta: triângulos
oblique-triangles-by = s/2d da diferença dos cantos 1 e 3: a aresta entre eles entra na profundidade numa posição só
oblique-perspective-measure = em vista oblíqua, mudança por um quarto de volta: triângulos com perspectiva
oblique-perspective-by = cores misturadas por 1/profundidade são do lugar no polígono
back-scanline-by = a lei da linha de varredura em cada pixel, 0 em triângulos; os cantos se ajustam a 1/256 de pixel
seam-effect = maior mudança da cor de um pixel por um quarto de volta, girado de volta
diagonal-13-seen = As mesmas cores como quer que seja girado.
halves-title = varredura: 0° acima, 90° abaixo
halves-seen = Se as cores fossem dele, não haveria emenda.
halves-triangles-title = triângulos: 0° acima, 90° abaixo
halves-triangles-caption = O mesmo em triângulos.
halves-triangles-seen = Não há emenda.
position-1-title = linha de varredura, 0°
position-1-seen = Girado ele tem outras cores.
turned-45-title = linha de varredura, 45°
turned-45-seen = As cores mudam com o giro.
position-2-title = linha de varredura, 90°
position-2-seen = O mesmo polígono tem outras cores.
difference-title = diferença, 90° girado de volta
difference-caption =
    Desenhado girado e girado de volta, menos como está: escuro é nenhuma, amarelo { $full } da faixa numa componente.
diagonals-title =
    { $shape ->
        [diamond] diferença das diagonais
       *[polygon] diferença dos cortes
    }
diagonals-caption = Um corte menos o outro: o que o corte decide. Amarelo é { $full } da faixa numa componente.
r-scanline-curve = R, linha de varredura
g-scanline-curve = G, linha de varredura
b-scanline-curve = B, linha de varredura
g-triangles-curve = G, triângulos
r-law-curve = R, a lei
g-law-curve = G, a lei
b-law-curve = B, a lei
centre-title = Cor do centro numa volta inteira
centre-caption =
    No algoritmo de linhas de varredura a cor do centro muda até { $bad } numa volta, como diz a lei; em triângulos até
    { $cured }.
centre-x = giro, graus
centre-y = componente linear
largest-change-by = { law-by }
mean-change-by = { law-by }
seam-cure = { centre-cure }
back-scanline-measure = linha de varredura: um quarto de volta, girado de volta (rms)
back-triangles-measure = triângulos: um quarto de volta, girado de volta (rms)
back-perspective-measure = triângulos com perspectiva: um quarto de volta, girado de volta (rms)
back-triangles-by = { back-scanline-by }
back-perspective-by = { back-scanline-by }
exercise-measure = { $case }: { $component } no centro
diagonal-measure = { exercise-measure }
diagonal-24-seen = { diagonal-13-seen }
halves-caption =
    Acima, o polígono como está; abaixo, desenhado girado de 90° e girado de volta.{ $shape ->
        [diamond] {" "}O canto 1 está à direita, o 2 acima, o 3 à esquerda (o mais claro), o 4 abaixo (oliva).
       *[polygon] {""}
    }
position-1-caption =
    { $shape ->
        [diamond] Posição 1: a linha de varredura pelo centro vai do canto 3 ao canto 1.
       *[polygon] Como está: cada pixel fica entre as duas arestas que a sua linha de varredura encontra primeiro.
    }
turned-45-caption =
    { $shape ->
        [diamond] Um oitavo de volta: a linha corta duas arestas nos seus meios, e o centro é a média de todos os cantos.
       *[polygon] Um oitavo de volta: as linhas encontram as arestas em outros lugares.
    }
position-2-caption =
    { $shape ->
        [diamond] Posição 2: a linha vai do canto 2 ao canto 4.
       *[polygon] Um quarto de volta: as linhas encontram outras arestas.
    }
diagonal-13-title =
    { $shape ->
        [diamond] triângulos, diagonal 1–3
       *[polygon] triângulos, um corte
    }
diagonal-13-caption =
    { $shape ->
        [diamond]
            Cortado do canto 1 ao canto 3: o que as linhas de varredura desenham na posição 1, cuja linha do meio é esta
            diagonal.
       *[polygon] Cortado de um modo.
    }
diagonal-24-title =
    { $shape ->
        [diamond] triângulos, diagonal 2–4
       *[polygon]
            { $cuts ->
                [one] triângulos, o mesmo corte
               *[two] triângulos, outro corte
            }
    }
diagonal-24-caption =
    { $shape ->
        [diamond] Cortado do canto 2 ao canto 4: o que as linhas de varredura desenham na posição 2.
       *[polygon]
            { $cuts ->
                [one] Nenhum outro corte fica dentro deste polígono: o mesmo mais uma vez.
               *[two] Cortado de outro modo.
            }
    }
