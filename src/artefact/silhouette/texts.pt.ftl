title = A tonalização interpolada mantém os contornos poligonais
claim =
    A tonalização interpolada faz as faces parecerem curvas, mas a silhueta continua um polígono visível. Normais
    interpoladas não movem vértices.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47 (figura 56)
source-2 = Cura para malhas sem fórmula: A. Vlachos et al., Curved PN triangles, I3D 2001
formula-1 = {"e = R (1 − \\cos(π/n))"}
formula-1-says = distância do meio de um lado do n-ágono regular ao seu círculo; R é o raio em pixels
formula-2 = {"\\frac{A}{A_0} = \\frac{n}{2π} \\sin(2π/n)"}
formula-2-says = área do n-ágono dividida pela área do círculo
formula-3 = {"n_{1/2} = \\frac{π}{2 \\arcsin(1/(2 \\sqrt{R}))} ≈ π \\sqrt{R}"}
formula-3-says = número de segmentos n acima do qual e é menor que meio pixel
own-mesh = o contorno, comparado com o de --finer ARQUIVO ou com o de seus próprios triângulos curvos
shown-by = Use menos segmentos, uma imagem maior ou uma malha mais grosseira para mostrá-lo.
ball = esfera
mean-distance-measure = esfera: distância média entre os contornos
mean-distance-by =
    média de e sobre o polígono e sobre o círculo; tolerância: um terço de um pixel do contorno para cada contorno
fewest-segments-measure =
    esfera: menor número de segmentos cujo erro de contorno excede o de uma esfera muito fina em no máximo meio pixel
fewest-segments-by =
    π/(2 arcsin(1/(2√R))), encontrado por bissecção em imagens. Os pixels por si sós já dão um erro de contorno até a um
    círculo; por isso, a base é uma esfera muito fina. Tolerância: os pixels do contorno, convertidos em segmentos
torus = toro
flat-shading-measure = tonalização plana comparada com a de Phong: distância entre os contornos
flat-shading-by = a tonalização não move arestas
outline-effect = maior distância do contorno
why-half-pixel-of-outlines = meio pixel, mais a tolerância dos contornos
outline-cure = { $fine } segmentos
note-1 =
    Os vértices têm as normais da esfera exata, e por isso a tonalização dentro do contorno parece curva. A imagem da
    esfera, porém, termina onde as faces terminam. O olho nota primeiro o contorno.
note-2 =
    Perto do contorno, as faces são vistas em ângulo rasante e têm poucos pixels de largura. Cada uma delas é um lado do
    polígono. Refine a malha primeiro onde ela vira de costas para o observador.
distance-by = R (1 − cos(π/n)); tolerância: um terço de um pixel do contorno para cada contorno
area-by = n/(2π) sin(2π/n); tolerância: o comprimento do contorno vezes a tolerância das distâncias
error-by-segments-title = Erro do contorno
error-by-segments-caption =
    Distância do contorno da esfera ao círculo em função do número de segmentos. A maior distância e a média caem com
    1/n², como nas fórmulas. Com muitos segmentos, só resta o erro dos pixels do contorno.
error-by-segments-x = segmentos n
error-by-segments-y = distância em pixels
largest-curve = maior
mean-curve = média
largest-law-curve = maior, fórmula
mean-law-curve = média, fórmula
ball-caption = Tonalização de Phong com as normais da esfera exata: o interior parece liso.
ball-seen = O contorno é um polígono.
ball-fine-caption =
    Ao menos o dobro de segmentos, suficientes para um erro abaixo de { $left } px pela fórmula. O erro medido pode ser
    até { $open } px maior, pois contornos são feitos de pixels.
