title = Vértices não compartilhados causam arestas, fendas e emendas
claim = A tonalização interpolada é descontínua onde faces se encontram sem vértices compartilhados.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47
source-2 = Cura por solda: crease normals --weld
formula-1 = {"ΔI = |c − ((1 − t) a + t b)|"}
formula-1-says = salto num vértice de cor c na fração t de uma aresta; as cores nas pontas da aresta são a e b
formula-2 = {"ΔI = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-2-says =
    salto ao longo de uma emenda não soldada de um tubo de N facetas, Δ = 2π/N, pois cada lado tem a normal de sua
    própria faceta. A emenda está no ângulo θ a partir do observador (aqui θ = 0), a luz em θ_L
formula-3 = {"A = \\frac{1}{2} L δ"}
formula-3-says = área da fenda entre uma aresta de comprimento L e um vértice à distância δ dela
shown-by =
    Para mostrá-lo na emenda, use luz vinda do lado dela (--light 50) e menos segmentos. A junção em T e a fenda são
    visíveis sob qualquer luz.
t-junction-measure = junção em T: maior salto através da aresta
t-junction-by = |c − ((1 − t)a + tb)|; tolerância: o vértice está na linha de pixels medida a menos de 1/256 de pixel
t-junction-shared-measure = junção em T, vértice nas duas faces: maior salto através da aresta
t-junction-shared-by =
    0 na aresta; no centro do pixel ao lado, a cor da face grande já mudou em direção à da aresta oposta
crack-measure = fenda: área não coberta
crack-by = Lδ/2; tolerância: 1/16 de pixel por pixel de comprimento, e um pixel em cada ponta
crack-closed-by = 0, pois faces que compartilham uma aresta cobrem cada amostra exatamente uma vez
seam-measure = emenda: salto de luminância
seam-by = 2 |sin(θ − θ_L)| sin(Δ/2); medido a um pixel e meio da emenda, dos dois lados
seam-welded-measure = emenda soldada: salto de luminância
seam-welded-by = 0, pois cada vértice tem uma normal; medido do mesmo modo
seam-effect = salto de luminância através da emenda
seam-cure = vértices soldados
t-junction-effect = maior salto através da aresta
crack-effect = área não coberta
why-half-pixel = meio pixel
holds-only-if =
    a cor ou a normal de um vértice num lado diferir do valor interpolado no outro. Uma junção em T numa parede plana e
    iluminada por igual não é visível. Uma emenda com as mesmas normais nos dois lados também não.
note-1 =
    O vértice na aresta longa pertence só às duas faces pequenas. A face grande não tem a cor desse vértice e interpola
    entre as pontas da aresta. Por isso as cores dos dois lados da aresta diferem.
note-2 =
    O arredondamento pode mover esse vértice para fora da aresta. Nesse caso, há uma fenda pela qual o fundo é visível.
    Acrescentar o vértice à face grande cura tanto o salto quanto a fenda.
note-3 =
    Numa emenda, duas colunas de vértices têm as mesmas posições. As normais dos vértices são médias das faces
    incidentes, e cada coluna só tem as faces de um lado. A solda calcula a média de todas as faces na mesma posição.
t-junction-title = junção em T
t-junction-caption =
    Três faces cujas cores nos cantos só dependem da altura. As duas pequenas, à direita, têm sua cor mais clara no
    vértice comum; a face grande não tem esse vértice.
t-junction-seen = Uma aresta é visível no meio.
t-junction-shared-title = vértice em todas as faces
t-junction-shared-caption = O vértice é também um canto da face grande.
t-junction-shared-seen = Não há salto na aresta; só a inclinação muda.
crack-title = fenda
crack-caption = O vértice a δ = { $off } px da aresta longa, de L = { $edge } px.
crack-seen = O fundo aparece por uma fenda escura.
crack-closed-title = fenda fechada
crack-closed-caption = O mesmo vértice como canto das três faces.
crack-closed-seen = Todas as amostras são cobertas.
seam-title = emenda
seam-caption =
    Um tubo de N = { $facets } facetas com a luz em θ_L = { $light }°. A primeira e a última coluna de vértices têm as
    mesmas posições (θ = 0), mas são vértices separados.
seam-seen = Há uma linha vertical no meio.
seam-welded-title = emenda soldada
seam-welded-caption = Vértices soldados: as normais são médias das faces dos dois lados.
seam-welded-seen = A linha não é visível.
jump-title = Salto através da aresta longa
jump-caption =
    O salto cresce das duas pontas da aresta até o vértice que a face grande não tem. Com um vértice compartilhado não
    há salto.
jump-x = altura ao longo da aresta
jump-y = salto de luminância
t-junction-shared-curve = vértice compartilhado
t-junction-curve = { t-junction-title }
crack-closed-measure = fenda, vértice nas duas faces: área não coberta
t-junction-cure = vértice em todas as faces
crack-cure = vértice em todas as faces
