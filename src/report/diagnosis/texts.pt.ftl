# A página e as imagens de um diagnóstico.

contents = Sumário
heat-alternative = a malha colorida pelo desvio de suas normais gravadas, { $scale }
facing-alternative = a malha com a frente das faces em azul-claro e o verso em vermelho-escuro
creases-alternative = a malha tonalizada, com linhas ao longo de vincos e costuras
overview-caption =
    Primeira: ângulo entre as normais gravadas e as calculadas com a receita estimada{ $marks }. Segunda: frente das faces em
    azul-claro, verso em vermelho-escuro. Terceira: a malha tonalizada, com linhas laranja nas arestas cujos dois lados têm
    normais diferentes.
overview-caption-findings =
    Primeira: erros e avisos, cada um em uma cor própria{ $marks }. Segunda: frente das faces em azul-claro, verso em
    vermelho-escuro. Terceira: a malha tonalizada, com linhas laranja nas arestas cujos dois lados têm normais diferentes.
caption-of-deviations = O ângulo entre as normais gravadas e as calculadas com a receita estimada{ $marks }.
findings-alternative = a malha tonalizada com cada erro e aviso em uma cor própria
marks-dots = ; pontos marcam desvios grandes em faces pequenas demais para serem visíveis
marks-edges =
    ; todos os cantos desviam em arestas cuja suavização não corresponde ao ângulo de vinco estimado (veja os achados)
marks-lines = ; linhas cinza marcam arestas com duas normais calculadas
marks-rings = ; anéis vermelhos marcam a pior posição de cada erro e aviso
marks-hidden = ; piores posições atrás de outras faces não têm anel

close-up-alternative = vista próxima da pior posição de { $finding }, de frente para sua face
close-up-seen = Primeira: { -close-up } Segunda: um anel a marca na malha inteira.
close-up-hidden = Primeira: { -close-up } Segunda: um anel a marca na malha inteira, onde está atrás de outras faces.
close-up-alone = Esta é { -close-up }
-close-up = a pior posição, vista de frente para sua face, com as arestas das faces. As faces que a cobrem foram cortadas.
whole-alternative = a malha inteira, com um anel em volta dessa posição
node-caption = A malha inteira, com um anel em volta do centro da geometria do primeiro desses nós.
node-alternative = a malha inteira, com um anel em volta de um nó
fix = O comando abaixo corrige { $fixed }.
not-fixed = Ele não corrige { $others }.

there-is-nothing = Não há faces para mostrar.
overview = Visão geral
to-overview = À visão geral
severity-error = erro
severity-warning = aviso
severity-note = nota
errors = { $count } { $count ->
    [one] erro
   *[other] erros
 }
warnings = { $count } { $count ->
    [one] aviso
   *[other] avisos
 }
notes = { $count } { $count ->
    [one] nota
   *[other] notas
 }
title-found = { $name }: { $counts }
title-none = Nenhum problema encontrado em { $name }
title-omitted = Nenhum dos achados selecionados em { $name }
checked = Faces verificadas: { $faces }.
omitted = Achados omitidos por opções: { $count }.

recipes = Receitas que melhor reproduzem as normais gravadas
column-submesh = submalha
column-faces = faces
column-recipe = receita
column-median = mediana
unnamed-submesh = submalha { $number }

finding = { $severity }: { $cause }. { $count } de { $of } ({ $share } %){ $details }.
finding-steps = ; até { $angle }{ $steps } de 255 níveis de cinza sob uma luz principal
finding-worst = ; no pior caso { $amount } { $unit }
finding-confidence = ; confiança { $confidence }
worst-locations = Piores posições
column-location = local
column-face = face
column-corner = canto
column-vertex = vértice
column-position = posição
column-degrees = graus
line = linha { $line }
primitive = primitiva { $number }

