no-normals-title = o arquivo não tem vetores normais
no-normals-meaning =
    Cada visualizador calcula os seus: glTF pede normais de face, outros programas suavizam tudo. Assim, o mesmo
    arquivo parece facetado em um e suave em outro.
no-normals-advice = Grave as normais, para que o arquivo tenha a mesma aparência em toda parte.

missing-normals-title = alguns cantos não têm vetor normal
missing-normals-meaning =
    Outros cantos da mesma malha têm um. O visualizador preenche as lacunas com normais de face, zeros ou nada, e
    faces isoladas parecem facetadas ou pretas entre faces suaves.
missing-normals-advice = Calcule as normais que faltam; as outras não mudam.

not-finite-normals-title = vetores normais infinitos ou que não são números
not-finite-normals-meaning =
    A luz em um canto assim também não é um número. Os pixels ficam pretos ou brancos, e efeitos de brilho ou filtros
    de ruído espalham o erro em blocos.
not-finite-normals-advice = Substitua-os por vetores calculados.

zero-normals-title = vetores normais de comprimento zero
zero-normals-meaning =
    Eles não têm direção: um shader que normaliza divide por zero, e um que não normaliza não calcula luz. As faces
    ficam pretas ou piscam.
zero-normals-advice = Substitua-os por vetores calculados.

not-unit-normals-title = vetores normais que não são unitários
not-unit-normals-meaning =
    O comprimento difere de 1 em mais de 0,00674, a tolerância do validador de glTF. Em um renderizador que não
    normaliza, a luminância muda por esse fator, e o brilho especular pelo fator elevado ao expoente especular.
not-unit-normals-advice = Divida-os pelo comprimento; as direções não mudam.

loose-length-title = vetores normais com comprimento um pouco diferente de 1
loose-length-meaning =
    O comprimento difere de 1 em mais de 0,001, mas não mais do que o armazenamento em 8 bits causa. Só um brilho especular
    estreito mostra isso, em um renderizador que não normaliza.
loose-length-advice = Nada a fazer, a menos que o renderizador não normalize: nesse caso, recalcule-os.

inverted-normals-title = quase todos os vetores normais apontam contra as faces
inverted-normals-meaning =
    Em mais de nove décimos dos cantos, o vetor normal fica atrás da face. A malha é preta sob luz frontal e clara sob
    luz de trás.
inverted-normals-advice =
    Recalcule as normais; se as faces também estiverem invertidas, acrescente `--orient outward` ou `--flip`.

flipped-normals-title = vetores normais opostos à direção esperada
flipped-normals-meaning =
    O vetor normal aponta quase no sentido oposto ao da média das faces em torno do vértice. A superfície é escura
    ali, com bordas claras onde a interpolação passa por zero.
flipped-normals-advice = Substitua-os por vetores calculados; os outros não mudam.

normals-against-face-title = vetores normais que apontam para trás da própria face
normals-against-face-meaning =
    O vetor normal fica a mais de 95° da face, e nenhuma dobra explica isso. A luz de trás clareia partes dela.
normals-against-face-advice = Substitua-os por vetores calculados, a menos que sejam definidos pelo autor.

constant-normals-title = todos os vetores normais são iguais, embora a forma seja curva
constant-normals-meaning =
    A malha inteira é iluminada como um cartão plano: só o contorno mostra a forma. Em geral, trata-se do valor padrão
    de um exportador; para grama ou placas, pode ser intencional.
constant-normals-advice = Calcule-os a partir das faces.

swapped-axes-title = todos os vetores normais têm eixos trocados ou invertidos
swapped-axes-meaning =
    As posições foram convertidas (de y para cima a z para cima, de mão esquerda a mão direita) e as normais não. A luz
    parece vir de outro lado, em comparação com outros objetos.
swapped-axes-advice = Calcule as normais, ou converta-as como as posições.

rotated-normals-title = todos os vetores normais sofreram a mesma rotação
rotated-normals-meaning =
    As posições foram giradas e as normais não: uma só rotação faz todas concordarem com as faces. A luz parece vir de
    outro lado, em comparação com outros objetos.
rotated-normals-advice = Calcule as normais, ou gire-as como as posições.

untransformed-normals-title = os vetores normais estão em um sistema de coordenadas diferente do das posições
untransformed-normals-meaning =
    Eles estão no espaço do mundo ou no espaço de outro nó, e o visualizador os transforma mais uma vez. A luz parece
    vir de outro lado, ou desliza sobre uma forma redimensionada.
untransformed-normals-advice = Calcule-os: o resultado está no espaço da malha.

stray-normals-title = vetores normais isolados diferem de todos os outros
stray-normals-meaning =
    Eles não seguem a receita dos outros, e nenhuma face em torno do vértice os explica. A superfície mostra um amassado
    ou uma saliência que não tem.
