title = O terminador de sombreamento
claim =
    Onde as normais interpoladas ainda olham para a luz e a própria faceta já não, sombreamento e geometria discordam.
    Se as facetas se sombreiam, a fronteira da luz corre pelas arestas, e facetas inteiras saltam quando a luz se move.
source-1 = Artigo: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks
source-2 = Aulas: 1.5.2.2, 1.6.13 (erros das normais nos vértices que o sombreamento de Phong mantém)
formula-1 = {"N·L > 0 ≥ N_g·L"}
formula-1-says = os pixels em questão: N interpolada, N_g a da faceta
formula-2 = {"G = −g^3 + g^2 + g, \\quad g = \\frac{N_g·L}{(N·L) (N_g·N)}"}
formula-2-says =
    o fator de Chiang, Li e Burley para 0 ≤ g < 1, 0 abaixo e 1 a partir de 1: a luz se apaga aos poucos quando a faceta
    se vira
formula-3 = {"ΔI = \\sin(Δ/2)"}
formula-3-says = quanto uma faceta de ângulo Δ acende de uma vez sem ele, na aresta clara
shown-by = luz de lado (--light 80), em não mais que 16 segmentos, o mostraria.
shadow-effect = erro médio da luz em relação à própria esfera, nos pixels em questão
shadow-cure = nenhuma sombra própria
cost-effect = máximo de luz que a suavização tira de um pixel
cost-cure = facetas mais finas
pop-cure = o termo de suavização de Chiang, Li e Burley
pop-hard-by = a fórmula no centro de cada pixel em precisão dupla; arestas ajustadas a 1/256 pixel
prism-share-measure = prisma: parcela dos pixels em questão
prism-share-by =
    os dois cossenos no centro de cada pixel em precisão dupla; pixels com aresta ou mudança de sinal a menos de 1/256
    pixel
sphere-share-measure = esfera: parcela dos pixels em questão
sphere-shadow-measure = esfera: máximo de luz que a sombra própria das facetas tira de um pixel
holds-only-if =
    as facetas se sombreiam, como fazem onde há sombras projetadas. Sem sombras, como nas aulas, a luz em facetas
    viradas não é defeito visível. O termo de suavização tira os saltos, não os cantos da fronteira, e escurece facetas
    iluminadas de lado: ambos somem com malhas mais finas, com o tamanho das facetas.
hard-title = facetas se sombreiam
hard-caption = Normais lisas, mas a luz termina onde as facetas se viram.
hard-seen = A fronteira é um serrote de triângulos.
smooth-title = sem sombra própria
smooth-caption = Só as normais interpoladas decidem, como nas aulas.
smooth-seen = Liso, com luz em facetas viradas para longe.
concerned-title = pixels em questão
concerned-caption = Amarelo onde a normal interpolada olha para a luz e a faceta não.
film-hard-title = a luz gira: salta
film-hard-caption = Um prisma de imagem em imagem, para baixo: a luz gira { $step }° de cada vez.
film-hard-seen =
    A faceta à esquerda do meio tem luz nas quatro de cima e é preta nas quatro de baixo: apaga-se de uma vez.
film-soft-title = suavizado: esmaece
film-soft-caption = O mesmo com o termo de suavização.
film-soft-seen = A faceta escurece de imagem em imagem, e nada salta.
soft-title = suavizado, mesma malha
soft-caption = O que custa o termo de suavização.
soft-seen =
    Facetas que estão para se virar já são escuras, e aparecem até na luz. Uma imagem parada nada ganha com ele.
soft-fine-title = suavizado, mais fino
soft-fine-caption = { $finest } segmentos e o termo de suavização.
note-1 =
    O fator é contínuo: vale 0 onde o cosseno da própria faceta, N_g·L, é 0, e 1 onde este é ao menos (N·L) (N_g·N).
    Precisa só das duas normais.
note-2 =
    Há três luzes. A da esfera vem de { $light }° ao lado do observador e 25° acima, de modo que a sua fronteira cruza
    facetas de viés. Aquela em que se contam pixels do prisma vem também de { $light }°, mas horizontal: quando a
    fronteira do prisma não se vê, nenhum está em questão. A dos filmes é horizontal e gira em torno do ângulo em que a
    faceta à esquerda do meio se vira.
smooth-curve = só a normal interpolada
soft-curve = suavizado
popping-title = Uma faceta quando a luz gira
popping-caption =
    Luminância na aresta clara de uma faceta em função do ângulo da luz: onde a faceta se vira, ela se apaga de uma vez;
    suavizada, esmaece.
popping-x = ângulo da luz em graus
popping-y = luminância
hard-curve = { hard-title }
pop-soft-by = { pop-hard-by }
pop-effect = prisma: maior mudança numa faceta quando a luz gira { $turn }°
pop-hard-measure = prisma, luz girada de { $turn }°: maior mudança numa faceta, dura
pop-soft-measure = prisma, luz girada de { $turn }°: maior mudança numa faceta, suavizada
fine-sphere-share-measure = esfera com { $finest } segmentos: parcela dos pixels em questão
soft-fine-seen = As facetas quase não são maiores que pixels, e a fronteira é lisa.
