title = Normais médias alisam arestas vivas
claim =
    As normais dos vértices são médias das normais das faces, e por isso alisam arestas que deveriam ser vivas. No pior
    caso todas as médias são paralelas, e um zigue-zague parece plano. As tonalizações de Gouraud e de Phong têm esse
    erro.
source-1 = Aulas: 1.6.4 (figura 41), 1.6.13 (figura 44), 1.6.15, 1.6.47
source-2 = Cura nas aulas: não interpolar. Cura comum desde então: separar os vértices nas arestas vivas
formula-1 = {"δ_\\mathrm{cubo} = \\arctan(\\sqrt{2}) = 54{,}7356°"}
formula-1-says = ângulo entre uma face do cubo e a normal média das três faces no seu vértice
formula-2 = {"δ_\\mathrm{zigue} = s, \\quad δ_\\mathrm{telhado} = s/2"}
formula-2-says = zigue-zague: faixas inclinadas de s para os dois lados; telhado: uma faixa inclinada de s, a outra não
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{média} = 1"}
formula-3-says = luminância do zigue-zague sob luz frontal, com as normais das faces e com as normais médias
own-mesh = as suas normais médias sobre todas as arestas, comparadas com normais separadas nos vincos
shown-by = Use faces que se encontram com mais que o ângulo de vinco, e luz do lado do observador, para mostrá-lo.
shape-cube = cubo
shape-zigzag = zigue-zague
shape-roof = telhado
front-averaged-measure = zigue-zague, luz frontal, normais médias: luminância
front-faces-measure = zigue-zague, luz frontal, normais das faces: luminância
gear-share-measure = engrenagem: parcela dos cantos cuja normal média difere em mais de { $crease }° da normal da face
gear-averaged-measure = engrenagem, média: erro médio das normais dos pixels
gear-split-measure = engrenagem, separada: erro médio das normais dos pixels
gear-effect = engrenagem: erro médio das normais dos pixels
holds =
    se faces que partilham um vértice não formam uma só superfície lisa. Em superfícies lisas as mesmas médias são
    corretas, e por isso um ângulo de vinco, arestas marcadas ou grupos de alisamento devem separar os dois casos. Faces
    mais finas estreitam a faixa alisada junto a uma aresta viva, mas não corrigem as normais na aresta.
note-1 =
    No zigue-zague, cada vértice tem uma face inclinada para a esquerda e outra inclinada do mesmo ângulo para a
    direita. Por isso toda normal média aponta para a frente. Com qualquer luz e qualquer modelo de reflexão, o
    zigue-zague parece uma chapa plana.
note-2 =
    A separação dá a cada lado de uma aresta viva a sua própria normal. O ângulo de vinco deve ficar entre os ângulos
    diedros das arestas vivas e os das superfícies curvas, como o furo da engrenagem. O gráfico mostra esse intervalo
    como um patamar.
front-averaged-by = N·L com L = (0, 0, 1); tolerância: precisão simples
gear-bore-measure = engrenagem, separada: maior ângulo entre a normal de um canto e a da face
gear-bore-by = metade do ângulo entre facetas do furo, que continua liso
error-by-crease-angle-title = A engrenagem por ângulo de vinco
error-by-crease-angle-caption =
    Ângulo médio entre as normais dos cantos e as das faces. Abaixo de 7,5° nada é alisado; no patamar só o furo é
    alisado. Acima do patamar os dentes, e por fim os lados, são alisados falsamente.
error-by-crease-angle-x = ângulo de vinco, graus
error-by-crease-angle-y = ângulo médio, graus
gear-curve = cantos da engrenagem
own-effect = maior ângulo entre a normal de um canto e a da face
why-crease-angle = o ângulo de vinco; ângulos menores podem ser de uma superfície curva
own-holds = esta malha tem cantos cuja normal média difere da normal da face em mais que o ângulo de vinco.
own-caption = Normais médias sobre todas as arestas.
own-seen = Arestas vivas também são alisadas.
own-split-caption = Os vértices são separados onde o ângulo diedro excede o ângulo de vinco.
own-split-seen = Essas arestas são vivas.
own-note =
    Em superfícies curvas, as normais das faces também diferem das médias: por metade do ângulo entre faces vizinhas. Só
    diferenças maiores são erros.
pixels-effect = erro médio das normais dos pixels
gear-caption = Uma engrenagem com uma normal por vértice.
gear-seen = Os dentes parecem inflados, e a tonalização continua através de cada aresta.
gear-split-caption = A engrenagem, separada pelo ângulo de vinco.
cube-caption = Um cubo com oito vértices e oito normais.
cube-seen = Ele parece uma almofada.
cube-split-caption = O cubo, separado pelo ângulo de vinco.
cube-split-seen = Cada face tem uma só luminância.
zigzag-caption = Faixas inclinadas 45° para a esquerda e para a direita.
zigzag-seen = Todas as normais médias são paralelas: só o contorno mostra a forma.
zigzag-split-caption = A mesma chapa sob a mesma luz, separada pelo ângulo de vinco.
zigzag-split-seen = Cada faixa tem a sua própria normal.
roof-caption = Um telhado trapezoidal de faixas planas.
roof-seen = As normais médias fazem o telhado parecer ondulado.
roof-split-caption = O telhado, separado pelo ângulo de vinco.
roof-split-seen = As faixas são uniformes, com arestas vivas.
gear-light-caption = Erro da reflexão difusa (Lambert): violeta 0, amarelo metade da faixa ou mais.
front-faces-by = { front-averaged-by }
averaged-measure = { $shape }, média: maior ângulo entre a normal de um canto e a da face
averaged-by = ângulo entre a normal média e a de uma face; tolerância: poucos arredondamentos
split-measure = { $shape }, separado: maior ângulo entre a normal de um canto e a da face
split-by = 0 se o ângulo de vinco é menor que o ângulo diedro
pixels-cure = vértices separados em arestas acima de { $crease }°
own-cure = { pixels-cure }
gear-split-seen = Dentes e lados são planos.
gear-title = engrenagem, média
gear-split-title = engrenagem, separada
gear-angles-title = engrenagem, ângulo
gear-angles-caption = Ângulo entre a normal média e a da face: violeta 0°, amarelo { $full-angle }° ou mais.
gear-light-title = engrenagem, luz
cube-title = cubo, média
cube-split-title = cubo, separado
cube-angles-title = cubo, ângulo
cube-angles-caption = { gear-angles-caption }
zigzag-title = zigue-zague, média
zigzag-split-title = zigue-zague, separado
roof-title = telhado, média
roof-split-title = telhado, separado
own-share-averaged-measure = média: parcela de cantos acima do ângulo de vinco
own-share-split-measure = separada: parcela de cantos acima do ângulo de vinco
own-largest-averaged-measure = média: maior ângulo entre a normal de um canto e a da face
own-largest-split-measure = separada: maior ângulo entre a normal de um canto e a da face
own-mean-averaged-measure = média: erro médio das normais dos pixels
own-mean-split-measure = separada: erro médio das normais dos pixels
own-title = malha, média
own-split-title = malha, separada
own-angles-title = malha, ângulo
own-angles-caption = { gear-angles-caption }
own-light-title = malha, luz
own-light-caption = { gear-light-caption }
