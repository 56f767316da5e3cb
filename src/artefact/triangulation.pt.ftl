title = Diagonais diferentes
claim = A interpolação linear dá resultados distintos para diferentes triangulações do mesmo polígono.
source-1 = Ting 2008: “resultados distintos para diferentes triangulações”
source-2 = Aulas: exercício 1.6.25, cujo losango é usado
formula-1 = {"c_{13} = \\frac{c_1 + c_3}{2}, \\quad c_{24} = \\frac{c_2 + c_4}{2}"}
formula-1-says = a cor no meio do losango, cortado do canto 1 (direito) ao 3 (esquerdo) ou do 2 (acima) ao 4 (abaixo)
formula-2 = {"c = \\frac{c_1 + c_2 + c_3 + c_4}{4}"}
formula-2-says = com um vértice da cor média no meio, seja como for cortado
formula-3 = {"|ΔI| = O(h^2)"}
formula-3-says =
    numa superfície lisa as duas diagonais de um quadrado de lado h diferem no meio por h²/2 vezes a derivada segunda
    mista, e menos no resto
shown-by = menos quadrados (--segments), e luz de lado, o mostrariam nas ondas; o losango o mostra sob qualquer luz.
diamond-by = a média desses cantos; meia diagonal de pixel
diamond-change-measure = losango: maior diferença do meio
waves-gouraud-measure = ondas, Gouraud: diferença das diagonais (rms)
waves-phong-measure = ondas, Phong: diferença das diagonais (rms)
waves-effect = luz nas ondas, diferença à da própria superfície (rms)
diamond-effect = cor do meio, diferença à média de todos os cantos
holds =
    sempre que os valores dos cantos não estão num plano. As cores dos triângulos não mudam quando o polígono gira, mas
    o seu corte aparece; em superfícies lisas a diferença cai com o quadrado do tamanho das facetas.
waves-rising-title = ondas, cortadas de través
waves-rising-caption =
    Ondas oblíquas com Gouraud; cada quadrado é cortado de través, do canto inferior esquerdo ao superior direito.
waves-rising-seen = Elas se desfazem em contas.
waves-falling-title = ondas, cortadas ao longo
waves-falling-caption =
    Os mesmos vértices e normais; só as diagonais vão no outro sentido, ao longo das ondas.
waves-falling-seen = As listras são retas, mas não tão suaves quanto as das próprias ondas.
waves-difference-title = diferença
waves-difference-caption = Quanto as duas diferem, de violeta para 0 a amarelo para { $full } ou mais.
waves-fine-title = ondas, mais finas
waves-fine-caption = Cortadas de través como as primeiras, com quatro vezes mais quadrados por lado.
waves-fine-seen = O corte quase não se vê mais.
waves-themselves-title = as próprias ondas
waves-themselves-caption = A superfície com a sua própria normal em cada pixel.
diamond-1-3-title = losango, corte 1–3
diamond-1-3-caption = Cortado do canto direito ao esquerdo.
diamond-1-3-seen = Uma faixa clara corre na horizontal.
diamond-2-4-title = losango, corte 2–4
diamond-2-4-caption = Cortado do canto de cima ao de baixo.
diamond-2-4-seen = Uma faixa oliva escura corre na vertical, e o meio tem outra cor.
diamond-fan-title = losango, vértice no meio
diamond-fan-caption = Quatro triângulos em torno de um vértice com a média dos cantos.
diamond-fan-seen = Nenhuma diagonal é preferida.
note-1 =
    Cada um dos dois triângulos nada sabe do quarto canto: ao longo da diagonal só contam as suas pontas. O algoritmo de
    varredura no polígono inteiro não prefere diagonal, mas depende de como o polígono está girado (veja o experimento
    sobre orientação). O número que mudou é quanto a luz nos triângulos difere da luz da própria superfície, pois os
    dois cortes erram: ao menos um deles por metade do que diferem.
order-measure = ondas: ordem da diferença em h
order-of-black-slopes =
    não comparado com O(h²): encostas viradas para longe da luz são pretas, e a luz tem uma quebra nas suas bordas
order-below-precision = não comparado com O(h²): os quadrados mais finos diferem por pouco mais que a precisão simples
order-below-pixels = não comparado com O(h²): os quadrados mais finos são menores que dois pixels
order-of-coarse-squares = não comparado com O(h²): tão poucos quadrados por onda não são pequenos
order-by = O(h²); facetas de um doze avos de onda ainda não são pequenas
difference-by-cells-title = Diferença das duas diagonais
difference-by-cells-caption =
    A diferença nas ondas em função do número de quadrados por lado: quanto mais há, mais ela cai como um sobre o seu
    quadrado.
difference-by-cells-x = quadrados por lado
difference-by-cells-y = diferença rms
measured-curve = medido
law-curve = como h², h = 1/número
waves-cure = { $finer } vezes mais quadrados por lado
diamond-cure = um vértice no meio
diamond-measure = { $cut }: { $colour } no meio
red = vermelho
green = verde
blue = azul
waves-rising-measure = ondas, cortadas de través: luz, diferença à da própria superfície (rms)
waves-falling-measure = ondas, cortadas ao longo: luz, diferença à da própria superfície (rms)
waves-fine-measure = ondas, cortadas de través, mais finas: luz, diferença à da própria superfície (rms)
