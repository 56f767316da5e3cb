title = O brilho perdido
claim =
    Se todos os vértices de um polígono estão mal iluminados, o sombreamento de Gouraud o mostra todo mal iluminado: um
    brilho no interior se perde. O sombreamento de Phong o encontra.
source-1 = Aulas: 1.6.7, 1.6.13, 1.6.15
source-2 = Ting 2008: “perda de pontos de brilho”
formula-1 = {"I_{\\max} = k_d \\cos(α) + k_s \\cos(α)^n"}
formula-1-says =
    tudo o que o sombreamento de Gouraud alcança, α o ângulo do brilho verdadeiro à normal do vértice mais próximo; aqui
    k_d = 0,4 e k_s = 0,6
formula-2 = {"F = 1 − k_d \\cos(Δ/2) − k_s \\cos(Δ/2)^n"}
formula-2-says = quanto cintila o brilho de uma esfera que gira: α vai de 0 a Δ/2 e volta, Δ = 2π/N
shown-by =
    um brilho de alguns pixels em facetas mais largas que ele (expoentes de 16 a 1000, numa imagem bastante grande) o
    mostraria.
untested-true-highlight-narrower = o brilho verdadeiro é mais estreito que um pixel
untested-not-held-against = não comparado com a lei: as facetas são pouco maiores que pixels
pixel-centre-up = o centro de um pixel fica a até 0,71 pixel do vértice
measure-plate-gouraud-peak = placa: pico de Gouraud sobre o de Phong
by-k-d-cos = k_d cos α + k_s cos(α)^n nos cantos, α = 35°; precisão simples, e o pico de Phong entre pixels
measure-sphere-gouraud-peak = esfera: pico de Gouraud sobre o verdadeiro, o brilho entre dois vértices
measure-sphere-turned-quarter = esfera girada de um quarto de segmento: deslocamento do pico
by-r-sin-nearest = R sin(Δ/4), até o vértice mais próximo; meia diagonal de pixel em cada pico
measure-gouraud-flicker-peak = Gouraud: cintilação do pico numa volta
measure-phong-flicker-peak = Phong: cintilação do pico numa volta
measure-gouraud-same-beyond = Gouraud: o mesmo, além da cintilação da luz difusa
moved = cintilação do pico do brilho, além da cintilação da luz difusa
moved-flicker-highlight-peak = cintilação do pico do brilho, até onde os pixels o contêm
cure = sombreamento de Phong
moved-highlight-missing-peak = o que falta do brilho no seu pico
moved-highlight-missing-peak-far = o que falta do brilho no seu pico, até onde os pixels o contêm
plate-gouraud-title = placa, Gouraud
plate-gouraud-caption-all-four-corners = Os quatro cantos da placa estão inclinados para longe da luz.
plate-gouraud-caption-whole-plate-evenly = A placa toda fica por igual opaca: o brilho no meio se perdeu.
plate-gouraud-caption-highlight-wide-they = O brilho é tão largo que eles têm muito dele: no meio ele fica embaçado, não perdido.
plate-phong-title = placa, Phong
plate-phong-caption-same-triangles-interpolated = Os mesmos dois triângulos: no meio as normais interpoladas olham para a luz.
plate-phong-caption-highlight = O brilho está lá.
sphere-gouraud-title = esfera, Gouraud
sphere-gouraud-caption-n-facets-round = N = { $from } facetas em volta, n = { $exponent }: o brilho cai entre dois vértices.
sphere-gouraud-caption-dull-bar-between = Uma barra fosca entre eles é tudo o que resta dele.
sphere-gouraud-caption-wider-facet-dulled = Ele é mais largo que uma faceta: embaçado, não perdido.
sphere-phong-title = esfera, Phong
sphere-phong-caption-same-sphere-phong = A mesma esfera com o sombreamento de Phong.
sphere-phong-caption-highlight-round-place = O brilho é redondo e está no lugar.
sphere-exact-title = a própria esfera
sphere-exact-caption-every-pixel-normal = Cada pixel com a normal da esfera verdadeira.
film-title = Gouraud acima, Phong abaixo
film-caption-highlight-close-while =
    O brilho visto de perto enquanto a esfera gira de um segmento, da esquerda para a direita, como na animação
    (--animate).
film-caption-gouraud-gets-dimmer = O de Gouraud escurece e volta, o de Phong fica.
film-caption-both-get-dimmer = Os dois escurecem e voltam.
note-gouraud-shading-mixes =
    O sombreamento de Gouraud mistura cores de vértices, e nenhuma mistura é mais clara que o vértice mais claro. Quando
    a esfera gira, os vértices passam um a um sob o brilho e ele pulsa, uma vez para cada. O de Phong mistura normais e
    ilumina cada pixel de novo.
chart-title = O brilho de uma esfera que gira
chart-caption =
    O pixel mais claro em função do giro: com Gouraud ele cai e sobe de novo a cada segmento, como diz a fórmula, que é
    do próprio vértice: os centros dos pixels ficam até meio pixel ao lado, e os seus máximos são um pouco mais baixos.
    Com Phong fica como está.
chart-caption-brightest-pixel-against = O pixel mais claro em função do giro, com Gouraud e com Phong, e a fórmula para Gouraud.
axis-turn-degrees = giro em graus
axis-peak-luminance = luminância do pico
closed-form-gouraud = fórmula, Gouraud
