title = Distorção de perspectiva
claim =
    Interpolar por igual na imagem é errado em perspectiva: passos iguais na tela não são passos iguais na superfície.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47
source-2 = J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992 (em inglês)
formula-1 = {"s(t) = \\frac{t}{t + ρ (1 − t)}"}
formula-1-says = o lugar s na superfície que se vê no lugar t da imagem, ambos de 0 a 1; ρ = z_longe/z_perto
formula-2 = {"\\max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"}
formula-2-says = o maior erro da interpolação uniforme; ½ passo de 255 assim que ρ > 1,0079 para cores de 0 a 1
shown-by = uma parede mais funda o mostraria.
affine-by = (√ρ − 1)/(√ρ + 1); o pixel mais próximo de 4096, e precisão simples
scanline-measure = linha de varredura, ρ = 4
perspective-measure = correta em perspectiva, ρ = 4
perspective-by = a/w e 1/w são lineares na imagem
pieces-measure = afim, { $segments } × { $segments } pedaços
pieces-by = o pedaço mais próximo tem a maior razão de profundidades, 1 + (ρ − 1)/n; o seu erro sobre n
pieces-up-measure = afim, { $pieces } × { $pieces } pedaços: lugar na altura
pieces-up-by = tanto quanto na largura, na diagonal de um pedaço; os pixels ficam ao lado dela
affine-effect = maior erro do lugar na largura
affine-cure = interpolação correta em perspectiva
holds-only-if =
    as profundidades dos cantos de um triângulo diferem sob projeção central. Em projeção paralela, ou de frente para o
    observador, os dois modos são o mesmo; e um erro menor que meio passo de 255 não se vê: profundidades a menos de 0,8
    % para cores de 0 a 1.
note-1 =
    O tabuleiro não é uma imagem colada: dois números são interpolados entre os quatro cantos de uma face, os lugares na
    largura e na altura, e deles se tira a cor de cada quadrado. O que quer que se interpole, também cores e normais,
    erra do mesmo modo.
note-2 =
    Cortada em mais pedaços nos dois sentidos, cada um é menor e tem razão de profundidades menor: o erro cai com o
    quadrado do número deles ao longo de um lado. Dividir pela profundidade o faz sumir.
affine-title = afim
affine-caption = Uma parede que se afasta para a direita, até quatro vezes a profundidade.
affine-seen =
    Interpolados na imagem, os quadrados quebram na diagonal e são tão largos longe quanto perto.
perspective-title = correta em perspectiva
perspective-caption = A mesma face interpolada na cena.
perspective-seen = Os quadrados diminuem com a distância.
pieces-title = afim, em pedaços
pieces-caption = De novo afim, mas com a parede cortada em { $segments } × { $segments } pedaços.
pieces-seen = Cada um erra tão pouco que nada disso se vê.
error-title = erro da afim
error-caption =
    Quanto o lugar afim dista do verdadeiro, na largura ou na altura, o que for maior: amarelo é { $full } da parede.
error-pieces-title = erro em pedaços
error-pieces-caption = A mesma escala para a parede em pedaços: no máximo { $pieces-error }.
largest-error-title = Maior erro em função da razão de profundidades
largest-error-caption =
    Os erros medidos estão na curva (√ρ − 1)/(√ρ + 1): um terço do comprimento em ρ = 4, metade em 9.
largest-error-x = razão de profundidades ρ
largest-error-y = maior |t − s|
measured-curve = medido
law-curve = fórmula
place-title = Lugar na superfície em função do lugar na imagem
place-caption = A interpolação uniforme toma a reta; o que se deveria ver está nas curvas.
place-x = t na imagem
place-y = s na superfície
affine-measure = afim, ρ = { $ratio }
scanline-by = { affine-by }
place-curve = ρ = { $ratio }
