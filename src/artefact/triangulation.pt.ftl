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
by-mean-these-corners = a média desses cantos; meia diagonal de pixel
measure-diamond-largest-difference = losango: maior diferença do meio
measure-waves-gouraud-difference = ondas, Gouraud: diferença das diagonais (rms)
measure-waves-phong-difference = ondas, Phong: diferença das diagonais (rms)
moved = luz nas ondas, diferença à da própria superfície (rms)
moved-colour-middle-off = cor do meio, diferença à média de todos os cantos
holds-wherever-corners-values =
    sempre que os valores dos cantos não estão num plano. As cores dos triângulos não mudam quando o polígono gira, mas
    o seu corte aparece; em superfícies lisas a diferença cai com o quadrado do tamanho das facetas.
waves-rising-title = ondas, cortadas de través
waves-rising-caption-slanting-waves-gouraud =
    Ondas oblíquas com Gouraud; cada quadrado é cortado de través, do canto inferior esquerdo ao superior direito.
waves-rising-caption-they-fall-into = Elas se desfazem em contas.
waves-falling-title = ondas, cortadas ao longo
waves-falling-caption-same-vertices-normals =
    Os mesmos vértices e normais; só as diagonais vão no outro sentido, ao longo das ondas.
waves-falling-caption-stripes-straight-but = As listras são retas, mas não tão suaves quanto as das próprias ondas.
waves-difference-title = diferença
waves-difference-caption-how-much-both = Quanto as duas diferem, de violeta para 0 a amarelo para { $full } ou mais.
waves-fine-title = ondas, mais finas
waves-fine-caption-cut-across-first = Cortadas de través como as primeiras, com quatro vezes mais quadrados por lado.
waves-fine-caption-cut-hardly-seen = O corte quase não se vê mais.
waves-themselves-title = as próprias ondas
waves-themselves-caption-surface-own-normal = A superfície com a sua própria normal em cada pixel.
diamond-1-3-title = losango, corte 1–3
diamond-1-3-caption-cut-right-left = Cortado do canto direito ao esquerdo.
diamond-1-3-caption-light-band-runs = Uma faixa clara corre na horizontal.
diamond-2-4-title = losango, corte 2–4
diamond-2-4-caption-cut-upper-lower = Cortado do canto de cima ao de baixo.
diamond-2-4-caption-dark-olive-band = Uma faixa oliva escura corre na vertical, e o meio tem outra cor.
diamond-fan-title = losango, vértice no meio
diamond-fan-caption-four-triangles-about = Quatro triângulos em torno de um vértice com a média dos cantos.
diamond-fan-caption-no-diagonal-preferred = Nenhuma diagonal é preferida.
note-each-triangles-knows =
    Cada um dos dois triângulos nada sabe do quarto canto: ao longo da diagonal só contam as suas pontas. O algoritmo de
    varredura no polígono inteiro não prefere diagonal, mas depende de como o polígono está girado (veja o experimento
    sobre orientação). O número que mudou é quanto a luz nos triângulos difere da luz da própria superfície, pois os
    dois cortes erram: ao menos um deles por metade do que diferem.
measure-waves-order-difference = ondas: ordem da diferença em h
untested-not-held-against =
    não comparado com O(h²): encostas viradas para longe da luz são pretas, e a luz tem uma quebra nas suas bordas
untested-not-held-against-o = não comparado com O(h²): os quadrados mais finos diferem por pouco mais que a precisão simples
untested-not-held-against-o-h = não comparado com O(h²): os quadrados mais finos são menores que dois pixels
untested-not-held-against-o-h-few = não comparado com O(h²): tão poucos quadrados por onda não são pequenos
by-o-h-facets = O(h²); facetas de um doze avos de onda ainda não são pequenas
chart-title = Diferença das duas diagonais
chart-caption =
    A diferença nas ondas em função do número de quadrados por lado: quanto mais há, mais ela cai como um sobre o seu
    quadrado.
chart-caption-difference-waves-against =
    A diferença nas ondas em função do número de quadrados por lado, junto a um sobre o seu quadrado.
axis-squares-along-side = quadrados por lado
axis-rms-difference = diferença rms
curve-measured = medido
curve-h-h-number = como h², h = 1/número
