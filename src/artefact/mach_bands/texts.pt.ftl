title = Bandas de Mach num cilindro
claim = As bandas de Mach são piores no sombreamento de Gouraud do que no de Phong.
source-1 = Aulas: Tabela 1, 1.6.13, 1.6.46, 1.6.50
source-2 = Em contrário: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979
formula-1 = {"ΔI_\\mathrm{plano} = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-1-says = o degrau entre duas facetas planas cuja aresta comum está no ângulo θ; Δ = 2π/N
formula-2 = {"ΔI′_\\mathrm{Gouraud} = −\\cos(θ_L) [\\tan(θ + Δ/2) − \\tan(θ − Δ/2)]"}
formula-2-says = o salto da inclinação, ao longo da imagem, nessa aresta
formula-3 = {"\\frac{ΔI′_\\mathrm{Phong}}{ΔI′_\\mathrm{Gouraud}} = \\frac{\\sin(θ − θ_L) \\sin(θ)}{\\cos(θ_L)}"}
formula-3-says = portanto o de Phong é o maior em algum lugar assim que cos(θ_L) < 1/3: θ_L > 70,5288°
shown-by = luz a menos de 90° da direção de visão, e de 8 a 32 segmentos, o mostrariam.
gouraud-jump-measure = Gouraud: maior salto de inclinação a até 60° da direção de visão
flat-step-measure = plano: maior degrau de luminância a até 60° da direção de visão
flat-step-by = 2 |sin(θ − θ_L)| sin(Δ/2); precisão simples
gouraud-jump-by = −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; arredondamentos das amostras de que se toma a inclinação
phong-jump-by = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; como em Gouraud
fine-jump-by = o mesmo com o Δ menor
shading-effect = maior salto de inclinação a até 60° da direção de visão
flat-effect = maior degrau a até 60° da direção de visão
fails =
    a luz está tão longe da direção de visão que os saltos de inclinação de Phong são os maiores, como podem ser a
    partir de 70,5288°.
note-1 =
    Onde a inclinação da luminância salta, o olho vê uma linha escura no pé e uma clara no joelho, embora nenhum pixel
    ali seja mais escuro ou mais claro que os vizinhos dos dois lados. O sombreamento plano salta na própria luminância.
    Os de Gouraud e de Phong são contínuos, mas as suas inclinações não.
note-2 =
    O excesso chamado de previsto é o de uma diferença de gaussianas, um modelo da inibição lateral. Ele diz onde bandas
    podem ser vistas e como se comparam numa imagem, não com que força são vistas.
note-3 =
    As facetas se encontram onde a luz acaba: ali o próprio cilindro tem uma banda. As arestas são medidas onde as suas
    duas facetas estão iluminadas, até 60° da direção de visão; mais adiante as facetas são vistas de lado, e as
    inclinações ao longo da imagem crescem sem limite, também as do cilindro.
note-4 =
    Os saltos são de primeira ordem na largura da faceta: quatro vezes mais segmentos os reduzem a cerca de um quarto.
why-slope = a luminância de uma faceta fica então a meio passo de 8 bits de uma curva
grazing-ratio-measure =
    luz a 80°: salto de Phong sobre o de Gouraud numa aresta girada a θ = 40° (cilindro não mostrado)
border-angle-measure = ângulo da luz além do qual Phong tem o salto maior
facets-lit-in-part = não comparado com sin(θ − θ_L) sin θ / cos θ_L: facetas tão largas só são iluminadas em parte
grazing-ratio-by = sin(θ − θ_L) sin θ / cos θ_L; arredondamentos dos dois saltos
border-angle-by = arccos(1/3), achado por bissecção em imagens; a razão cresce ali 7,4 % por grau
gouraud-caption = O sombreamento de Gouraud das mesmas facetas: a luminância é contínua, a inclinação não.
phong-caption = O sombreamento de Phong das mesmas facetas: a luminância é curva em cada uma.
flat-title = plano
flat-caption =
    Sombreamento plano de { $segments } facetas, a luz a { $light }° da direção de visão: uma luminância para cada faceta.
flat-seen = Cada uma se destaca como uma faixa de um só cinza.
fine-seen = Os saltos são cerca de um quarto do que eram.
exact-title = o próprio cilindro
exact-caption = O cilindro iluminado em cada pixel com a sua própria normal: sem bandas senão onde a luz acaba.
phong-80-jumps-seen = A inclinação da luminância de Phong salta mais.
gouraud-80-jumps-seen = O sombreamento de Gouraud tem aqui os saltos menores.
phong-80-title = Phong, luz a 80°
phong-80-caption =
    A luz a 80° da direção de visão, sombreamento de Phong. A luminância se curva dentro de cada faceta; os saltos da
    sua inclinação, que o mapa mostra, quase não se veem.
gouraud-80-title = Gouraud, luz a 80°
gouraud-80-caption =
    A mesma luz: onde as facetas estão iluminadas por inteiro, a luminância é quase linear ao longo da imagem.
phong-80-jumps-caption =
    Barras nas arestas até 60° cujas facetas estão iluminadas por inteiro, tanto mais claras quanto mais a inclinação
    salta ali: violeta 0, amarelo { $full }. O que não se mede fica de fora.
luminance-caption =
    Onde há luz, o sombreamento plano tem degraus, o de Gouraud é uma poligonal, o de Phong é curvo em cada faceta.
exact-curve = exato
luminance-80-caption =
    A luz a 80°: a luminância do cilindro é quase reta onde há luz, e a de Gouraud também. A de Phong é curva.
slope-80-caption =
    A inclinação disso, nas facetas junto às arestas medidas: a de Phong sobe e desce em cada faceta e salta de volta
    nas arestas, até { $bad }; a de Gouraud salta até { $cured }.
curvature-caption =
    A inclinação da inclinação: onde a inclinação salta há um pico estreito, tanto mais alto quanto maior é o salto.
luminance-title = Luminância ao longo de uma linha de varredura
luminance-y = luminância linear Y
slope-title = Primeira derivada
slope-y = dY/dx, por raio
curvature-title = Segunda derivada
curvature-y = d²Y/dx², por raio²
luminance-x = x ao longo da imagem, em raios
overshoot-flat-by =
    ΔI′ (σ_s − σ_c)/√(2π) para um salto de inclinação, 0,111682 ΔI para um degrau; até 11,6 % menos onde a aresta fica
    entre dois pixels
narrow-facets = as facetas são tão estreitas que o modelo vê duas arestas ao mesmo tempo
predicted-y = excesso previsto, em luminância
predicted-title = Excesso previsto: inclinações
predicted-caption =
    O que prevê uma diferença de duas gaussianas (σ de 1 e 1,6 pixel, 67 pixels por grau): uma linha em cada aresta sob
    a luz, tão alta quanto a inclinação salta ali. É um modelo: o olho não o segue na intensidade.
predicted-flat-title = Excesso previsto: degraus
predicted-flat-caption =
    O mesmo modelo no sombreamento plano: uma linha clara e uma escura junto a cada degrau que houver. Ali se sabe que o
    modelo erra: as bandas que prevê junto a degraus quase não são vistas (Kingdom 2014).
phong-jump-measure = Phong: maior salto de inclinação a até 60° da direção de visão
fine-jump-measure = { $worse } com { $finer } segmentos: salto de inclinação na mesma aresta
finer-effect = o salto de inclinação de { $worse } na aresta, a até 60° da direção de visão, em que ele é maior
finer-cure = { $factor } vezes mais segmentos, na mesma aresta
shading-cure = o outro sombreamento
holds-only-if =
    o maior salto de inclinação de cada sombreamento decide, como aqui. Com a luz a mais de 70,5288° da direção de visão
    pode haver arestas em que o salto de inclinação de Phong é o maior; a 90° o sombreamento de Gouraud de facetas
    iluminadas por inteiro é exato, e só o de Phong tem bandas.
gouraud-title = Gouraud
phong-title = Phong
gouraud-curve = Gouraud
phong-curve = Phong
flat-curve = { flat-title }
fine-title = { $worse }, { $finer } segmentos
fine-caption = O sombreamento de { $worse } com { $factor } vezes mais segmentos.
phong-80-jumps-title = Phong, luz a 80°: saltos da inclinação
gouraud-80-jumps-title = Gouraud, luz a 80°: saltos da inclinação
gouraud-80-jumps-caption = { phong-80-jumps-caption }
slope-caption =
    A inclinação da luminância: a de Gouraud é constante em cada faceta iluminada por inteiro. A de { $worse } salta nas
    arestas até { $bad }, a de { $better } até { $cured }.
slope-x = { luminance-x }
curvature-x = { luminance-x }
luminance-80-title = { luminance-title }, luz a 80°
luminance-80-x = { luminance-x }
luminance-80-y = { luminance-y }
slope-80-title = { slope-title }, luz a 80°
slope-80-x = { luminance-x }
slope-80-y = { slope-y }
curvature-80-title = { curvature-title }, luz a 80°
curvature-80-caption = { curvature-caption }
curvature-80-x = { luminance-x }
curvature-80-y = { curvature-y }
predicted-x = { luminance-x }
predicted-flat-x = { luminance-x }
predicted-flat-y = { predicted-y }
overshoot-flat-measure = plano: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-measure = Gouraud: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-phong-measure = Phong: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-fine-measure =
    Gouraud, { $finer } segmentos: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-by = { overshoot-flat-by }
overshoot-phong-by = { overshoot-flat-by }
overshoot-fine-by = { overshoot-flat-by }
