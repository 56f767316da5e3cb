title = Falso alisamento
claim =
    As normais nos vértices são médias das normais das faces, e também são alisadas as arestas que deviam ser vivas: no
    pior caso todas as médias são paralelas, e um zigue-zague parece plano. Os sombreamentos de Gouraud e de Phong
    partilham o defeito.
source-1 = Aulas: 1.6.4 (figura 41), 1.6.13 (figura 44), 1.6.15, 1.6.47
source-2 = A cura das aulas é não interpolar; separar os vértices onde as arestas são vivas é a que se usa desde então
formula-1 = {"δ_\\mathrm{cubo} = \\arctan(\\sqrt{2}) = 54{,}7356°"}
formula-1-says = o ângulo entre uma face do cubo e a média das três faces no seu vértice
formula-2 = {"δ_\\mathrm{zigue} = s, \\quad δ_\\mathrm{telhado} = s/2"}
formula-2-says =
    para faixas inclinadas de s para um lado e para o outro, e para faixas das quais uma sim, outra não, se inclina de s
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{média} = 1"}
formula-3-says =
    o zigue-zague sob luz frontal, iluminado pelas normais das faces como é, e pelas suas médias como aparece
own-mesh = as suas normais médias sobre todas as arestas, e não sobre os vincos
shown-by = faces que se encontram com mais que o ângulo de vinco, sob luz do lado do observador, o mostrariam.
shape-cube = cubo
shape-zigzag = zigue-zague
shape-roof = telhado
front-averaged-measure = zigue-zague, luz frontal, média: luminância
front-faces-measure = zigue-zague, luz frontal, como é: luminância
gear-share-measure = engrenagem: parcela dos cantos cuja normal média está a mais de { $crease }° da sua face
gear-averaged-measure = engrenagem, média: erro médio das normais dos pixels
gear-split-measure = engrenagem, separada: erro médio das normais dos pixels
gear-effect = engrenagem: erro médio das normais dos pixels
holds =
    sempre que faces que partilham um vértice não representam uma só superfície lisa. Onde representam, as mesmas médias
    estão certas, e nenhuma regra sem ângulo de vinco, marcas ou grupos serve a ambas. Faces mais finas estreitam a
    faixa borrada ao lado de uma aresta viva, e deixam as normais na aresta tão erradas quanto antes.
note-1 =
    No zigue-zague cada vértice tem uma face inclinada para a esquerda e outra igualmente inclinada para a direita, e
    toda média aponta reto para a frente. Seja qual for a luz ou o modelo de reflexão, ele parece uma chapa plana.
note-2 =
    A separação dá a cada lado de uma aresta viva a sua própria normal. O ângulo de vinco tem de ficar entre as dobras
    que são reais e as que só representam algo redondo, como no furo da engrenagem: o gráfico mostra esse patamar.
front-averaged-by = N·L com L = (0, 0, 1); precisão simples
gear-bore-measure = engrenagem, separada: maior ângulo da normal de um canto com a sua face
gear-bore-by = metade do ângulo entre as facetas do furo, que continua liso
error-by-crease-angle-title = A engrenagem por ângulo de vinco
error-by-crease-angle-caption =
    O ângulo médio das normais dos cantos com as suas faces: abaixo de 7,5° nada é liso, no patamar só o furo, e além
    dele os dentes e por fim os lados são alisados falsamente.
error-by-crease-angle-x = ângulo de vinco, graus
error-by-crease-angle-y = ângulo médio, graus
gear-curve = cantos da engrenagem
own-effect = maior ângulo da normal de um canto com a sua face
why-crease-angle = o ângulo de vinco; menos pode representar algo redondo
own-holds = esta malha tem cantos cuja média está mais longe da sua face do que o ângulo de vinco.
own-caption = Normais médias sobre todas as arestas.
own-seen = Arestas vivas também são alisadas.
own-split-caption = Vértices separados onde as arestas são mais vivas que o ângulo de vinco.
own-split-seen = Elas voltam a ser vivas.
own-note =
    Faces que representam algo redondo também diferem das suas médias, por metade do ângulo entre elas; só o que passa
    disso é falso.
pixels-effect = erro médio das normais dos pixels
gear-caption = Uma engrenagem com uma normal por vértice.
gear-seen = Os dentes parecem inflados, a luz corre por cima de cada aresta.
gear-split-caption = Separada pelo ângulo de vinco.
cube-caption = Um cubo de oito vértices com oito normais.
cube-seen = Ele parece uma almofada.
cube-split-caption = Separado pelo ângulo de vinco.
cube-split-seen = Cada face tem uma só luminância.
zigzag-caption = Faixas inclinadas 45° para a esquerda e para a direita.
zigzag-seen = Todas as normais médias são paralelas: só o contorno mostra a forma.
zigzag-split-caption = A mesma chapa sob a mesma luz, separada pelo ângulo de vinco.
zigzag-split-seen = As faixas têm as suas próprias normais.
roof-caption = Um telhado trapezoidal de faixas planas.
roof-seen = Com a média parece feito de ondas.
roof-split-caption = O telhado, separado pelo ângulo de vinco.
roof-split-seen = Faixas uniformes com dobras vivas.
gear-light-caption = Quanto erra a luz pela lei de Lambert: violeta 0, amarelo metade da faixa ou mais.
front-faces-by = { front-averaged-by }
averaged-measure = { $shape }, média: maior ângulo da normal de um canto com a sua face
averaged-by = o ângulo entre a média e uma face; poucos arredondamentos
split-measure = { $shape }, separado: maior ângulo da normal de um canto com a sua face
split-by = 0 onde o ângulo de vinco é menor que o da aresta
pixels-cure = vértices separados em arestas de mais de { $crease }°
own-cure = { pixels-cure }
gear-split-seen = Dentes e lados são planos.
gear-title = engrenagem, média
gear-split-title = engrenagem, separada
gear-angles-title = engrenagem, ângulo
gear-angles-caption = O ângulo entre a normal média e a da face: violeta 0°, amarelo { $full-angle }° ou mais.
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
own-largest-averaged-measure = média: maior ângulo da normal de um canto com a sua face
own-largest-split-measure = separada: maior ângulo da normal de um canto com a sua face
own-mean-averaged-measure = média: ângulo médio dos pixels
own-mean-split-measure = separada: ângulo médio dos pixels
own-title = malha, média
own-split-title = malha, separada
own-angles-title = malha, ângulo
own-angles-caption = { gear-angles-caption }
own-light-title = malha, luz
own-light-caption = { gear-light-caption }
