title = Normais médias podem depender da triangulação
claim =
    A normal num vértice é a média das normais de todas as faces incidentes. Ela depende de como a superfície é dividida
    em faces: uma face com uma diagonal no vértice conta duas vezes.
source-1 = Aulas: 1.5.2.1 (figura 33), 1.6.13, 1.6.21 b (figura 47)
source-2 =
    Pesos: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights
    for computing vertex normals from facet normals, JGT 4(2), 1999
formula-1 = {"N = \\frac{Σ w_i N_i}{\\left|Σ w_i N_i\\right|}"}
formula-1-says =
    normal média num vértice: w = 1 nas aulas, o ângulo no vértice em Thürmer e Wüthrich, sin(α)/(|e_1| |e_2|) em Max
formula-2 = {"\\cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, \\cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}"}
formula-2-says =
    vértice de um cubo em que uma ou duas faces têm uma diagonal: com w = 1 a normal está a δ = 19,4712° ou 15,7932° da
    diagonal do cubo
formula-3 = {"w = α: δ = 0"}
formula-3-says = os ângulos dos triângulos de uma face plana somam o ângulo da face, com qualquer triangulação
shown-by = Use outros pesos (--weight uniform) para mostrá-lo.
equal-weights = pesos iguais
area-weights = pesos pela área
angle-weights = pesos pelo ângulo
angle-area-weights = pesos por ângulo × área
max-weights = pesos de Max
edge-weights = pesos pelos comprimentos das arestas
slivers-effect = esfera com filas estreitas: erro das normais nos vértices (rms)
cube-effect = cubo: maior ângulo em relação à diagonal
box-effect = caixa: maior ângulo em relação à diagonal
torus-effect = toro irregular: erro das normais nos vértices (rms)
note-1 =
    Cada vértice do cubo tem três faces. Se a diagonal de uma delas termina no vértice, dois triângulos contam por essa
    face, e a normal média se inclina para ela. Com pesos pelo ângulo, os dois triângulos dividem o ângulo da face no
    vértice, e a face conta uma vez.
note-2 =
    Uma média que não depende da triangulação ainda pode estar errada. Na caixa de 1 × 1 × 10, os pesos de Max dão a
    mesma normal para as 64 triangulações, com erro de 46,7°, pois favorecem faces pequenas. Numa esfera os pesos de Max
    são exatos, e os pesos pelo ângulo não.
fails =
    estes pesos dão ao cubo as mesmas normais com qualquer triangulação. Em superfícies curvas a média ainda depende dos
    triângulos.
torus-rms-by = outro programa na mesma malha; tolerância: os dígitos que ele imprime
ball-by = exatos se todos os vértices de um leque estiverem numa esfera (Max 1999)
error-by-slivers-title = Pesos numa esfera com filas estreitas
error-by-slivers-caption =
    Erro das normais nos vértices (rms) se uma fila de triângulos sim, outra não, é mais estreita. Com quase todos os
    pesos, ele cresce com a razão das alturas; com os de Max, permanece 0.
error-by-slivers-x = altura da fila larga / altura da fila estreita
error-by-slivers-y = erro em graus
cube-1-caption = O cubo alisado, com uma das duas diagonais em cada face.
cube-1-seen = As normais em alguns vértices se inclinam para um lado.
cube-2-caption = O mesmo cubo com a outra diagonal em todas as faces.
cube-2-seen = As áreas claras e escuras ficam em outros lugares.
cube-difference-title = diferença
cube-difference-caption =
    Diferença entre as duas imagens: violeta é 0, amarelo é { $full-light } da faixa total ou mais.
cube-angle-caption = O cubo com pesos pelo ângulo.
cube-angle-seen = Com qualquer triangulação, a normal em cada vértice é a diagonal do cubo.
box-max-caption = A caixa de 1 × 1 × 10 com os pesos de Max.
box-max-seen = As normais se inclinam para as faces pequenas das pontas, e as faces longas parecem curvas.
box-angle-caption = A caixa com pesos pelo ângulo.
box-angle-seen = As três faces num vértice contam igualmente.
slivers-caption = Uma esfera em que uma fila de triângulos sim, outra não, é doze vezes mais estreita.
slivers-seen = As filas são visíveis como faixas na luz.
slivers-angle-caption = Pesos pelo ângulo não ajudam aqui.
slivers-angle-seen = Num vértice, um triângulo estreito pode ter um ângulo tão grande quanto o de um largo.
slivers-max-caption = Os pesos de Max nos mesmos triângulos.
slivers-max-seen = As normais são exatas em cada vértice de uma esfera, e a luz é lisa.
torus-caption = Um toro com uma triangulação irregular.
torus-seen = A luz é irregular.
torus-max-caption = Os mesmos triângulos com os pesos de Max.
torus-max-seen = A luz é mais regular.
torus-itself-title = toro exato
torus-itself-caption = O toro com a normal exata em cada pixel.
slivers-cure = { $round }
torus-cure = { $round }
cube-cure = { $flat }
box-cure = { $flat }
torus-largest-by = { torus-rms-by }
torus-rms-measure = toro irregular: erro rms nos vértices, { $weighting }
torus-largest-measure = toro irregular: maior erro nos vértices, { $weighting }
ball-measure = esfera com filas estreitas: erro rms nos vértices, { $weighting }
cube-largest-measure = cubo: maior ângulo entre todas as triangulações, { $weighting }
cube-next-measure = cubo: menor ângulo acima de 0, { $weighting }
box-largest-measure = caixa 1 × 1 × 10: maior ângulo, { $weighting }
box-least-measure = caixa 1 × 1 × 10: menor ângulo, { $weighting }
cube-largest-by =
    cada face conta com os pesos de seus um ou dois triângulos no vértice; tolerância: alguns arredondamentos
cube-next-by = { cube-largest-by }
box-largest-by = { cube-largest-by }
box-least-by = { cube-largest-by }
cube-1-title = cubo, uma diagonal, { $weight }
cube-2-title = outra diagonal, { $weight }
cube-angle-title = cubo, { $flat }
box-max-title = caixa, { $round }
box-angle-title = caixa, { $flat }
slivers-title = filas estreitas, { $weight }
slivers-angle-title = filas estreitas, { $flat }
slivers-max-title = filas estreitas, { $round }
slivers-error-title = filas estreitas, erro, { $weight }
slivers-error-caption = Ângulo entre normais interpoladas e exatas: violeta é 0°, amarelo é { $full-angle }° ou mais.
torus-title = toro irregular, { $weight }
torus-max-title = toro irregular, { $round }
torus-error-title = toro irregular, erro, { $weight }
torus-error-caption = { slivers-error-caption }
equal-weights-curve = { equal-weights }
area-weights-curve = { area-weights }
angle-weights-curve = { angle-weights }
angle-area-weights-curve = { angle-area-weights }
max-weights-curve = { max-weights }
edge-weights-curve = { edge-weights }
holds =
    com pesos que contam uma face de modo diferente quando sua diagonal termina no vértice, como nestas imagens
    ({ $weight }). Pesos pelo ângulo não dependem da triangulação de faces planas, e os de Max são exatos em esferas.
    Nenhum peso é correto em toda parte.
