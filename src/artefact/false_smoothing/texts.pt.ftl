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
formula-3-says = o zigue-zague sob luz frontal, iluminado pelas normais das faces como é, e pelas suas médias como aparece
own-mesh = as suas normais médias sobre todas as arestas, e não sobre os vincos
shown-by = faces que se encontram com mais que o ângulo de vinco, sob luz do lado do observador, o mostrariam.
cube = cubo
zig-zag = zigue-zague
roof = telhado
zig-zag-light = zigue-zague, luz frontal, média: luminância
zig-zag-light-front = zigue-zague, luz frontal, como é: luminância
gear-share-corners = engrenagem: parcela dos cantos cuja normal média está a mais de { $value }° da sua face
measure-gear-averaged-mean = engrenagem, média: erro médio das normais dos pixels
measure-gear-split-mean = engrenagem, separada: erro médio das normais dos pixels
moved = engrenagem: erro médio das normais dos pixels
cure = o que resta é o furo, alisado de propósito
holds-wherever-faces-share =
    sempre que faces que partilham um vértice não representam uma só superfície lisa. Onde representam, as mesmas médias
    estão certas, e nenhuma regra sem ângulo de vinco, marcas ou grupos serve a ambas. Faces mais finas estreitam a
    faixa borrada ao lado de uma aresta viva, e deixam as normais na aresta tão erradas quanto antes.
zig-zag-every =
    No zigue-zague cada vértice tem uma face inclinada para a esquerda e outra igualmente inclinada para a direita, e
    toda média aponta reto para a frente. Seja qual for a luz ou o modelo de reflexão, ele parece uma chapa plana.
splitting-gives-each =
    A separação dá a cada lado de uma aresta viva a sua própria normal. O ângulo de vinco tem de ficar entre as dobras
    que são reais e as que só representam algo redondo, como no furo da engrenagem: o gráfico mostra esse patamar.
by-n-l-l = N·L com L = (0, 0, 1); precisão simples
measure-gear-split-largest = engrenagem, separada: maior ângulo da normal de um canto com a sua face
by-half-angle-between = metade do ângulo entre as facetas do furo, que continua liso
chart-title = A engrenagem por ângulo de vinco
chart-caption =
    O ângulo médio das normais dos cantos com as suas faces: abaixo de 7,5° nada é liso, no patamar só o furo, e além
    dele os dentes e por fim os lados são alisados falsamente.
axis-crease-angle-degrees = ângulo de vinco, graus
axis-mean-angle-degrees = ângulo médio, graus
curve-corners-gear = cantos da engrenagem
moved-largest-angle-corner = maior ângulo da normal de um canto com a sua face
why-crease-angle-less = o ângulo de vinco; menos pode representar algo redondo
holds-mesh-corners-mean = esta malha tem cantos cuja média está mais longe da sua face do que o ângulo de vinco.
own-title = Normais médias sobre todas as arestas.
own-caption-sharp-edges-smoothed = Arestas vivas também são alisadas.
own-split-title = Vértices separados onde as arestas são mais vivas que o ângulo de vinco.
own-split-caption-they-sharp-again = Elas voltam a ser vivas.
note-faces-stand-something =
    Faces que representam algo redondo também diferem das suas médias, por metade do ângulo entre elas; só o que passa
    disso é falso.
mean-error-pixels = erro médio das normais dos pixels
gear-normal-vertex = Uma engrenagem com uma normal por vértice.
teeth-look-inflated = Os dentes parecem inflados, a luz corre por cima de cada aresta.
split-crease-angle = Separada pelo ângulo de vinco.
teeth-sides-flat =
    Dentes e lados são planos; o furo continua redondo de propósito, com normais a até { $of-bore }° das suas facetas.
teeth-sides-flat-bore = Dentes e lados são planos, o furo continua redondo.
teeth-sides-flat-but = Dentes e lados são planos, mas também as facetas do furo, que devia ser redondo.
cube-eight-vertices = Um cubo de oito vértices com oito normais.
looks-like-pillow = Ele parece uma almofada.
split-crease-angle-v2 = Separado pelo ângulo de vinco.
every-face-luminance = Cada face tem uma só luminância.
strips-lean-left = Faixas inclinadas 45° para a esquerda e para a direita.
all-means-parallel = Todas as médias são paralelas, e só o contorno as revela.
same-sheet-same = A mesma chapa sob a mesma luz, separada pelo ângulo de vinco.
strips-their-own = As faixas têm as suas próprias normais.
corrugated-roof-flat = Um telhado trapezoidal de faixas planas.
averaged-looks-like = Com a média parece feito de ondas.
roof-split-crease = O telhado, separado pelo ângulo de vinco.
even-strips-sharp = Faixas uniformes com dobras vivas.
how-far-light = Quanto erra a luz pela lei de Lambert: violeta 0, amarelo metade da faixa ou mais.
