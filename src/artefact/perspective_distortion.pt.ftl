title = Distorção de perspectiva
claim = Interpolar por igual na imagem é errado em perspectiva: passos iguais na tela não são passos iguais na superfície.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47
source-2 = J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992 (em inglês)
formula-1 = {"s(t) = \\frac{t}{t + ρ (1 − t)}"}
formula-1-says = o lugar s na superfície que se vê no lugar t da imagem, ambos de 0 a 1; ρ = z_longe/z_perto
formula-2 = {"\\max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"}
formula-2-says = o maior erro da interpolação uniforme; ½ passo de 255 assim que ρ > 1,0079 para cores de 0 a 1
shown-by = uma parede mais funda o mostraria.
nearest-pixel-single = (√ρ − 1)/(√ρ + 1); o pixel mais próximo de 4096, e precisão simples
measure-scanline = linha de varredura, ρ = 4
measure-perspective-correct = correta em perspectiva, ρ = 4
by-w-w-linear = a/w e 1/w são lineares na imagem
measure-affine-segments-segments = afim, { $segments } × { $segments } pedaços
by-nearest-piece-largest = o pedaço mais próximo tem a maior razão de profundidades, 1 + (ρ − 1)/n; o seu erro sobre n
measure-affine-pieces-pieces = afim, { $pieces } × { $pieces } pedaços: lugar na altura
by-much-across-diagonal = tanto quanto na largura, na diagonal de um pedaço; os pixels ficam ao lado dela
moved = maior erro do lugar na largura
cure = interpolação correta em perspectiva
holds-only-if-depths-triangle-corners =
    as profundidades dos cantos de um triângulo diferem sob projeção central. Em projeção paralela, ou de frente para o
    observador, os dois modos são o mesmo; e um erro menor que meio passo de 255 não se vê: profundidades a menos de 0,8
    % para cores de 0 a 1.
note-board-not-image =
    O tabuleiro não é uma imagem colada: dois números são interpolados entre os quatro cantos de uma face, os lugares na
    largura e na altura, e deles se tira a cor de cada quadrado. O que quer que se interpole, também cores e normais,
    erra do mesmo modo.
note-cut-into-more =
    Cortada em mais pedaços nos dois sentidos, cada um é menor e tem razão de profundidades menor: o erro cai com o
    quadrado do número deles ao longo de um lado. Dividir pela profundidade o faz sumir.
affine-title = afim
affine-caption-wall-runs-away = Uma parede que se afasta para a direita, até quatro vezes a profundidade.
affine-caption-interpolated-picture-squares =
    Interpolados na imagem, os quadrados quebram na diagonal e são tão largos longe quanto perto.
perspective-title = correta em perspectiva
perspective-caption-same-face-interpolated = A mesma face interpolada na cena.
perspective-caption-squares-become-smaller = Os quadrados diminuem com a distância.
pieces-title = afim, em pedaços
pieces-caption-affine-again-but = De novo afim, mas com a parede cortada em { $pieces } × { $pieces } pedaços.
pieces-caption-each-errs-little = Cada um erra tão pouco que nada disso se vê.
error-title = erro da afim
error-caption-how-far-affine =
    Quanto o lugar afim dista do verdadeiro, na largura ou na altura, o que for maior: amarelo é 0,35 da parede.
error-pieces-title = erro em pedaços
error-pieces-caption-same-scale-wall = A mesma escala para a parede em pedaços: no máximo { $cured }.
chart-title = Maior erro em função da razão de profundidades
chart-caption = Os erros medidos estão na curva (√ρ − 1)/(√ρ + 1): um terço do comprimento em ρ = 4, metade em 9.
axis-depth-ratio = razão de profundidades ρ
axis-largest-t-s = maior |t − s|
curve-measured = medido
curve-closed-form = fórmula
chart-title-place-surface-against = Lugar na superfície em função do lugar na imagem
chart-caption-even-interpolation-takes = A interpolação uniforme toma a reta; o que se deveria ver está nas curvas.
axis-t-picture = t na imagem
axis-s-surface = s na superfície
