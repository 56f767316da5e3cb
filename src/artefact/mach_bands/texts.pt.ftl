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
name-largest-slope = { $name }: maior salto de inclinação a até 60° da direção de visão
measure-flat-largest-step = plano: maior degrau de luminância a até 60° da direção de visão
by-sin-l-sin = 2 |sin(θ − θ_L)| sin(Δ/2); precisão simples
cos-l-tan = −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; arredondamentos das amostras de que se toma a inclinação
sin-l-sin = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; como em Gouraud
by-same-smaller = o mesmo com o Δ menor
moved = maior salto de inclinação a até 60° da direção de visão
moved-largest-step-within = maior degrau a até 60° da direção de visão
holds-only-if-no-edge-stands =
    nenhuma aresta está onde ela não vale. A luz está a mais de 70,5288° da direção de visão, de modo que o salto de
    inclinação de Phong seria o maior em uma aresta a meio caminho da luz; este cilindro não tem nenhuma ali.
holds-only-if-largest-jumps-compared =
    se comparam os maiores saltos, como aqui. A luz está a mais de 70,5288° da direção de visão, de modo que em algumas
    arestas o salto de inclinação de Phong já é o maior; um pouco mais longe ele é o maior de todos.
holds-only-if-light-less-off =
    a luz está a menos de 70,5288° da direção de visão, como aqui. Além desse ângulo há arestas em que o salto de
    inclinação de Phong é o maior; a 90° o sombreamento de Gouraud das facetas iluminadas por inteiro é exato, e só o de
    Phong tem bandas.
fails-light-far-off =
    a luz está tão longe da direção de visão que os saltos de inclinação de Phong são os maiores, como podem ser a
    partir de 70,5288°.
slope-luminance-jumps =
    Onde a inclinação da luminância salta, o olho vê uma linha escura no pé e uma clara no joelho, embora nenhum pixel
    ali seja mais escuro ou mais claro que os vizinhos dos dois lados. O sombreamento plano salta na própria luminância.
    Os de Gouraud e de Phong são contínuos, mas as suas inclinações não.
overshoot-called-predicted =
    O excesso chamado de previsto é o de uma diferença de gaussianas, um modelo da inibição lateral. Ele diz onde bandas
    podem ser vistas e como se comparam numa imagem, não com que força são vistas.
facets-meet-light =
    As facetas se encontram onde a luz acaba: ali o próprio cilindro tem uma banda. As arestas são medidas onde as suas
    duas facetas estão iluminadas, até 60° da direção de visão; mais adiante as facetas são vistas de lado, e as
    inclinações ao longo da imagem crescem sem limite, também as do cilindro.
jumps-first-order =
    Os saltos são de primeira ordem na largura da faceta: quatro vezes mais segmentos os reduzem a cerca de um quarto.
why-luminance-facet-half = a luminância de uma faceta fica então a meio passo de 8 bits de uma curva
measure-light-slope-jump = luz a 80°: salto de Phong sobre o de Gouraud numa aresta girada a θ = 40° (cilindro não mostrado)
measure-light-angle-beyond = ângulo da luz além do qual Phong tem o salto maior
not-held-against = não comparado com sin(θ − θ_L) sin θ / cos θ_L: facetas tão largas só são iluminadas em parte
by-sin-l-sin-cos = sin(θ − θ_L) sin θ / cos θ_L; arredondamentos dos dois saltos
by-arccos-found-halving = arccos(1/3), achado por bissecção em imagens; a razão cresce ali 7,4 % por grau
gouraud-shading-same = O sombreamento de Gouraud das mesmas facetas: a luminância é contínua, a inclinação não.
phong-shading-same = O sombreamento de Phong das mesmas facetas: a luminância é curva em cada uma.
bands-stand-edges = Há bandas nas arestas.
slopes-jump-less = As inclinações saltam menos sob esta luz do que no outro sombreamento.
flat-title = plano
flat-caption-flat-shading-facets =
    Sombreamento plano de { $from } facetas, a luz a { $value }° da direção de visão: uma luminância para cada faceta.
flat-caption-each-stands-out = Cada uma se destaca como uma faixa de um só cinza.
fine-caption-jumps-about-quarter = Os saltos são cerca de um quarto do que eram.
exact-title = o próprio cilindro
exact-caption-cylinder-lit-every = O cilindro iluminado em cada pixel com a sua própria normal: sem bandas senão onde a luz acaba.
phong-80-jumps-title = A inclinação da luminância de Phong salta mais.
gouraud-80-jumps-title = O sombreamento de Gouraud tem aqui os saltos menores.
phong-80-title = Phong, luz a 80°
phong-80-caption-light-off-direction =
    A luz a 80° da direção de visão, sombreamento de Phong. A luminância se curva dentro de cada faceta; os saltos da
    sua inclinação, que o mapa mostra, quase não se veem.
gouraud-80-title = Gouraud, luz a 80°
gouraud-80-caption-same-light-facets =
    A mesma luz: onde as facetas estão iluminadas por inteiro, a luminância é quase linear ao longo da imagem.
shading-light-jumps = { $shading }, luz a 80°: saltos da inclinação
bars-edges-up =
    Barras nas arestas até 60° cujas facetas estão iluminadas por inteiro, tanto mais claras quanto mais a inclinação
    salta ali: violeta 0, amarelo { $full }. O que não se mede fica de fora.
light-flat-shading =
    Onde há luz, o sombreamento plano tem degraus, o de Gouraud é uma poligonal, o de Phong é curvo em cada faceta.
exact = exato
light-cylinder-luminance =
    A luz a 80°: a luminância do cilindro é quase reta onde há luz, e a de Gouraud também. A de Phong é curva.
slope-facets-beside =
    A inclinação disso, nas facetas junto às arestas medidas: a de Phong sobe e desce em cada faceta e salta de volta
    nas arestas, até { $bad }; a de Gouraud salta até { $cured }.
light = luz a 80°
slope-slope-slope =
    A inclinação da inclinação: onde a inclinação salta há um pico estreito, tanto mais alto quanto maior é o salto.
luminance-along-scanline = Luminância ao longo de uma linha de varredura
linear-luminance-y = luminância linear Y
first-derivative = Primeira derivada
dy-dx-per = dY/dx, por raio
second-derivative = Segunda derivada
d-y-dx = d²Y/dx², por raio²
axis-x-across-picture = x ao longo da imagem, em raios
by-i-s-c =
    ΔI′ (σ_s − σ_c)/√(2π) para um salto de inclinação, 0,111682 ΔI para um degrau; até 11,6 % menos onde a aresta fica
    entre dois pixels
untested-facets-narrow-model = as facetas são tão estreitas que o modelo vê duas arestas ao mesmo tempo
axis-predicted-overshoot-luminance = excesso previsto, em luminância
predicted-overshoot-slopes = Excesso previsto: inclinações
difference-gaussians-pixels =
    O que prevê uma diferença de duas gaussianas (σ de 1 e 1,6 pixel, 67 pixels por grau): uma linha em cada aresta sob
    a luz, tão alta quanto a inclinação salta ali. É um modelo: o olho não o segue na intensidade.
predicted-overshoot-steps = Excesso previsto: degraus
same-model-flat =
    O mesmo modelo no sombreamento plano: uma linha clara e uma escura junto a cada degrau que houver. Ali se sabe que o
    modelo erra: as bandas que prevê junto a degraus quase não são vistas (Kingdom 2014).
