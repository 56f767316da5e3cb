title = A interpolação afim é errada em perspectiva
claim =
    A interpolação linear na imagem é errada em perspectiva: passos iguais na tela não são passos iguais na superfície.
source-1 = Aulas: 1.5.2.3, 1.6.15, 1.6.47
source-2 = J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992 (em inglês)
formula-1 = {"s(t) = \\frac{t}{t + ρ (1 − t)}"}
formula-1-says = posição s na superfície que é visível na posição t da imagem, ambas de 0 a 1; ρ = z_longe/z_perto
formula-2 = {"\\max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"}
formula-2-says = maior erro da interpolação afim; excede ½ passo de 255 se ρ > 1,0079 para cores de 0 a 1
shown-by = Use uma parede mais profunda para mostrá-lo.
affine-by = (√ρ − 1)/(√ρ + 1); tolerância: o pixel mais próximo entre 4096, e precisão simples
scanline-measure = varredura, ρ = 4
perspective-measure = correta em perspectiva, ρ = 4
perspective-by = 0, pois a/w e 1/w são lineares na imagem
pieces-measure = afim, { $segments } × { $segments } quadrados
pieces-by = erro do quadrado mais próximo, que tem a maior razão de profundidades, 1 + (ρ − 1)/n, dividido por n
pieces-up-measure = afim, { $pieces } × { $pieces } quadrados: posição vertical
pieces-up-by = no máximo o erro horizontal, que ocorre na diagonal de um quadrado; os pixels ficam ao lado da diagonal
affine-effect = maior erro da posição horizontal
affine-cure = interpolação correta em perspectiva
holds-only-if =
    os cantos de um triângulo tiverem profundidades diferentes numa projeção em perspectiva. Numa projeção paralela, ou
    numa face paralela à tela, os dois métodos são iguais. Um erro menor que meio passo de 255 não é visível; para cores
    de 0 a 1, isso significa profundidades que diferem em menos de 0,8 %.
note-1 =
    O tabuleiro não é uma textura. Dois números, a posição horizontal e a vertical, são interpolados entre os quatro
    cantos de uma face e determinam a cor de cada quadrado. Cores e normais têm o mesmo erro.
note-2 =
    Numa parede subdividida, cada quadrado é menor e tem uma razão de profundidades menor. O erro cai com o quadrado do
    número de quadrados por lado. A divisão pela profundidade o elimina.
affine-title = afim
affine-caption = Uma parede que se afasta do observador para a direita, até quatro vezes a profundidade inicial.
affine-seen =
    Interpolados na imagem, os quadrados do tabuleiro têm uma quebra na diagonal e não ficam mais estreitos com a
    distância.
perspective-title = correta em perspectiva
perspective-caption = A mesma face com interpolação correta em perspectiva.
perspective-seen = Os quadrados do tabuleiro diminuem com a distância.
pieces-title = afim, subdividida
pieces-caption = Interpolação afim numa parede dividida em { $segments } × { $segments } quadrados.
pieces-seen = O erro de cada quadrado é pequeno demais para ser visível.
error-title = erro, afim
error-caption =
    Distância entre a posição afim e a verdadeira, na horizontal ou na vertical, a que for maior. Amarelo é { $full } da
    parede.
error-pieces-title = erro, subdividida
error-pieces-caption = A parede subdividida na mesma escala: no máximo { $pieces-error }.
largest-error-title = Maior erro em função da razão de profundidades
largest-error-caption =
    Os erros medidos estão na curva (√ρ − 1)/(√ρ + 1): um terço do comprimento em ρ = 4, metade em ρ = 9.
largest-error-x = razão de profundidades
largest-error-y = maior |t − s|
measured-curve = medido
law-curve = fórmula
place-title = Posição na superfície em função da posição na imagem
place-caption = A interpolação afim segue a reta; as posições corretas estão nas curvas.
place-x = t na imagem
place-y = s na superfície
affine-measure = afim, ρ = { $ratio }
scanline-by = { affine-by }
place-curve = razão { $ratio }
