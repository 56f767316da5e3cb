title = Silhuetas poligonais
claim =
    O sombreamento interpolado faz as faces parecerem redondas, mas as silhuetas continuam marcadamente poligonais:
    normais não movem vértices.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47 (figura 56)
source-2 = Para a cura de malhas sem fórmula: A. Vlachos et al., Curved PN triangles, I3D 2001
formula-1 = {"e = R (1 − \\cos(π/n))"}
formula-1-says = quanto os meios dos lados de um n-ágono ficam para dentro do seu círculo de R pixels
formula-2 = {"\\frac{A}{A_0} = \\frac{n}{2π} \\sin(2π/n)"}
formula-2-says = a sua área sobre a do círculo
formula-3 = {"n_{1/2} = \\frac{π}{2 \\arcsin(1/(2 \\sqrt{R}))} ≈ π \\sqrt{R}"}
formula-3-says = o n a partir do qual e é menor que meio pixel
own-mesh = o seu contorno contra o de --finer ARQUIVO, ou o dela mesma em triângulos curvos
shown-by = menos segmentos, uma imagem maior ou uma malha mais grosseira o mostrariam.
ball = bola
measure-ball-mean-distance = bola: distância média dos contornos
by-mean-e-over = a média de e sobre o polígono e sobre o círculo; um terço dos pixels dos próprios contornos de cada um
measure-ball-fewest-segments =
    bola: menor número de segmentos cujo contorno erra no máximo meio pixel a mais que o de uma bola muito fina
by-arcsin-r-found =
    π/(2 arcsin(1/(2√R))), achado por bissecção em imagens, cujos próprios pixels impedem até o contorno de um círculo
    de estar certo; o que as distâncias deixam em aberto além disso, em segmentos
torus = toro
measure-flat-shading-against = sombreamento plano contra o de Phong: distância dos contornos
by-shading-does-not = o sombreamento não move arestas
moved = maior distância do contorno
why-half-pixel-outlines = meio pixel, e o que contornos de pixels deixam em aberto
cure = { $fine } segmentos
note-vertices-ball-own =
    Os vértices têm as normais da própria bola, e a luz corre sobre as faces como sobre uma bola. Mas a imagem acaba
    onde as faces acabam, e o olho olha primeiro os contornos.
note-near-outline-faces =
    Perto do contorno as faces são vistas de lado: ali têm poucos pixels de largura, e cada uma é um lado do polígono.
    Por isso vale mais refinar a malha onde ela se vira para longe do observador.
by-r-cos-n = R (1 − cos(π/n)); um terço dos pixels dos próprios contornos de cada um
by-n-sin-n = n/(2π) sin(2π/n); o comprimento do contorno vezes o que as distâncias deixam em aberto
chart-title = Erro do contorno
chart-caption =
    Quanto o contorno da bola se afasta do círculo em função do número de segmentos: a maior distância e a média caem
    como 1/n², como dizem as fórmulas, até que só restem os pixels dos próprios contornos.
axis-segments-n = segmentos n
axis-distance-pixels = distância em pixels
largest = maior
mean = média
largest-closed-form = maior, fórmula
mean-closed-form = média, fórmula
ball-title = O sombreamento de Phong com as normais da própria bola: por dentro tudo é redondo.
ball-caption-outline-polygon = O contorno é um polígono.
lacking-title = o que falta
lacking-caption-yellow-ball-covers =
    Amarelo onde a bola cobre a imagem e os polígonos não: uma lua fina sobre cada lado, tanto mais fina quanto mais
    lados há.
ball-fine-title =
    Ao menos o dobro de segmentos de antes, e bastantes para um erro abaixo de { $left } px pela fórmula; o que se mede
    pode ser até { $open } px maior, pois contornos são feitos de pixels.
ball-fine-caption-outline-round-eye = O contorno é redondo para o olho.
ball-itself-title = a própria bola
ball-itself-caption-ball-equation-without = A bola pela sua equação, sem faces.
torus-title = Um toro visto ao longo do eixo.
torus-caption-outside-inside-outline = Por fora como por dentro o contorno é um polígono.
torus-fine-title = O toro com tantos segmentos quanto a bola mais fina.
torus-fine-caption-round-eye = É redondo para o olho.
curved-triangles-leave =
    Triângulos curvos deixam os vértices da malha onde estão. Se esta é a malha de controle de uma superfície de
    subdivisão, eles não estão nessa superfície, e nenhuma curva por eles é o seu contorno: o que ajuda é subdividi-la,
    ou mover os vértices para onde a subdivisão os leva.
holds-outline-mesh-off = o contorno desta malha erra mais de meio pixel aqui.
absent-meshes-same-outline =
    as duas malhas têm o mesmo contorno neste tamanho: uma imagem maior (--size) ou uma malha mais fina em --finer
    mostraria mais.
own-title = a malha
own-caption-mesh-phong-shading = A malha como ela é, com o sombreamento de Phong.
own-caption-outline-off = O seu contorno erra.
lacking-title-between-outlines = entre os contornos
lacking-caption-yellow-only-covers = Amarelo onde só uma das duas cobre a imagem, a malha ou a mais fina.
lacking-caption-yellow-only-covers-picture =
    Amarelo onde só uma das duas cobre a imagem, a malha ou os seus próprios triângulos curvos.
own-curved-title = triângulos curvos
own-curved-caption-same-mesh-curved = A mesma malha em triângulos curvos que as suas normais determinam.
own-curved-caption-outline-comes-closer = O seu contorno se aproxima.
finer-title = a malha mais fina
finer-caption-held-against = aquilo com que é comparada
finer-caption-outlines-held-against = Aquilo com que os contornos são comparados.
no-finer-mesh =
    não foi dada malha mais fina, e em triângulos curvos o contorno é o mesmo: indique uma com --finer ARQUIVO, ou uma
    imagem maior (--size).
held-against-finer = Ela é comparada com a malha mais fina `{ $finer }`.
no-finer-mesh-given =
    Não foi dada malha mais fina, e ela é comparada consigo mesma em triângulos curvos, cada aresta cortada em
    { $parts }: triângulos de Bézier de terceira ordem que saem dos vértices em ângulo reto com as normais (curved PN
    triangles), e nos vincos em ângulo reto com as normais dos dois lados. Aquilo que ela representa pode ter outra
    forma; --finer ARQUIVO a indica.
