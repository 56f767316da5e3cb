title = A escolha da diagonal muda as cores
claim = A interpolação linear dá resultados distintos para diferentes triangulações do mesmo polígono.
source-1 = Ting 2008: “resultados distintos para diferentes triangulações”
source-2 = Aulas: exercício 1.6.25 (o losango)
formula-1 = {"c_{13} = \\frac{c_1 + c_3}{2}, \\quad c_{24} = \\frac{c_2 + c_4}{2}"}
formula-1-says =
    cor no meio do losango com a diagonal do canto 1 (direito) ao 3 (esquerdo), ou do 2 (de cima) ao 4 (de baixo)
formula-2 = {"c = \\frac{c_1 + c_2 + c_3 + c_4}{4}"}
formula-2-says = cor no meio com um vértice a mais ali, que tem a cor média
formula-3 = {"|ΔI| = O(h^2)"}
formula-3-says =
    numa superfície lisa, as duas diagonais de um quadrado de lado h diferem no meio por h²/2 vezes a derivada segunda
    mista, e menos no resto
shown-by =
    Para mostrá-lo nas ondas, use menos quadrados (--segments) e luz lateral. O losango o mostra sob qualquer luz.
diamond-by = média desses cantos; tolerância: meia diagonal de pixel
diamond-change-measure = losango: maior diferença no meio
waves-gouraud-measure = ondas, Gouraud: diferença entre as diagonais (rms)
waves-phong-measure = ondas, Phong: diferença entre as diagonais (rms)
waves-effect = luz nas ondas: erro em relação à superfície exata (rms)
diamond-effect = cor no meio: diferença em relação à média de todos os cantos
holds =
    sempre que os valores dos cantos não estiverem num mesmo plano. As cores dos triângulos não mudam quando o polígono
    gira, mas a diagonal escolhida é visível. Em superfícies lisas, a diferença cai com o quadrado do tamanho das
    facetas.
waves-rising-title = ondas, diagonais transversais
waves-rising-caption =
    Ondas oblíquas com tonalização de Gouraud. A diagonal de cada quadrado atravessa as ondas, do canto inferior
    esquerdo ao superior direito.
waves-rising-seen = As listras se desfazem em contas.
waves-falling-title = ondas, diagonais longitudinais
waves-falling-caption = Os mesmos vértices e normais; as diagonais seguem ao longo das ondas.
waves-falling-seen = As listras são retas, mas menos suaves que as das ondas exatas.
waves-difference-title = diferença
waves-difference-caption = Diferença entre as duas imagens: violeta é 0, amarelo é { $full } ou mais.
waves-fine-title = ondas, mais finas
waves-fine-caption = Diagonais transversais, com quatro vezes mais quadrados por lado.
waves-fine-seen = As diagonais quase não são visíveis.
waves-themselves-title = ondas exatas
waves-themselves-caption = A superfície com a normal exata em cada pixel.
diamond-1-3-title = losango, diagonal 1–3
diamond-1-3-caption = A diagonal liga o canto direito ao esquerdo.
diamond-1-3-seen = Há uma faixa horizontal clara.
diamond-2-4-title = losango, diagonal 2–4
diamond-2-4-caption = A diagonal liga o canto de cima ao de baixo.
diamond-2-4-seen = Há uma faixa vertical em oliva-escuro, e a cor no meio é outra.
diamond-fan-title = losango, vértice no meio
diamond-fan-caption = Quatro triângulos em torno de um vértice com a cor média dos cantos.
diamond-fan-seen = Nenhuma diagonal é favorecida.
note-1 =
    Cada triângulo usa três dos quatro cantos, e por isso só as duas pontas da diagonal determinam as cores ao longo
    dela. O algoritmo de varredura no polígono inteiro não favorece nenhuma diagonal, mas depende da rotação do polígono
    (veja o experimento `orientation`). O efeito é medido em relação à superfície exata, pois as duas triangulações têm
    erros. Ao menos um dos dois erros é pelo menos metade da diferença entre as duas triangulações.
order-measure = ondas: ordem da diferença em h
order-of-black-slopes =
    não comparado com O(h²): as encostas de costas para a luz são pretas, e a luminância tem uma quebra nas bordas delas
order-below-precision = não comparado com O(h²): a diferença dos quadrados mais finos é próxima da precisão simples
order-below-pixels = não comparado com O(h²): os quadrados mais finos são menores que dois pixels
order-of-coarse-squares = não comparado com O(h²): os quadrados por onda não bastam
order-by = O(h²); tolerância: facetas de 1/12 de onda ainda não são pequenas
difference-by-cells-title = Diferença entre as duas diagonais
difference-by-cells-caption =
    Diferença nas ondas em função do número de quadrados por lado. Com muitos quadrados, ela cai com o inverso do
    quadrado desse número.
difference-by-cells-x = quadrados por lado
difference-by-cells-y = diferença rms
measured-curve = medido
law-curve = h², h = 1/número
waves-cure = { $finer } vezes mais quadrados por lado
diamond-cure = um vértice no meio
diamond-measure = { $cut }: { $colour } no meio
red = vermelho
green = verde
blue = azul
waves-rising-measure = ondas, diagonais transversais: erro da luz em relação à superfície exata (rms)
waves-falling-measure = ondas, diagonais longitudinais: erro da luz em relação à superfície exata (rms)
waves-fine-measure = ondas, diagonais transversais, mais finas: erro da luz em relação à superfície exata (rms)
