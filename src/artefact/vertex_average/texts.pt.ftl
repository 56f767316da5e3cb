title = A média no vértice
claim =
    A normal num vértice é a média das normais de todas as faces nele. Ela depende então de como a superfície foi
    cortada em faces: uma face cortada através do vértice conta duas vezes.
source-1 = Aulas: 1.5.2.1 (figura 33), 1.6.13, 1.6.21 b (figura 47)
source-2 =
    Pesos: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights
    for computing vertex normals from facet normals, JGT 4(2), 1999
formula-1 = {"N = \\frac{Σ w_i N_i}{\\left|Σ w_i N_i\\right|}"}
formula-1-says = a média num vértice: w = 1 nas aulas, o ângulo no vértice em Thürmer e Wüthrich, sin(α)/(|e_1| |e_2|) em Max
formula-2 = {"\\cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, \\cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}"}
formula-2-says = o vértice de um cubo do qual uma face ou duas estão cortadas: δ = 19,4712° e 15,7932° da diagonal com w = 1
formula-3 = {"w = α: δ = 0"}
formula-3-says = os ângulos das partes de uma face plana somam o da face, seja como for cortada
shown-by = outros pesos (--weight uniform) o mostrariam.
equal-weights = pesos iguais
area-weights = pesos pela área
angle-weights = pesos pelo ângulo
weights-angle-area = pesos ângulo × área
max-weights = pesos de Max
weights-e-e = pesos 1/(|e₁| |e₂|) das arestas
moved = bola de lascas: erro das normais nos vértices (rms)
cube-largest-angle = cubo: maior ângulo com a diagonal
box-largest-angle = caixa: maior ângulo com a diagonal
moved-irregular-torus-error = toro irregular: erro das normais nos vértices (rms)
note-cube-each-corner =
    No cubo cada vértice tem três faces. Onde uma delas é cortada através do vértice, dois triângulos votam por ela e a
    média se inclina. O ângulo no vértice se divide entre os dois, e os seus votos voltam a somar um.
note-not-depend-cut =
    Não depender do corte ainda não é estar certo: na caixa de 1 × 1 × 10 os pesos de Max dão a mesma normal para os 64
    cortes, com erro de 46,7°, pois favorecem faces pequenas. Numa bola, onde a média representa algo redondo, eles são
    exatos, e os ângulos não.
fails-these-weights-give =
    estes pesos dão ao cubo as mesmas normais, como quer que as faces sejam cortadas. Em superfícies redondas a média
    ainda depende dos triângulos.
both-parts-face =
    as duas partes de uma face cortada pelo vértice contam juntas tanto quanto a única parte de uma face cortada do
    outro modo; poucos arredondamentos
each-face-counts = cada face conta como um triângulo ou como dois; poucos arredondamentos
by-another-program-same = outro programa na mesma malha, até os dígitos que imprimiu
by-exact-all-vertices = exatos onde todos os vértices de um leque estão numa esfera (Max 1999)
chart-title = Pesos numa bola de lascas
chart-caption =
    O erro das normais nos vértices (rms) quando uma fileira de triângulos sim, outra não, é tantas vezes mais estreita:
    cresce com quase todos os pesos, e fica 0 com os de Max.
axis-height-wide-row = altura da fileira larga sobre a da estreita
axis-error-degrees = erro em graus
cube-1-title = O cubo alisado, as faces cortadas por uma diagonal.
cube-1-caption-some-corners-lean = Alguns cantos se inclinam para um lado.
cube-2-title = O mesmo cubo com todas as faces cortadas pela outra diagonal.
cube-2-caption-light-shadow-elsewhere = Luz e sombra estão em outro lugar.
cube-difference-title = entre os dois
cube-difference-caption-how-far-both = Quanto as duas imagens diferem: violeta 0, amarelo { $full-light } da faixa ou mais.
cube-angle-title = Pesos pelo ângulo.
cube-angle-caption-every-corner-diagonal = Cada canto tem a diagonal como normal, como quer que as faces sejam cortadas.
box-max-title = A caixa de 1 × 1 × 10 com os pesos de Max.
box-max-caption-normals-lean-towards = As normais se inclinam para as faces pequenas das pontas, e as faces longas parecem curvas.
box-angle-title = A caixa com pesos pelo ângulo.
box-angle-caption-each-three-faces = Cada uma das três faces num canto conta igual.
slivers-title = Uma bola em que uma fileira de triângulos sim, outra não, é doze vezes mais estreita.
slivers-caption-rows-show-bands = As fileiras aparecem como faixas na luz.
slivers-angle-title = Pesos pelo ângulo não ajudam aqui.
slivers-angle-caption-sliver-between-vertices = Uma lasca entre dois vértices tem um ângulo tão grande quanto um triângulo largo.
slivers-max-title = Os pesos de Max nos mesmos triângulos.
slivers-max-caption-they-exact-every = São exatos em cada vértice de uma esfera, e redondos entre eles.
torus-title = Um toro de triângulos cortados ao acaso.
torus-caption-light-uneven = A luz é irregular.
torus-max-title = Os mesmos triângulos com os pesos de Max.
torus-max-caption-light-more-even = A luz é mais regular.
torus-itself-title = o próprio toro
torus-itself-caption-torus-own-normal = O toro com a sua própria normal em cada pixel.
