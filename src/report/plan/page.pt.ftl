# A página de um plano.

title = { $scene } precisa de { $share } do original em { $quantity }
title-unchanged = { $scene } precisa de tudo o que declara
lead =
    A cena planejada custa { $after } em vez de { $before }. Nenhum pixel de um objeto difere em mais de { $worst } (tolerância
    { $tolerance }).
lead-none-found = Nenhum modelo mais barato foi encontrado antes do fim da busca.
lead-unchanged = Nenhum modelo mais barato fica dentro da tolerância de { $tolerance }.
unproven =
    A busca terminou antes de testar todos os modelos mais baratos. Nenhum plano custa menos de { $proven }:
    um plano mais barato economiza no máximo mais { $gap }.
contents = Conteúdo
pictures = Imagens
pictures-caption = A vista com a maior diferença: { $worst } (tolerância { $tolerance }).
worst-place = A maior diferença é vista do olho { $eye } na direção de { $target }.
held-out-place = Entre as vistas que não serviram para achar o plano, a pior é a do olho { $eye } na direção de { $target }.
turned = As luzes são giradas em { $angle } em torno do eixo { $axis }.
shot-reference = Referência
shot-planned = Plano
shot-step = Com o passo mais barato
shot-difference-plain = Diferença
shot-difference = Diferença, amplificada { $factor } vezes
decisions = Decisões
decisions-none-found = Nenhum modelo mais barato foi encontrado antes do fim da busca.
decisions-none = Todo valor mais barato ultrapassa a tolerância.
decisions-caption = O que o plano muda
column-what = objeto ou luz
column-axis = eixo
column-change = mudança
column-saves = economiza
column-difference = maior diferença isolada
column-bound = limite
none = nenhum
refused = Passos recusados
refused-none = Não há passo mais barato a partir do plano.
refused-lead =
    Cada um destes passos tornaria o plano mais barato. As imagens mostram, ampliada, a vizinhança do pixel que mais
    difere.
refused-title = { $what }: { $axis } { $from } → { $to }
refused-caption =
    Economiza { $saved }, mas o pixel { $pixel } da vista { $view } difere em { $difference } (tolerância { $tolerance }).
refused-outline = Economiza { $saved }, mas o contorno se desloca { $outline } na vista { $view }.
tried = Tudo o que foi testado
tried-caption =
    Modelos de um só objeto, com o resto como planejado, e planos inteiros. Um modelo recusado pode diferir mais do que o erro
    mostrado: a comparação termina na primeira diferença grande. A cena declarada não tem erro e aparece no extremo inferior.
costs = Custos
costs-caption = Custos antes e depois
column-cost = custo
column-declared = declarado
column-planned = planejado
column-share = planejado em relação ao declarado
reproduce = Reproduzir

sheet-reference = referência: { $cost }
sheet-plan = plano: { $cost }
sheet-difference = { $difference }, ampliada × { $factor }

plot-title = Erro em função do custo
plot-description =
    { $tried ->
        [one] Um modelo foi testado.
       *[other] { $tried } modelos foram testados.
    } O plano custa { $cost }, a cena declarada { $declared }.
plot-frontier = fronteira de Pareto
plot-tolerance = tolerância
plot-refused = recusado
plot-within = dentro da tolerância
plot-declared = declarado
plot-planned = plano
plot-work = operações
plot-bytes = bytes
plot-vertices = vértices
plot-steps = maior diferença, passos de 1/255
plot-flip = ꟻLIP médio

steps = { $value } passos de 255
flip = ꟻLIP { $value }
operations = { $value } operações
bytes = { $value } bytes
vertices = { $value } vértices
light = luz { $number }
object = objeto { $number }
picture = imagem

axis-shading = tonalização
axis-weight = peso
axis-creases = arestas vivas
axis-precision = precisão
axis-storage = armazenamento
axis-merging = fusão de vértices
axis-interpolation = interpolação
axis-reflection = reflexão
axis-tessellation = tesselação
axis-two-sided = dois lados
axis-lights = luz
axis-antialiasing = amostras

value-as-declared = como declarado
value-none = nenhuma
value-kept = mantidas
value-given = dado
value-on = sim
value-off = não
value-exact = exata
value-flat = plana
value-gouraud = de Gouraud
value-phong = de Phong
value-perspective = em perspectiva
value-affine = afim
value-diffuse = difusa
value-ambient = ambiente
value-omitted = omitida
value-constant = constante
value-attenuated = com atenuação
value-directional = direcional
value-point = pontual
value-spot = spot
value-rectangle = retangular
value-disc = circular

because-shading =
    { $what } recebe tonalização { $to } em vez de tonalização { $from }: os vetores normais variam tão pouco entre os cantos de uma face que
    as cores diferem no máximo em { $difference }.
because-weight = { $what }: a média por { $to } em vez de { $from } muda as cores em { $difference }.
because-weight-angle =
    { $what }: a média por { $to } em vez de { $from } gira os vetores normais em no máximo { $angle }, o que muda as cores em
    { $difference }.
because-creases = As arestas vivas de { $what } não são visíveis aqui: um vetor normal por vértice muda as cores em { $difference }.
because-creases-angle =
    { $what }: um vetor normal por vértice gira os vetores normais em até { $angle } nas arestas vivas, mas as cores visíveis mudam apenas
    { $difference }.
because-precision = { $what }: a precisão simples muda as cores em { $difference }.
because-precision-angle =
    { $what }: a precisão simples gira os vetores normais em no máximo { $angle }, o que muda as cores em { $difference }.
because-storage = { $what }: vetores normais armazenados como { $to } mudam as cores em { $difference }.
because-storage-angle =
    { $what }: vetores normais armazenados como { $to } erram no máximo { $angle }, o que muda as cores em { $difference }.
because-merging =
    Vértices de { $what } em posições iguais com vetores normais iguais são armazenados uma só vez. Cada canto mantém os seus
    valores, e as cores mudam em { $difference }.
because-interpolation =
    Dentro das faces de { $what } a perspectiva quase não importa: a interpolação { $to } muda as cores em { $difference }.
because-reflection = A reflexão de { $what } é { $to }: os termos omitidos ou trocados mudam as cores em { $difference }.
because-tessellation = { $what } tem { $to } células em vez de { $from }: as cores mudam em { $difference }.
because-two-sided = { $what } é iluminado de um só lado: as faces vistas por trás diferem no máximo em { $difference }.
because-lights = { $what }: { $to } em vez de { $from }; as cores mudam em { $difference }.
because-lights-radii =
    { $what } está a { $radii } raios da cena: como luz { $to }, sua direção erra no máximo { $angle }, e as cores mudam em
    { $difference }.
because-antialiasing = { $to } amostras por pixel em vez de { $from } mudam as cores em { $difference } dentro dos objetos.