stray-normals-advice = Calcule-os com o peso e o ângulo de vinco dos outros vetores normais.

custom-normals-title = vetores normais que nenhum peso reproduz
custom-normals-meaning =
    Eles foram transferidos de uma malha mais fina, editados manualmente ou feitos a partir de arestas marcadas. Não
    estão errados; recalculá-los mudaria a imagem.
custom-normals-advice = Mantenha-os: `--when missing` e `--when broken` não os alteram.

faceted-normals-title = normais de face em uma forma suave
faceted-normals-meaning =
    Cada face tem um vetor normal próprio, embora os ângulos diedros da maioria das arestas sejam pequenos: cada faceta é
    visível.
faceted-normals-advice =
    Calcule normais suaves, a menos que as facetas sejam intencionais. Um STL, que só armazena normais de faces, sempre
    parece facetado e não é relatado: converta-o com `crease normals part.stl -o part.glb`.

soft-normals-title = normais suaves em uma forma com arestas vivas
soft-normals-meaning =
    Quase todas as arestas com ângulo diedro acima de 50° têm um só vetor normal dos dois lados. Lados planos mostram
    gradientes perto das arestas e parecem inflados.
soft-normals-advice = Calcule as normais com um ângulo de vinco, a menos que a malha deva parecer macia.

coarse-normals-title = normais gravadas com baixa precisão
coarse-normals-meaning =
    Todas estão em uma mesma grade: componentes com poucas casas decimais ou poucos bits, ou códigos octaédricos. Um
    brilho especular estreito se move em degraus sobre superfícies suaves, e reflexos parecem de metal martelado.
coarse-normals-advice =
    Recalcule-as se o material for brilhante, e grave-as como ponto flutuante ou inteiros de 16 bits
    (`--normal-format` em glTF).

tangents-off-normals-title = tangentes que não concordam com os vetores normais
tangents-off-normals-meaning =
    Uma tangente é perpendicular ao vetor normal, tem comprimento 1, e seu sinal de orientação é 1 ou −1; estas não. O
    relevo dos mapas de normais é iluminado do lado errado, e as costuras são visíveis.
tangents-off-normals-advice = Recalcule ambos.

wrong-morph-normals-title = vetores normais de formas deformadas que não concordam com a forma
wrong-morph-normals-meaning =
    Com o peso total do alvo de deformação, o vetor normal fica longe do que as faces deformadas dão. A superfície se
    move, e a tonalização não acompanha.
wrong-morph-normals-advice = Calcule-os: as normais dos alvos são calculadas junto com as da malha.

averaged-crease-title = arestas vivas com um só vetor normal dos dois lados
averaged-crease-meaning =
    O ângulo diedro dessas arestas excede o ângulo de vinco da malha em mais de 10°. Faces planas mostram um gradiente
    perto da aresta, e o canto parece inflado.
averaged-crease-advice = Calcule as normais com um ângulo de vinco menor que o ângulo diedro dessas arestas.

split-seam-title = arestas suaves com vetores normais diferentes dos dois lados
split-seam-meaning =
    A superfície é suave nessas arestas, que ficam em uma costura de textura, entre duas primitivas ou onde malhas foram
    unidas. Vê-se uma linha onde a superfície não tem nenhuma.
split-seam-advice = Calcule as normais: arestas coincidentes são unidas para a média, e os vértices ficam separados.

needless-seam-title = costuras com vetores normais iguais dos dois lados
needless-seam-meaning =
    Posição, vetor normal e coordenadas de textura são iguais dos dois lados, mas há dois vértices. Nenhuma imagem
    mostra isso; custa memória, e programas que usam índices não suavizam através da costura.
needless-seam-advice = Una os vértices em um programa de modelagem; as normais estão corretas.

cracked-seam-title = arestas separadas pelo arredondamento de seus vértices
cracked-seam-meaning =
    Duas arestas abertas distam menos de um milionésimo da diagonal da caixa envolvente, mas não são iguais. Programas
    que comparam posições exatas tonalizam os dois lados em separado: vê-se uma linha.
cracked-seam-advice = Calcule as normais com essas arestas unidas (`--weld`); os vértices não mudam.

group-mismatch-title = grupos de suavização e vetores normais se contradizem
group-mismatch-meaning =
    Os grupos pedem suavização onde as normais são separadas, ou aresta viva onde são comuns. Um programa que usa grupos
    mostra uma forma diferente da de um que usa normais.
group-mismatch-advice = Calcule as normais a partir dos grupos, ou ignore os grupos.