ball-fine-seen = O contorno parece redondo.
ball-itself-title = esfera exata
ball-itself-caption = A esfera desenhada a partir da sua equação, sem faces.
torus-caption = Um toro visto ao longo do eixo.
torus-seen = O contorno externo e o interno são polígonos.
torus-fine-caption = O toro com tantos segmentos quanto a esfera mais fina.
torus-fine-seen = Os dois contornos parecem redondos.
control-mesh =
    Triângulos curvos mantêm os vértices da malha. Os vértices de uma malha de controle de uma superfície de subdivisão
    não estão nessa superfície. Nesse caso, subdivida a malha ou mova seus vértices para a superfície de subdivisão.
same-outlines =
    As duas malhas têm o mesmo contorno neste tamanho. Use uma imagem maior (--size) ou uma malha mais fina em --finer.
own-title = malha
own-caption = A malha com tonalização de Phong.
own-seen = O contorno difere da referência.
own-curved-title = triângulos curvos
own-curved-caption = A mesma malha como triângulos curvos obtidos de suas normais.
own-curved-seen = O contorno fica mais perto da referência.
finer-caption = A referência para os contornos.
no-finer-mesh =
    Sem malha mais fina, a referência são triângulos curvos, e o contorno deles é o mesmo. Indique uma malha mais fina
    com --finer ARQUIVO, ou uma imagem maior (--size).
distance-measure = { $surface }, { $segments } segmentos: maior distância do contorno
distance-fine-measure = { $surface }, { $fine } segmentos: maior distância do contorno
distance-fine-by = { distance-by }
area-measure = { $surface }, { $segments } segmentos: área dividida pela verdadeira
ball-title = esfera, { $segments } segmentos
ball-fine-title = esfera, { $fine } segmentos
torus-title = toro, { $segments } segmentos
torus-fine-title = toro, { $fine } segmentos
own-effect = { outline-effect }
own-cure = triângulos curvos, cada aresta dividida em { $cure-parts }
own-distance-measure = maior distância do contorno
own-mean-distance-measure = distância média do contorno
own-area-measure = área dividida pela área da referência
curved-distance-measure = triângulos curvos: maior distância do contorno
curved-mean-distance-measure = triângulos curvos: distância média do contorno
shorter-edges-measure = fator pelo qual as arestas devem ser encurtadas para um erro de meio pixel
holds =
    com qualquer tonalização; só mais faces ajudam. O erro cai com 1/n². Para meio pixel, esta esfera, com raio de
    { $radius } pixels, precisa de { $enough } segmentos; um raio de 200 pixels precisa de 45. Os erros medidos podem
    ser até { $open } px maiores, pois contornos são feitos de pixels.
no-finer-mesh-sharp-edges =
    Sem malha mais fina, a referência são triângulos curvos. Neles { $sharp-edges } arestas ficam vivas, pois seu ângulo
    diedro excede { $crease }°. Se essas arestas pertencem a uma forma curva, alise-as com --crease 180. Para comparar
    com a forma verdadeira, use --finer ARQUIVO.
own-holds = o contorno desta malha difere em mais de meio pixel aqui. { compared-with }
lacking-title =
    { $compared ->
        [ball] área que falta
       *[other] entre os contornos
    }
lacking-caption =
    { $compared ->
        [ball]
            Amarelo onde a esfera cobre a imagem e os polígonos não. Há um crescente em cada lado do polígono; com mais
            lados ele é mais fino.
        [finer] Amarelo onde só a malha ou só a malha mais fina cobre a imagem.
       *[itself] Amarelo onde só a malha ou só seus triângulos curvos cobrem a imagem.
    }
finer-title =
    { $compared ->
        [finer] malha mais fina
       *[itself] forma de referência
    }
compared-with =
    { $compared ->
        [finer] A referência é a malha mais fina `{ $finer }`.
       *[itself]
            A referência é a malha como triângulos curvos, com cada aresta dividida em { $parts }. São triângulos de
            Bézier cúbicos (curved PN triangles): em cada vértice são perpendiculares à normal dele e, nos vincos, às
            normais dos dois lados. A forma verdadeira pode ser outra; indique-a com --finer ARQUIVO.
    }
