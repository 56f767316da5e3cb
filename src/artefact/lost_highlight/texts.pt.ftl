title = A tonalização de Gouraud perde brilhos entre vértices
claim =
    Se um brilho está no interior de um polígono e nenhum vértice está dentro do brilho, a tonalização de Gouraud o
    perde. A tonalização de Phong o mostra.
source-1 = Aulas: 1.6.7, 1.6.13, 1.6.15
source-2 = Ting 2008: “perda de pontos de brilho”
formula-1 = {"I_{\\max} = k_d \\cos(α) + k_s \\cos(α)^n"}
formula-1-says =
    maior luminância da tonalização de Gouraud; α é o ângulo entre o brilho verdadeiro e a normal do vértice mais
    próximo. Aqui k_d = 0,4 e k_s = 0,6
formula-2 = {"F = 1 − k_d \\cos(Δ/2) − k_s \\cos(Δ/2)^n"}
formula-2-says = cintilação do brilho numa esfera que gira: α vai de 0 a Δ/2 e volta, com Δ = 2π/N
shown-by =
    Para mostrá-lo, use um brilho de alguns pixels em facetas mais largas que ele (expoentes de 16 a 1000, uma imagem
    grande).
highlight-below-pixel = não comparado: o brilho verdadeiro é mais estreito que um pixel
facets-below-pixels = não comparado com a fórmula: as facetas são pouco maiores que pixels
sphere-by =
    luminância dada pela fórmula no vértice mais próximo; tolerância: o centro de um pixel fica a até 0,71 pixel do
    vértice
plate-measure = placa: razão entre o pico de Gouraud e o de Phong
plate-by =
    k_d cos α + k_s cos(α)^n nos cantos, α = 35°; tolerância: precisão simples, e o pico de Phong fica entre pixels
sphere-measure = esfera, brilho entre dois vértices: razão entre o pico de Gouraud e o verdadeiro
displacement-measure = esfera girada um quarto de segmento: deslocamento do pico
displacement-by = R sin(Δ/4), a distância ao vértice mais próximo; tolerância: meia diagonal de pixel em cada pico
flicker-gouraud-measure = Gouraud: cintilação do pico durante uma rotação
flicker-phong-measure = Phong: cintilação do pico durante uma rotação
flicker-beyond-diffuse-measure = Gouraud: cintilação do pico além da cintilação da reflexão difusa
flicker-cure = tonalização de Phong
missing-effect = perda do brilho no pico, na medida em que os pixels o resolvem
plate-gouraud-title = placa, Gouraud
plate-gouraud-caption = As normais nos quatro cantos da placa apontam para longe da luz.
plate-phong-title = placa, Phong
plate-phong-caption = Os mesmos dois triângulos: no meio, as normais interpoladas apontam para a luz.
plate-phong-seen = O brilho é visível.
sphere-gouraud-title = esfera, Gouraud
sphere-gouraud-caption =
    N = { $segments } facetas em volta da esfera, n = { $exponent }; o brilho cai entre dois vértices.
sphere-phong-title = esfera, Phong
sphere-phong-caption = A mesma esfera com tonalização de Phong.
sphere-phong-seen = O brilho é redondo e está na posição certa.
sphere-exact-title = esfera exata
sphere-exact-caption = A esfera com a normal exata em cada pixel.
film-title = Gouraud acima, Phong abaixo
film-caption =
    O brilho visto de perto enquanto a esfera gira um segmento, da esquerda para a direita. A animação (--animate)
    mostra o mesmo.
note-1 =
    A tonalização de Gouraud interpola as cores dos vértices, e por isso nenhum ponto é mais claro que o vértice mais
    claro. Enquanto a esfera gira, os vértices passam um a um sob o brilho, que pulsa uma vez para cada um. A
    tonalização de Phong interpola normais e calcula a luz em cada pixel.
flicker-title = O brilho de uma esfera que gira
flicker-caption =
    { $is-cured ->
        [yes]
            Luminância do pixel mais claro em função da rotação. Na tonalização de Gouraud, ela cai e sobe a cada
            segmento, um pouco abaixo da fórmula, pois os centros dos pixels ficam a até meio pixel do vértice. Na de
            Phong, ela é constante.
       *[no]
            Luminância do pixel mais claro em função da rotação, nas tonalizações de Gouraud e de Phong, e a fórmula
            para Gouraud.
    }
flicker-x = rotação em graus
flicker-y = luminância do pico
law-curve = fórmula, Gouraud
flicker-gouraud-by = { sphere-by }
missing-cure = { flicker-cure }
flicker-effect =
    cintilação do pico do brilho além da cintilação da reflexão difusa, na medida em que os pixels a resolvem
plate-gouraud-seen = A placa toda é mais escura que o brilho que deveria aparecer no meio dela.
sphere-gouraud-seen = Entre esses vértices, a esfera é mais escura que o brilho.
film-seen = Na fileira de cima, o brilho escurece e volta.
gouraud-curve = Gouraud
phong-curve = Phong
holds =
    se o brilho for mais estreito que o ângulo entre ele e a normal do vértice mais próximo. Com N facetas em volta da
    esfera, isso exige expoentes a partir de cerca de (N/π)², aqui { $least }. Enquanto a esfera gira, o brilho cintila.
holds-only-if =
    o brilho for mais estreito que o ângulo entre ele e a normal do vértice mais próximo. Com N = { $segments } facetas
    em volta desta esfera, isso exige expoentes a partir de cerca de (N/π)² = { $least }. Com o expoente { $exponent },
    o brilho é mais largo que uma faceta: ele escurece, mas não se perde.