no-faces-title = um arquivo sem faces
no-faces-meaning = Há só pontos ou linhas, portanto nenhuma superfície com vetores normais. A imagem fica vazia.
no-faces-advice =
    Verifique a origem da exportação: as faces podem ter sido omitidas, ou ser de um tipo que não é lido.

inconsistent-winding-title = faces com orientação oposta à das vizinhas
inconsistent-winding-meaning =
    Seus cantos estão na ordem oposta à das faces vizinhas. O descarte de faces traseiras mostra buracos ali; sem ele,
    elas são iluminadas por trás, e as médias das normais se cancelam.
inconsistent-winding-advice = Inverta-as, para que as vizinhas concordem.

non-orientable-title = superfícies com um só lado
non-orientable-meaning =
    Suas faces não podem ter todas a mesma orientação, como em uma faixa de Möbius. Onde as duas orientações se
    encontram, a tonalização salta de um lado para o outro.
non-orientable-advice = Corte-as ao longo de uma linha, ou desenhe-as com dois lados e normais de face.

inside-out-title = superfícies fechadas com orientação invertida
inside-out-meaning =
    O volume com sinal tem o sinal errado: negativo em um sólido, positivo em uma cavidade dele. Com descarte de faces
    traseiras, vê-se o lado oposto por dentro; com iluminação, o lado voltado para a luz é escuro.
inside-out-advice = Inverta suas faces, a menos que elas devam ser vistas por dentro.

open-inside-out-title = superfícies abertas cuja frente é o lado menos visível
open-inside-out-meaning =
    Uma superfície aberta não tem interior, mas em geral tem um lado externo: aquele de onde escapam mais raios. Com
    descarte de faces traseiras, vê-se através da superfície por fora.
open-inside-out-advice = Inverta suas faces, a menos que elas devam ser vistas desse lado.

room-title = superfícies fechadas voltadas para dentro, em torno de outras superfícies
room-meaning =
    A superfície e a maioria de seus vetores normais estão voltados para dentro, e objetos no interior estão voltados
    para fora. Vista por dentro, ela parece correta.
room-advice =
    Nada a fazer se for uma sala; se for um sólido com cavidades, inverta tudo com `crease normals --flip`.

zero-area-faces-title = faces sem área
zero-area-faces-meaning =
    Elas não têm direção e não são visíveis. Programas que normalizam seu vetor normal nulo espalham números inválidos
    para as vizinhas.
zero-area-faces-advice = Remova essas faces.

faces-below-storage-title = faces mais finas que o arredondamento de suas coordenadas
faces-below-storage-meaning =
    Sua direção é ruído do arredondamento do arquivo. Elas não são visíveis, mas, se entram nas médias, os vetores
    normais de alguns cantos têm direções aleatórias.
faces-below-storage-advice =
    Nada a fazer para o crease, que ignora essas faces nas médias; outros programas podem não ignorá-las.

needle-faces-title = faces longas e finas
needle-faces-unit = de largura por unidade de comprimento
needle-faces-meaning =
    A largura é menor que um milésimo do comprimento. O arredondamento gira seus vetores normais por ângulos grandes,
    valores interpolados saltam através delas, e elas piscam em movimento.
needle-faces-advice = Refaça a malha com faces de melhor forma no programa de modelagem.

duplicate-faces-title = faces duplicadas
duplicate-faces-meaning =
    Elas têm os mesmos cantos na mesma ordem. As duas disputam cada pixel onde a tonalização difere, e a suavização
    termina em suas arestas.
duplicate-faces-advice = Remova as cópias no programa de modelagem.

back-to-back-faces-title = faces de costas para outra face
back-to-back-faces-meaning =
    Elas têm os mesmos cantos na ordem oposta: uma folha com dois lados. Sem descarte de faces traseiras, as duas
    disputam cada pixel, e as médias de suas normais se cancelam.
back-to-back-faces-advice = Mantenha uma delas e desenhe-a com dois lados, se o renderizador puder.

duplicate-vertices-title = vértices com posições e atributos iguais
duplicate-vertices-meaning =
    Coordenadas de textura, cores, material e objeto são iguais, como a posição, e não há vetores normais. Programas
    que usam índices mostram a aresta como viva.
duplicate-vertices-advice =
    Una os vértices em um programa de modelagem, a menos que marquem arestas vivas; o crease suaviza através deles.

non-planar-polygons-title = polígonos não planos
non-planar-polygons-meaning =
    A escolha dos dois triângulos de um quadrilátero muda sua forma e sua tonalização, e os programas escolhem de modos
    diferentes.
non-planar-polygons-advice = Triangule-os no programa de modelagem, para que todos os programas concordem.

concave-polygons-title = polígonos côncavos
concave-polygons-meaning =
    Programas que cortam polígonos em leques põem triângulos fora deles. Veem-se cunhas escuras e sobreposições.
