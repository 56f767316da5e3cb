# O que os achados dizem sobre um arquivo além dos títulos.

in-closed-components = em { $count } { $count ->
    [one] componente fechada
   *[other] componentes fechadas
 }
in-open-components = em { $count } { $count ->
    [one] componente aberta
   *[other] componentes abertas
 }
could-be-merged = { $count } { $count ->
    [one] vértice poderia ser unido
   *[other] vértices poderiam ser unidos
 }
contradicted = { $sum }, em contradição com as normais gravadas; fora da contagem: { $components ->
    [one] outra componente
   *[other] outras { $components } componentes
 } de { $count } faces, que nenhuma normal gravada contradiz
of-lower-severity = fora da contagem: { $count } de menor gravidade em outras submalhas

far-from-origin =
    restam { $bits } bits para a altura de uma face típica, e o arredondamento gira sua normal em até { $largest }°; a média
    esperada de todas as faces, incluindo as finas, é { $mean }°
slope = salto de até { $steps } níveis por pixel na inclinação da luminância
outline = desvio de até { $pixels } pixels com a malha em { $size } pixels de largura

quantised = { $grid }, { $error }
quantised-measured = { $grid }, { $measured }; { $error }
rounding-error =
    o erro de arredondamento é de no máximo { $degrees }°, { $visibility }; o expoente { $exponent } do material exige
    { $bits } bits por componente
visible-from = invisível até o expoente { $exponent }
always-visible = o que pode ser visível mesmo em uma superfície fosca
measured-error = diferem da receita em até { $largest }° (rms { $rms }°)
measured-error-of-some =
    diferem da receita em até { $largest }° (rms { $rms }°) nos { $explained } de { $compared } cantos que o
    arredondamento explica

decimals = { $count ->
    [1] uma casa decimal
    [2] duas casas decimais
    [3] três casas decimais
   *[other] quatro casas decimais
 }
signed-integers = inteiros com sinal de { $bits } bits divididos por { $scale }
unsigned-integers = inteiros sem sinal de { $bits } bits, 2k/{ $largest } − 1
renormalised = { $numbers }, com renormalização
octahedral-codes = códigos octaédricos de 2 × { $numbers }

stored-as = { $from } está gravado como { $to }
or-another-change = { $change } (ou outra troca com o mesmo efeito nesta forma)
or-other-changes = { $change } (ou uma de { $count } trocas com o mesmo efeito nesta forma)
rotated-by = de { $degrees }°
rotated-and-reversed = de { $degrees }°, com inversão de sentido

applied-twice-node = a matriz do nó `{ $first }` já está aplicada aos vetores normais e é aplicada duas vezes
applied-twice-nodes = as matrizes dos nós `{ $first }` a `{ $last }` já estão aplicadas aos vetores normais e são aplicadas duas vezes
undone-node = a matriz do nó `{ $first }` está desfeita nos vetores normais
undone-nodes = as matrizes dos nós `{ $first }` a `{ $last }` estão desfeitas nos vetores normais
applied-elsewhere-node = a matriz do nó `{ $first }` está aplicada aos vetores normais no espaço errado
applied-elsewhere-nodes = as matrizes dos nós `{ $first }` a `{ $last }` estão aplicadas aos vetores normais no espaço errado
undone-elsewhere-node = a matriz do nó `{ $first }` está desfeita nos vetores normais no espaço errado
undone-elsewhere-nodes = as matrizes dos nós `{ $first }` a `{ $last }` estão desfeitas nos vetores normais no espaço errado
or-another-mistake = { $mistake }, ou outro erro com o mesmo efeito
