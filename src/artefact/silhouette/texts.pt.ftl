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
mean-distance-measure = bola: distância média dos contornos
mean-distance-by =
    a média de e sobre o polígono e sobre o círculo; um terço dos pixels dos próprios contornos de cada um
fewest-segments-measure =
    bola: menor número de segmentos cujo contorno erra no máximo meio pixel a mais que o de uma bola muito fina
fewest-segments-by =
    π/(2 arcsin(1/(2√R))), achado por bissecção em imagens, cujos próprios pixels impedem até o contorno de um círculo
    de estar certo; o que as distâncias deixam em aberto além disso, em segmentos
torus = toro
flat-shading-measure = sombreamento plano contra o de Phong: distância dos contornos
flat-shading-by = o sombreamento não move arestas
outline-effect = maior distância do contorno
why-half-pixel-of-outlines = meio pixel, e o que contornos de pixels deixam em aberto
outline-cure = { $fine } segmentos
note-1 =
    Os vértices têm as normais da própria bola, e a luz corre sobre as faces como sobre uma bola. Mas a imagem acaba
    onde as faces acabam, e o olho olha primeiro os contornos.
note-2 =
    Perto do contorno as faces são vistas de lado: ali têm poucos pixels de largura, e cada uma é um lado do polígono.
    Por isso vale mais refinar a malha onde ela se vira para longe do observador.
distance-by = R (1 − cos(π/n)); um terço dos pixels dos próprios contornos de cada um
area-by = n/(2π) sin(2π/n); o comprimento do contorno vezes o que as distâncias deixam em aberto
error-by-segments-title = Erro do contorno
error-by-segments-caption =
    Quanto o contorno da bola se afasta do círculo em função do número de segmentos: a maior distância e a média caem
    como 1/n², como dizem as fórmulas, até que só restem os pixels dos próprios contornos.
error-by-segments-x = segmentos n
error-by-segments-y = distância em pixels
largest-curve = maior
mean-curve = média
largest-law-curve = maior, fórmula
mean-law-curve = média, fórmula
ball-caption = O sombreamento de Phong com as normais da própria bola: por dentro tudo é redondo.
ball-seen = O contorno é um polígono.
ball-fine-caption =
    Ao menos o dobro de segmentos de antes, e bastantes para um erro abaixo de { $left } px pela fórmula; o que se mede
    pode ser até { $open } px maior, pois contornos são feitos de pixels.
ball-fine-seen = O contorno é redondo para o olho.
ball-itself-title = a própria bola
ball-itself-caption = A bola pela sua equação, sem faces.
torus-caption = Um toro visto ao longo do eixo.
torus-seen = Por fora como por dentro o contorno é um polígono.
torus-fine-caption = O toro com tantos segmentos quanto a bola mais fina.
torus-fine-seen = É redondo para o olho.
control-mesh =
    Triângulos curvos deixam os vértices da malha onde estão. Se esta é a malha de controle de uma superfície de
    subdivisão, eles não estão nessa superfície, e nenhuma curva por eles é o seu contorno: o que ajuda é subdividi-la,
    ou mover os vértices para onde a subdivisão os leva.
same-outlines =
    as duas malhas têm o mesmo contorno neste tamanho: uma imagem maior (--size) ou uma malha mais fina em --finer
    mostraria mais.
own-title = a malha
own-caption = A malha como ela é, com o sombreamento de Phong.
own-seen = O seu contorno erra.
own-curved-title = triângulos curvos
own-curved-caption = A mesma malha em triângulos curvos que as suas normais determinam.
own-curved-seen = O seu contorno se aproxima.
finer-caption = Aquilo com que os contornos são comparados.
no-finer-mesh =
    não foi dada malha mais fina, e em triângulos curvos o contorno é o mesmo: indique uma com --finer ARQUIVO, ou uma
    imagem maior (--size).
distance-measure = { $surface }, { $segments } segmentos: maior distância do contorno
distance-fine-measure = { $surface }, { $fine } segmentos: maior distância do contorno
distance-fine-by = { distance-by }
area-measure = { $surface }, { $segments } segmentos: área sobre a verdadeira
ball-title = bola, { $segments } segmentos
ball-fine-title = bola, { $fine } segmentos
torus-title = toro, { $segments } segmentos
torus-fine-title = toro, { $fine } segmentos
own-effect = { outline-effect }
own-cure = triângulos curvos, cada aresta cortada em { $cure-parts }
own-distance-measure = maior distância do contorno
own-mean-distance-measure = distância média do contorno
own-area-measure = área sobre a da forma com que é comparada
curved-distance-measure = triângulos curvos: maior distância do contorno
curved-mean-distance-measure = triângulos curvos: distância média do contorno
shorter-edges-measure = as arestas teriam de ser tantas vezes mais curtas para meio pixel
holds =
    seja qual for o sombreamento; só mais faces ajudam. O erro cai como 1/n². Para meio pixel esta bola de raio de {
    $radius } pixels precisa de { $enough } segmentos, uma de 200 pixels de 45; contornos em imagens são feitos de
    pixels, e por isso se medem até { $open } px a mais.
no-finer-mesh-sharp-edges =
    não foi dada malha mais fina, e { $sharp-edges } arestas ficam vivas nos triângulos curvos com que esta é comparada,
    porque o seu ângulo passa de { $crease }°. Se representam algo redondo, --crease 180 as alisa; --finer ARQUIVO
    indica a forma verdadeira.
own-holds = o contorno desta malha erra mais de meio pixel aqui. { compared-with }
lacking-title =
    { $compared ->
        [ball] o que falta
       *[other] entre os contornos
    }
lacking-caption =
    { $compared ->
        [ball]
            Amarelo onde a bola cobre a imagem e os polígonos não: uma lua fina sobre cada lado, tanto mais fina quanto
            mais lados há.
        [finer] Amarelo onde só uma das duas cobre a imagem, a malha ou a mais fina.
       *[itself] Amarelo onde só uma das duas cobre a imagem, a malha ou os seus próprios triângulos curvos.
    }
finer-title =
    { $compared ->
        [finer] a malha mais fina
       *[itself] a forma com que é comparada
    }
compared-with =
    { $compared ->
        [finer] Ela é comparada com a malha mais fina `{ $finer }`.
       *[itself]
            Não foi dada malha mais fina, e ela é comparada consigo mesma em triângulos curvos, cada aresta cortada em
            { $parts }: triângulos de Bézier de terceira ordem que saem dos vértices em ângulo reto com as normais
            (curved PN triangles), e nos vincos em ângulo reto com as normais dos dois lados. Aquilo que ela representa
            pode ter outra forma; --finer ARQUIVO a indica.
    }