concave-polygons-advice = Triangule-os no programa de modelagem.

crossed-polygons-title = polígonos com arestas que se cruzam
crossed-polygons-meaning =
    Uma parte fica voltada para cima e a outra para baixo, portanto nenhum vetor normal vale para o polígono inteiro. Uma
    parte dele é iluminada por trás.
crossed-polygons-advice = Corrija a ordem de seus cantos.

non-manifold-edges-title = arestas com mais de duas faces
non-manifold-edges-unit = faces em uma aresta
non-manifold-edges-meaning =
    É ambíguo quais faces continuam umas às outras, portanto nada é suavizado através da aresta. Vê-se um vinco ali.
non-manifold-edges-advice = Separe as folhas no programa de modelagem, se a linha não for desejada.

pinched-vertices-title = vértices em que leques separados de faces se tocam
pinched-vertices-meaning =
    Vários leques de faces têm o vértice em comum. Um programa que lhe dá um só vetor normal mistura superfícies
    independentes.
pinched-vertices-advice =
    Nada a fazer para `crease normals`, que dá a cada leque um vetor normal; para outros programas, separe os vértices.

folded-edges-title = arestas em que a superfície se dobra sobre si mesma
folded-edges-meaning =
    As duas faces ficam uma sobre a outra. Um vetor normal suavizado através da dobra não serve a nenhuma delas, e a
    tonalização se rompe ao longo da aresta.
folded-edges-advice = Mantenha essas arestas vivas, ou remova a sobreposição.

cancelling-fans-title = cantos em que as normais das faces se cancelam
cancelling-fans-meaning =
    As faces em torno do vértice apontam em todas as direções, portanto a média não tem direção. Programas gravam zero
    ou ruído ali: um ponto preto ou que pisca.
cancelling-fans-advice =
    Verifique as faces dobradas nesse lugar; `crease normals` grava um vetor normal substituto e o conta.

high-valence-poles-title = vértices com muitas faces
high-valence-poles-unit = faces em um vértice
high-valence-poles-meaning =
    A tonalização em torno desse polo mostra uma estrela, porque cada face fina interpola em separado.
high-valence-poles-advice = Refaça a tampa de outro modo, por exemplo como uma grade.

far-from-origin-title = a malha está longe demais da origem para seu nível de detalhe
far-from-origin-meaning =
    Visualizadores guardam posições em 32 bits: a essa distância, restam poucos bits para o tamanho de uma face.
    Vetores normais calculados ali são errados, e a tonalização pisca mesmo com normais corretas.
far-from-origin-advice = Mova a malha para a origem e ponha a distância em seu nó.

mirrored-node-title = um nó que espelha sua malha
mirrored-node-meaning =
    Sua matriz tem determinante negativo, portanto o visualizador precisa inverter a orientação das faces. Um que não o
    faz mostra a malha do avesso, com vetores normais e tangentes invertidos.
mirrored-node-advice = Nada a fazer se seus visualizadores tratam isso; senão, aplique o espelhamento à malha.

singular-node-title = um nó que achata sua malha
singular-node-meaning =
    Sua matriz não tem inversa, portanto os vetores normais não podem ser transformados. Eles se tornam zero ou deixam
    de ser números, e a malha fica preta.
singular-node-advice = Dê ao nó uma escala diferente de zero em cada eixo.

shading-terminator-title = vetores normais longe de sua face
shading-terminator-meaning =
    Para uma luz entre as duas direções, o vetor normal é iluminado e a face não, ou o contrário. Ao longo da borda da
    sombra, a superfície se divide em triângulos.
shading-terminator-advice = Use faces menores ali, ou um vinco.

mach-bands-title = arestas suaves com uma quebra visível da luminância
mach-bands-unit = níveis de cinza por pixel
mach-bands-meaning =
    A luminância interpolada muda de inclinação na aresta, o que se vê como uma linha clara ou escura ao longo dela.
mach-bands-advice = Use mais faces onde a superfície se curva, ou tonalização de Phong em vez de Gouraud.

coarse-outline-title = arestas que tornam o contorno poligonal
coarse-outline-unit = pixels
coarse-outline-meaning =
    Contra o fundo, a aresta se afasta da curva dos vetores normais mais que o limite. A tonalização parece redonda e o
    contorno poligonal.
coarse-outline-advice = Use mais faces onde a superfície se curva.

lost-highlight-title = faces grandes demais para o brilho especular
lost-highlight-meaning =
    Os vetores normais nos cantos da face diferem mais que a largura do brilho especular. Com tonalização de Gouraud, o brilho especular
    desaparece dentro da face e, em movimento, salta de canto em canto.
lost-highlight-advice = Use tonalização de Phong, ou mais faces.
