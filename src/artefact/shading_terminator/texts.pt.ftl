title = A sombra própria das facetas deixa o terminador serrilhado
claim =
    Tonalização e geometria discordam onde a normal interpolada aponta para a luz, mas a faceta não. Se as facetas têm
    sombra própria, o terminador segue as arestas delas, e facetas inteiras acendem ou apagam de repente quando a luz se
    move.
source-1 = Artigo: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks
source-2 = Aulas: 1.5.2.2, 1.6.13 (erros das normais nos vértices, que a tonalização de Phong mantém)
formula-1 = {"N·L > 0 ≥ N_g·L"}
formula-1-says = condição para um pixel ser afetado: N é a normal interpolada, N_g a normal da faceta
formula-2 = {"G = −g^3 + g^2 + g, \\quad g = \\frac{N_g·L}{(N·L) (N_g·N)}"}
formula-2-says =
    fator de Chiang, Li e Burley para 0 ≤ g < 1; abaixo desse intervalo ele é 0 e acima é 1. A luz se apaga aos poucos
    quando a faceta vira de costas para ela
formula-3 = {"ΔI = \\sin(Δ/2)"}
formula-3-says = mudança súbita de luminância sem esse fator, na aresta clara de uma faceta de ângulo Δ
shown-by = Use luz lateral (--light 80) e no máximo 16 segmentos para mostrá-lo.
shadow-effect = erro médio da luz nos pixels afetados, em relação à esfera exata
shadow-cure = sem sombra própria
cost-effect = maior redução da luz pelo termo de suavização num pixel
cost-cure = facetas mais finas
pop-cure = termo de suavização de Chiang, Li e Burley
pop-hard-by = a fórmula no centro de cada pixel em precisão dupla; tolerância: arestas ajustadas a 1/256 de pixel
prism-share-measure = prisma: parcela de pixels afetados
prism-share-by =
    os dois cossenos no centro de cada pixel em precisão dupla; tolerância: pixels com aresta ou mudança de sinal a
    menos de 1/256 de pixel
sphere-share-measure = esfera: parcela de pixels afetados
sphere-shadow-measure = esfera: máximo de luz que a sombra própria retira de um pixel
holds-only-if =
    as facetas tiverem sombra própria, como quando há sombras projetadas. Sem sombras, como nas aulas, a luz em facetas
    de costas para ela não é um erro visível. O termo de suavização remove as mudanças súbitas, mas não os cantos do
    terminador, e escurece facetas iluminadas obliquamente. Os dois erros caem com o tamanho das facetas.
hard-title = com sombra própria
hard-caption = Normais lisas, mas as facetas de costas para a luz são escuras.
hard-seen = O terminador é uma linha serrilhada ao longo das arestas dos triângulos.
smooth-title = sem sombra própria
smooth-caption = Só as normais interpoladas determinam a luz, como nas aulas.
smooth-seen = O terminador é liso; facetas de costas para a luz também são iluminadas.
concerned-title = pixels afetados
concerned-caption = Amarelo onde a normal interpolada aponta para a luz, mas a faceta não.
film-hard-title = luz gira: faceta apaga
film-hard-caption =
    Um prisma em imagens sucessivas, de cima para baixo. A luz gira { $step }° de uma imagem para a outra.
film-hard-seen =
    A faceta à esquerda do meio está iluminada nas quatro imagens de cima e preta nas quatro de baixo: ela se apaga de
    uma vez.
film-soft-title = suavizado: faceta esmaece
film-soft-caption = As mesmas imagens com o termo de suavização.
film-soft-seen = A faceta escurece de imagem em imagem, sem mudança súbita.
soft-title = suavizado, mesma malha
soft-caption = O custo do termo de suavização.
soft-seen =
    Facetas iluminadas obliquamente são escuras demais, e por isso as facetas são visíveis também na parte iluminada.
    Uma imagem estática não se beneficia do termo.
soft-fine-title = suavizado, mais fino
soft-fine-caption = A esfera com { $finest } segmentos e o termo de suavização.
note-1 =
    O fator é contínuo. Ele é 0 onde o cosseno da faceta, N_g·L, é 0. Ele é 1 onde esse cosseno é ao menos (N·L)
    (N_g·N). Ele depende só das duas normais e da luz.
note-2 =
    Há três luzes. A luz da esfera está { $light }° ao lado do observador e 25° acima dele, e por isso o terminador
    cruza facetas obliquamente. A luz para contar pixels do prisma também está a { $light }°, mas na horizontal; se o
    terminador do prisma não é visível, nenhum pixel é afetado. A luz dos filmes é horizontal e gira para os dois lados do
    ângulo em que a faceta à esquerda do meio vira de costas para ela.
smooth-curve = só a normal interpolada
soft-curve = suavizado
popping-title = Uma faceta quando a luz gira
popping-caption =
    Luminância na aresta clara de uma faceta em função do ângulo da luz. Onde a faceta vira de costas para a luz, a
    luminância cai de uma vez; com o termo de suavização, ela cai aos poucos.
popping-x = ângulo da luz em graus
popping-y = luminância
hard-curve = { hard-title }
pop-soft-by = { pop-hard-by }
pop-effect = prisma: maior mudança numa faceta quando a luz gira { $turn }°
pop-hard-measure = prisma, luz girada { $turn }°: maior mudança numa faceta, com sombra própria
pop-soft-measure = prisma, luz girada { $turn }°: maior mudança numa faceta, com suavização
fine-sphere-share-measure = esfera com { $finest } segmentos: parcela de pixels afetados
soft-fine-seen = As facetas são pouco maiores que pixels, e o terminador é liso.
