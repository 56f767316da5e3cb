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
highlight-below-pixel = o brilho verdadeiro é mais estreito que um pixel
facets-below-pixels = não comparado com a lei: as facetas são pouco maiores que pixels
sphere-by = o centro de um pixel fica a até 0,71 pixel do vértice
plate-measure = placa: pico de Gouraud sobre o de Phong
plate-by = k_d cos α + k_s cos(α)^n nos cantos, α = 35°; precisão simples, e o pico de Phong entre pixels
sphere-measure = esfera: pico de Gouraud sobre o verdadeiro, o brilho entre dois vértices
displacement-measure = esfera girada de um quarto de segmento: deslocamento do pico
displacement-by = R sin(Δ/4), até o vértice mais próximo; meia diagonal de pixel em cada pico
flicker-gouraud-measure = Gouraud: cintilação do pico numa volta
flicker-phong-measure = Phong: cintilação do pico numa volta
flicker-beyond-diffuse-measure = Gouraud: o mesmo, além da cintilação da luz difusa
flicker-cure = sombreamento de Phong
missing-effect = o que falta do brilho no seu pico, até onde os pixels o contêm
plate-gouraud-title = placa, Gouraud
plate-gouraud-caption = Os quatro cantos da placa estão inclinados para longe da luz.
plate-phong-title = placa, Phong
plate-phong-caption = Os mesmos dois triângulos: no meio as normais interpoladas olham para a luz.
plate-phong-seen = O brilho está lá.
sphere-gouraud-title = esfera, Gouraud
sphere-gouraud-caption = N = { $segments } facetas em volta, n = { $exponent }: o brilho cai entre dois vértices.
sphere-phong-title = esfera, Phong
sphere-phong-caption = A mesma esfera com o sombreamento de Phong.
sphere-phong-seen = O brilho é redondo e está no lugar.
sphere-exact-title = a própria esfera
sphere-exact-caption = Cada pixel com a normal da esfera verdadeira.
film-title = Gouraud acima, Phong abaixo
film-caption =
    O brilho visto de perto enquanto a esfera gira de um segmento, da esquerda para a direita, como na animação
    (--animate).
note-1 =
    O sombreamento de Gouraud mistura cores de vértices, e nenhuma mistura é mais clara que o vértice mais claro. Quando
    a esfera gira, os vértices passam um a um sob o brilho e ele pulsa, uma vez para cada. O de Phong mistura normais e
    ilumina cada pixel de novo.
flicker-title = O brilho de uma esfera que gira
flicker-caption =
    { $is-cured ->
        [yes]
            O pixel mais claro em função do giro: com Gouraud ele cai e sobe de novo a cada segmento, como diz a
            fórmula, que é do próprio vértice: os centros dos pixels ficam até meio pixel ao lado, e os seus máximos são
            um pouco mais baixos. Com Phong fica como está.
       *[no] O pixel mais claro em função do giro, com Gouraud e com Phong, e a fórmula para Gouraud.
    }
flicker-x = giro em graus
flicker-y = luminância do pico
law-curve = fórmula, Gouraud
flicker-gouraud-by = { sphere-by }
missing-cure = { flicker-cure }
flicker-effect = cintilação do pico do brilho, além da da luz difusa, até onde os pixels a resolvem
plate-gouraud-seen = A placa toda é mais apagada do que seria o brilho no seu meio.
sphere-gouraud-seen = Entre eles a esfera é mais apagada que o seu brilho.
film-seen = Na fileira de cima ele escurece e volta.
gouraud-curve = Gouraud
phong-curve = Phong
holds =
    sempre que a normal do vértice mais próximo está mais longe do brilho do que o brilho é largo: com N facetas em
    volta da esfera, para expoentes a partir de cerca de (N/π)², aqui { $least }. Girando, o brilho cintila.
holds-only-if =
    a normal do vértice mais próximo está mais longe do brilho do que o brilho é largo. Nesta esfera de N = { $segments
    } facetas em volta, isso pede expoentes a partir de cerca de (N/π)² = { $least }; com { $exponent } o brilho é mais
    largo que uma faceta: apagado, não perdido.
