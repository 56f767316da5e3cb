title = A média no vértice
claim =
    A normal num vértice é a média das normais de todas as faces nele. Ela depende então de como a superfície foi
    cortada em faces: uma face cortada através do vértice conta duas vezes.
source-1 = Aulas: 1.5.2.1 (figura 33), 1.6.13, 1.6.21 b (figura 47)
source-2 =
    Pesos: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights
    for computing vertex normals from facet normals, JGT 4(2), 1999
formula-1 = {"N = \\frac{Σ w_i N_i}{\\left|Σ w_i N_i\\right|}"}
formula-1-says =
    a média num vértice: w = 1 nas aulas, o ângulo no vértice em Thürmer e Wüthrich, sin(α)/(|e_1| |e_2|) em Max
formula-2 = {"\\cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, \\cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}"}
formula-2-says =
    o vértice de um cubo do qual uma face ou duas estão cortadas: δ = 19,4712° e 15,7932° da diagonal com w = 1
formula-3 = {"w = α: δ = 0"}
formula-3-says = os ângulos das partes de uma face plana somam o da face, seja como for cortada
shown-by = outros pesos (--weight uniform) o mostrariam.
equal-weights = pesos iguais
area-weights = pesos pela área
angle-weights = pesos pelo ângulo
angle-area-weights = pesos ângulo × área
max-weights = pesos de Max
edge-weights = pesos 1/(|e₁| |e₂|) das arestas
slivers-effect = bola de lascas: erro das normais nos vértices (rms)
cube-effect = cubo: maior ângulo com a diagonal
box-effect = caixa: maior ângulo com a diagonal
torus-effect = toro irregular: erro das normais nos vértices (rms)
note-1 =
    No cubo cada vértice tem três faces. Onde uma delas é cortada através do vértice, dois triângulos votam por ela e a
    média se inclina. O ângulo no vértice se divide entre os dois, e os seus votos voltam a somar um.
note-2 =
    Não depender do corte ainda não é estar certo: na caixa de 1 × 1 × 10 os pesos de Max dão a mesma normal para os 64
    cortes, com erro de 46,7°, pois favorecem faces pequenas. Numa bola, onde a média representa algo redondo, eles são
    exatos, e os ângulos não.
fails =
    estes pesos dão ao cubo as mesmas normais, como quer que as faces sejam cortadas. Em superfícies redondas a média
    ainda depende dos triângulos.
torus-rms-by = outro programa na mesma malha, até os dígitos que imprimiu
ball-by = exatos onde todos os vértices de um leque estão numa esfera (Max 1999)
error-by-slivers-title = Pesos numa bola de lascas
error-by-slivers-caption =
    O erro das normais nos vértices (rms) quando uma fileira de triângulos sim, outra não, é tantas vezes mais estreita:
    cresce com quase todos os pesos, e fica 0 com os de Max.
error-by-slivers-x = altura da fileira larga sobre a da estreita
error-by-slivers-y = erro em graus
cube-1-caption = O cubo alisado, as faces cortadas por uma diagonal.
cube-1-seen = Alguns cantos se inclinam para um lado.
cube-2-caption = O mesmo cubo com todas as faces cortadas pela outra diagonal.
cube-2-seen = Luz e sombra estão em outro lugar.
cube-difference-title = entre os dois
cube-difference-caption = Quanto as duas imagens diferem: violeta 0, amarelo { $full-light } da faixa ou mais.
cube-angle-caption = Pesos pelo ângulo.
cube-angle-seen = Cada canto tem a diagonal como normal, como quer que as faces sejam cortadas.
box-max-caption = A caixa de 1 × 1 × 10 com os pesos de Max.
box-max-seen = As normais se inclinam para as faces pequenas das pontas, e as faces longas parecem curvas.
box-angle-caption = A caixa com pesos pelo ângulo.
box-angle-seen = Cada uma das três faces num canto conta igual.
slivers-caption = Uma bola em que uma fileira de triângulos sim, outra não, é doze vezes mais estreita.
slivers-seen = As fileiras aparecem como faixas na luz.
slivers-angle-caption = Pesos pelo ângulo não ajudam aqui.
slivers-angle-seen = Uma lasca entre dois vértices tem um ângulo tão grande quanto um triângulo largo.
slivers-max-caption = Os pesos de Max nos mesmos triângulos.
slivers-max-seen = São exatos em cada vértice de uma esfera, e redondos entre eles.
torus-caption = Um toro de triângulos cortados ao acaso.
torus-seen = A luz é irregular.
torus-max-caption = Os mesmos triângulos com os pesos de Max.
torus-max-seen = A luz é mais regular.
torus-itself-title = o próprio toro
torus-itself-caption = O toro com a sua própria normal em cada pixel.
slivers-cure = { $round }
torus-cure = { $round }
cube-cure = { $flat }
box-cure = { $flat }
torus-largest-by = { torus-rms-by }
torus-rms-measure = toro irregular: erro rms nos vértices, { $weighting }
torus-largest-measure = toro irregular: erro maior nos vértices, { $weighting }
ball-measure = bola de lascas: erro rms nos vértices, { $weighting }
cube-largest-measure = cubo: maior ângulo entre todos os cortes, { $weighting }
cube-next-measure = cubo: menor que não é 0, { $weighting }
box-largest-measure = caixa 1 × 1 × 10: maior, { $weighting }
box-least-measure = caixa 1 × 1 × 10: menor, { $weighting }
cube-largest-by = cada face conta com os pesos dos seus triângulos no canto, um ou dois; poucos arredondamentos
cube-next-by = { cube-largest-by }
box-largest-by = { cube-largest-by }
box-least-by = { cube-largest-by }
cube-1-title = cubo cortado de um modo, { $weight }
cube-2-title = cortado do outro modo, { $weight }
cube-angle-title = cubo, { $flat }
box-max-title = caixa, { $round }
box-angle-title = caixa, { $flat }
slivers-title = lascas, { $weight }
slivers-angle-title = lascas, { $flat }
slivers-max-title = lascas, { $round }
slivers-error-title = lascas, erro, { $weight }
slivers-error-caption = O ângulo entre normais interpoladas e verdadeiras: violeta 0°, amarelo { $full-angle }° ou mais.
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
    com pesos que mudam onde uma face é cortada através do vértice, como os destas imagens ({ $weight }). Pesos pelo
    ângulo não dependem de como faces planas são cortadas, e os de Max são exatos em esferas; nenhum está certo em toda
    parte.