legend-absent = sem normal válida
legend-line = aresta com duas normais
legend-dot = desvio grande em face pequena
worst-seen = pior posição
worst-partly-hidden = pior posição (outras estão escondidas)
worst-hidden = pior posição: escondida por outras faces
scale-end = { $full }°
scale-end-beyond = { $full }° e mais, até { $largest }°
scale = de violeta, 0°, a amarelo, { $end }
scale-and-absent = { $scale }; rosa onde não há normal válida gravada
scale-absent = tudo rosa: não há normal válida gravada
angle-of-recipe = Desvio das normais gravadas em relação às da receita estimada, em graus
angle-of-weight = Desvio das normais gravadas em relação às do peso { $weight }, em graus
elements-corner = { $count } { $count ->
    [one] canto
   *[other] cantos
 }
elements-face = { $count } { $count ->
    [one] face
   *[other] faces
 }
elements-edge = { $count } { $count ->
    [one] aresta
   *[other] arestas
 }
elements-vertex = { $count } { $count ->
    [one] vértice
   *[other] vértices
 }
elements-node = { $count } { $count ->
    [one] nó
   *[other] nós
 }
elements-mesh = { $count } { $count ->
    [one] malha
   *[other] malhas
 }
up-to = { $elements }, até { $degrees }°
legend-plain = sem achado
legend-clean = sem erros nem avisos
not-shown = achados não mostrados: { $count } (--heatmap-of mostra um deles)

before-and-after = Antes e depois
lit-before = a malha iluminada com as normais de antes
lit-after = a malha iluminada com as normais de depois
changed = a malha colorida por quanto suas normais mudaram, { $scale }
lit-caption =
    Primeira: antes. Segunda: depois. Terceira: o ângulo em que a normal de cada canto mudou; um anel marca a maior
    mudança visível.
off-before = antes: a malha colorida pelo desvio de suas normais em relação à sua própria receita, { $scale }
off-after = depois: a malha colorida pelo desvio de suas normais em relação à sua própria receita, { $scale }
off-caption = Ângulo entre as normais gravadas e as calculadas com a receita estimada. Primeira: antes. Segunda: depois.
numbers =
    Em { $name }, { $changed } de { $corners } normais mudaram de direção, { $visible } delas visivelmente. A maior mudança é
    { $largest }° ({ $largest-steps } de 255 níveis de cinza sob uma luz principal), a média { $mean }° ({ $mean-steps }
    níveis), o valor rms { $rms }°. Metade das mudanças é de no máximo { $median }°, 95 % de no máximo { $p95 }°, 99 % de no
    máximo { $p99 }°. Cantos que ganharam uma normal: { $gained }; que perderam a sua: { $lost }. Faces com orientação
    invertida: { $turned }; { $faces }.
same-faces = nenhuma face foi acrescentada nem removida
other-faces = faces removidas: { $here }, acrescentadas: { $there }
findings-before-and-after = Achados, antes e depois
column-finding = achado
column-before = antes
column-after = depois

distributions = Distribuições
deviation-title = Desvio das normais gravadas
deviation-unit = graus
deviation-caption = As normais corretas ficam à esquerda, as falhas à direita. O eixo vertical é logarítmico, para que um único canto seja visível. Normais sem direção são omitidas.
dihedral-angle-title = Ângulos diedros
dihedral-angle-unit = graus
dihedral-angle-caption = Um ângulo em uma lacuna entre ângulos pequenos e grandes é um bom ângulo de vinco.
corner-angle-title = Ângulos das faces em seus cantos
corner-angle-unit = graus
corner-angle-caption = Muitos ângulos perto de 0° ou 180° indicam faces finas, cujas normais são imprecisas.
valence-title = Faces em torno de um vértice
valence-unit = faces
valence-caption = O número de faces em um vértice. Vértices com muitas faces (polos) ficam à direita.
edge-length-title = Comprimentos das arestas
edge-length-unit = comprimentos medianos
edge-length-caption = Divididos pela mediana. A última classe tem todos os comprimentos acima de dez medianas.
histogram = histograma: { $name }
histogram-words =
    Um histograma de { $count } valores. A classe mais cheia tem { $share } %, de { $from } a { $to } { $unit }.
histogram-corners = cantos
histogram-share = por cento
