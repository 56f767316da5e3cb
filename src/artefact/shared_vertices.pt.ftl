title = Vértices não compartilhados
claim = Onde faces se encontram sem compartilhar os vértices, o sombreamento interpolado tem descontinuidades.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47
source-2 = A solda como cura: crease normals --weld
formula-1 = {"ΔI = |c − ((1 − t) a + t b)|"}
formula-1-says = o salto num vértice de cor c que está na fração t de uma aresta com as cores a e b nas pontas
formula-2 = {"ΔI = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-2-says =
    o salto ao longo de uma emenda não soldada, no ângulo θ a partir do observador, de um tubo de N facetas, Δ = 2π/N,
    com a luz em θ_L: cada lado tem a normal da sua faceta; aqui θ = 0
formula-3 = {"A = \\frac{1}{2} L δ"}
formula-3-says = a área da fenda ao lado de uma aresta de comprimento L da qual um vértice dista δ
shown-by =
    luz que vem do lado da emenda (--light 50), e menos segmentos, o mostrariam ali; a junção em T e a fenda se veem sob
    qualquer luz.
t-junction-measure = junção em T: maior salto através da aresta
t-junction-by = |c − ((1 − t)a + tb)|; o vértice está na linha de pixels medida, a menos de 1/256 de pixel
t-junction-shared-measure = o mesmo com o vértice nas duas faces
t-junction-shared-by =
    na aresta nenhum; no centro do pixel ao lado, a face grande está a caminho da cor da sua aresta oposta
crack-measure = fenda: área não coberta
crack-by = Lδ/2; um dezesseis avos de pixel por pixel do comprimento, e um em cada ponta
crack-closed-by = faces que compartilham uma aresta cobrem cada amostra uma vez
seam-measure = emenda: salto de luminância
seam-by = 2 |sin(θ − θ_L)| sin(Δ/2); medido a um pixel e meio da emenda dos dois lados
seam-welded-measure = emenda soldada
seam-welded-by = uma normal por vértice; como acima
seam-effect = salto de luminância através da emenda
seam-cure = soldado
t-junction-effect = maior salto através da aresta
crack-effect = área não coberta
why-half-pixel = metade de um pixel
holds-only-if =
    a cor ou normal que um lado tem num vértice não é a que o outro lado interpola ali. Uma junção em T numa parede
    plana e iluminada por igual não se vê, nem uma emenda cujos lados têm as mesmas normais.
note-1 =
    O vértice na aresta longa pertence só às duas faces pequenas. A face grande nada sabe da sua cor e interpola direto
    por ele: ao seu lado, os dois lados diferem.
note-2 =
    Movido para fora da aresta, como faz o arredondamento, ele deixa uma fenda, pela qual se vê o fundo. Posto na face
    grande como um canto seu, ele cura os dois.
note-3 =
    Numa emenda, duas fileiras de vértices estão nos mesmos lugares. Normais são médias das faces num vértice, e cada
    fileira só tem as faces de um lado. A solda toma como um só os vértices no mesmo lugar.
t-junction-title = junção em T
t-junction-caption =
    Três faces cujas cores nos cantos só dependem da altura deles. As pequenas à direita são mais claras no vértice
    comum, que falta à grande.
t-junction-seen = Vê-se uma aresta no meio.
t-junction-shared-title = vértice em todas as faces
t-junction-shared-caption = O vértice é também um canto da face grande.
t-junction-shared-seen = Não há mais salto na aresta, só uma quebra da inclinação.
crack-title = fenda
crack-caption = O vértice a δ = { $off } px da aresta longa, de L = { $edge } px.
crack-seen = O fundo aparece por uma fenda escura.
crack-closed-title = fenda fechada
crack-closed-caption = O mesmo vértice como canto das três faces.
crack-closed-seen = Nenhuma amostra fica aberta.
seam-title = emenda
seam-caption =
    Um tubo de N = { $facets } facetas, a luz em θ_L = { $light }°. A sua primeira e a sua última coluna de vértices
    estão nos mesmos lugares (θ = 0) mas não são as mesmas.
seam-seen = Há uma linha no seu meio.
seam-welded-title = emenda soldada
seam-welded-caption = Soldado, e as normais são médias das faces dos dois lados.
seam-welded-seen = A linha sumiu.
jump-title = Salto através da aresta longa
jump-caption =
    O salto cresce das duas pontas da aresta até o vértice que falta à face grande; compartilhado, não há salto.
jump-x = altura ao longo da aresta
jump-y = salto de luminância
t-junction-shared-curve = vértice compartilhado
t-junction-curve = { t-junction-title }
crack-closed-measure = o mesmo com o vértice nas duas faces
t-junction-cure = vértice em todas as faces
crack-cure = vértice em todas as faces
