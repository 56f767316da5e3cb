title = Normais médias alisam arestas vivas
claim =
    As normais dos vértices são médias das normais das faces, e por isso alisam arestas que deveriam ser vivas. No pior
    caso todas as médias são paralelas, e um zigue-zague parece plano. As tonalizações de Gouraud e de Phong têm esse
    erro.
source-1 = Aulas: 1.6.4 (figura 41), 1.6.13 (figura 44), 1.6.15, 1.6.47
source-2 = Cura nas aulas: não interpolar. Cura comum desde então: separar os vértices nas arestas vivas
formula-1 = {"δ_\\mathrm{cubo} = \\arctan(\\sqrt{2}) = 54{,}7356°"}
formula-1-says = ângulo entre a normal de uma face do cubo e a normal média das três faces no vértice
formula-2 = {"δ_\\mathrm{zigue} = s, \\quad δ_\\mathrm{telhado} = s/2"}
formula-2-says =
    zigue-zague: faixas inclinadas de s para os dois lados; telhado: uma faixa sim, outra não, inclinada de s
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{média} = 1"}
formula-3-says = luminância do zigue-zague sob luz frontal, com as normais das faces e com as normais médias
own-mesh = as normais médias sobre todas as arestas, comparadas com normais separadas nos vincos
shown-by = Para mostrá-lo, use faces que formem ângulos maiores que o ângulo de vinco e luz do lado do observador.
shape-cube = cubo
shape-zigzag = zigue-zague
shape-roof = telhado
front-averaged-measure = zigue-zague, luz frontal, normais médias: luminância
front-faces-measure = zigue-zague, luz frontal, normais das faces: luminância
gear-share-measure = engrenagem: parcela dos cantos cuja normal média difere em mais de { $crease }° da normal da face
gear-averaged-measure = engrenagem, normais médias: erro médio das normais dos pixels
gear-split-measure = engrenagem, vértices separados: erro médio das normais dos pixels
gear-effect = engrenagem: erro médio das normais dos pixels
holds =
    se as faces que compartilham um vértice não formarem uma só superfície lisa. Em superfícies lisas as mesmas médias
    são corretas. Por isso, um ângulo de vinco, arestas marcadas ou grupos de suavização devem separar os dois casos.
    Faces mais finas estreitam a faixa alisada junto a uma aresta viva, mas não corrigem as normais na aresta.
note-1 =
    No zigue-zague, cada vértice tem uma face inclinada para a esquerda e outra inclinada para a direita, no mesmo
    ângulo. Por isso, todas as normais médias apontam para a frente. Com qualquer luz e qualquer modelo de reflexão, o
    zigue-zague parece uma chapa plana.
note-2 =
    A separação dá a cada lado de uma aresta viva sua própria normal. O ângulo de vinco deve ficar entre os ângulos
    diedros das arestas vivas e os das superfícies curvas, como o furo da engrenagem. O gráfico mostra esse intervalo
    como um patamar.
front-averaged-by = N·L com L = (0, 0, 1); tolerância: precisão simples
gear-bore-measure = engrenagem, vértices separados: maior ângulo entre a normal de um canto e a da face
gear-bore-by = metade do ângulo entre facetas do furo, que continua liso
error-by-crease-angle-title = A engrenagem em função do ângulo de vinco
error-by-crease-angle-caption =
    Ângulo médio entre as normais dos cantos e as das faces. Abaixo de 7,5° nada é alisado; no patamar, só o furo é
    alisado. Acima do patamar, os dentes e, por fim, os lados são alisados indevidamente.
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
    Em superfícies curvas, as normais das faces também diferem das médias, em metade do ângulo entre faces vizinhas. Só
    diferenças maiores são erros.
pixels-effect = erro médio das normais dos pixels
gear-caption = Uma engrenagem com uma normal por vértice.
gear-seen = Os dentes parecem inflados, e a tonalização continua através de cada aresta.
gear-split-caption = A engrenagem com vértices separados pelo ângulo de vinco.
cube-caption = Um cubo com oito vértices e oito normais.
cube-seen = O cubo parece uma almofada.
cube-split-caption = O cubo com vértices separados pelo ângulo de vinco.
cube-split-seen = Cada face tem uma só luminância.
zigzag-caption = Faixas inclinadas 45° para a esquerda e para a direita.
zigzag-seen = Todas as normais médias são paralelas: só o contorno mostra a forma.
zigzag-split-caption = A mesma chapa sob a mesma luz, com vértices separados pelo ângulo de vinco.
zigzag-split-seen = Cada faixa tem sua própria normal.
roof-caption = Um telhado corrugado, feito de faixas planas.
roof-seen = As normais médias fazem o telhado parecer ondulado.
roof-split-caption = O telhado com vértices separados pelo ângulo de vinco.
roof-split-seen = As faixas são uniformes, com arestas vivas.
gear-light-caption = Erro da reflexão difusa (Lambert): violeta é 0, amarelo é metade da faixa total ou mais.
front-faces-by = { front-averaged-by }
averaged-measure = { $shape }, normais médias: maior ângulo entre a normal de um canto e a da face
averaged-by = ângulo entre a normal média e a de uma face; tolerância: alguns arredondamentos
split-measure = { $shape }, vértices separados: maior ângulo entre a normal de um canto e a da face
split-by = 0 se o ângulo de vinco for menor que o ângulo diedro
pixels-cure = vértices separados em arestas com ângulo acima de { $crease }°
own-cure = { pixels-cure }
gear-split-seen = Dentes e lados são planos.
gear-title = engrenagem, normais médias
gear-split-title = engrenagem, vértices separados
gear-angles-title = engrenagem, ângulo
gear-angles-caption = Ângulo entre a normal média e a da face: violeta é 0°, amarelo é { $full-angle }° ou mais.
gear-light-title = engrenagem, luz
cube-title = cubo, normais médias
cube-split-title = cubo, vértices separados
cube-angles-title = cubo, ângulo
cube-angles-caption = { gear-angles-caption }
zigzag-title = zigue-zague, normais médias
zigzag-split-title = zigue-zague, vértices separados
roof-title = telhado, normais médias
roof-split-title = telhado, vértices separados
own-share-averaged-measure = normais médias: parcela de cantos acima do ângulo de vinco
own-share-split-measure = vértices separados: parcela de cantos acima do ângulo de vinco
own-largest-averaged-measure = normais médias: maior ângulo entre a normal de um canto e a da face
own-largest-split-measure = vértices separados: maior ângulo entre a normal de um canto e a da face
own-mean-averaged-measure = normais médias: erro médio das normais dos pixels
own-mean-split-measure = vértices separados: erro médio das normais dos pixels
own-title = malha, normais médias
own-split-title = malha, vértices separados
own-angles-title = malha, ângulo
own-angles-caption = { gear-angles-caption }
own-light-title = malha, luz
own-light-caption = { gear-light-caption }
