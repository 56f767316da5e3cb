title = A tonalização de Gouraud tem bandas de Mach mais fortes sob luz frontal
claim = As bandas de Mach são mais fortes na tonalização de Gouraud do que na de Phong.
source-1 = Aulas: Tabela 1, 1.6.13, 1.6.46, 1.6.50
source-2 = Contraexemplo: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979
formula-1 = {"ΔI_\\mathrm{plano} = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-1-says = degrau de luminância entre duas facetas planas; a aresta comum está no ângulo θ, e Δ = 2π/N
formula-2 = {"ΔI′_\\mathrm{Gouraud} = −\\cos(θ_L) [\\tan(θ + Δ/2) − \\tan(θ − Δ/2)]"}
formula-2-says = salto da inclinação da luminância ao longo da imagem nessa aresta
formula-3 = {"\\frac{ΔI′_\\mathrm{Phong}}{ΔI′_\\mathrm{Gouraud}} = \\frac{\\sin(θ − θ_L) \\sin(θ)}{\\cos(θ_L)}"}
formula-3-says = o salto da tonalização de Phong é maior em alguma aresta se cos(θ_L) < 1/3, ou seja, θ_L > 70,5288°
shown-by = Use luz a menos de 90° da direção de visão e de 8 a 32 segmentos para mostrá-lo.
gouraud-jump-measure = Gouraud: maior salto de inclinação a até 60° da direção de visão
flat-step-measure = plana: maior degrau de luminância a até 60° da direção de visão
flat-step-by = 2 |sin(θ − θ_L)| sin(Δ/2); tolerância: precisão simples
gouraud-jump-by =
    −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; tolerância: arredondamento das amostras que determinam a inclinação
phong-jump-by = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; tolerância: como em Gouraud
fine-jump-by = a mesma fórmula com o Δ menor
shading-effect = maior salto de inclinação a até 60° da direção de visão
flat-effect = maior degrau de luminância a até 60° da direção de visão
fails =
    a luz está tão longe da direção de visão que a tonalização de Phong tem os maiores saltos de inclinação. Isso é
    possível acima de 70,5288°.
note-1 =
    Onde a inclinação da luminância salta, o olho vê uma banda de Mach: uma linha escura na base da rampa, uma linha
    clara no topo. Nenhum pixel ali é mais escuro ou mais claro que os vizinhos dos dois lados. A tonalização plana tem
    saltos da própria luminância. As de Gouraud e de Phong são contínuas, mas a inclinação delas não é.
note-2 =
    O excesso previsto é o de uma diferença de gaussianas, um modelo da inibição lateral. O modelo prevê onde as bandas
    podem ser visíveis e como se comparam dentro de uma mesma imagem. Ele não prevê com que intensidade são vistas.
note-3 =
    O cilindro exato também tem uma banda: onde a luz termina. As arestas são medidas onde as duas facetas estão
    iluminadas, até 60° da direção de visão. Além de 60° as facetas são vistas em ângulo rasante, e as inclinações ao
    longo da imagem crescem sem limite, inclusive as do cilindro exato.
note-4 =
    Os saltos de inclinação são de primeira ordem na largura da faceta. Com quatro vezes mais segmentos, eles caem a
    cerca de um quarto.
why-slope = um salto com o qual a luminância na faceta difere de uma curva suave em meio passo de 8 bits
grazing-ratio-measure =
    luz a 80°: razão entre os saltos de inclinação de Phong e de Gouraud numa aresta girada a θ = 40° (cilindro não
    mostrado)
border-angle-measure = ângulo da luz acima do qual Phong tem o maior salto de inclinação
halfway-difference-measure =
    aresta a meio caminho entre o observador e a luz: salto de inclinação de Phong menos o de Gouraud (cilindro não mostrado)
halfway-difference-by =
    (sin²(θ_L/2) − |cos θ_L|) [tan(θ + Δ/2) − tan(θ − Δ/2)] com θ = θ_L/2, zero em 70,53°; tolerância: arredondamento dos
    dois saltos
facets-lit-in-part = não comparado com sin(θ − θ_L) sin θ / cos θ_L: facetas tão largas só são iluminadas em parte
grazing-ratio-by = sin(θ − θ_L) sin θ / cos θ_L; tolerância: arredondamento dos dois saltos
border-angle-by = arccos(1/3), encontrado por bissecção em imagens; ali a razão cresce 7,4 % por grau
gouraud-caption = Tonalização de Gouraud das mesmas facetas: a luminância é contínua, mas sua inclinação não é.
phong-caption = Tonalização de Phong das mesmas facetas: a luminância é curva em cada faceta.
flat-title = plana
flat-caption =
    Tonalização plana de { $segments } facetas, com a luz a { $light }° da direção de visão. Cada faceta tem uma só
    luminância.
    Nestas imagens, a luminância { $white } é branca, e { $dark } ou menos é preta.
flat-seen = Cada faceta é visível como uma faixa de um só tom de cinza.
fine-seen = Os saltos de inclinação têm cerca de um quarto do tamanho.
exact-title = exato, preto { $dark }, branco { $white }
exact-caption = O cilindro com a normal exata em cada pixel: a única banda está onde a luz termina.
phong-80-jumps-seen = Aqui a tonalização de Phong tem os maiores saltos de inclinação.
gouraud-80-jumps-seen = Aqui a tonalização de Gouraud tem os menores saltos de inclinação.
phong-80-title = Phong, luz a 80°
phong-80-caption =
    Tonalização de Phong com a luz a 80° da direção de visão. A luminância é curva dentro de cada faceta. Os saltos de
    inclinação quase não são visíveis; o mapa os mostra.
gouraud-80-title = Gouraud, luz a 80°
gouraud-80-caption =
    A mesma luz com tonalização de Gouraud: em facetas totalmente iluminadas, a luminância é quase linear ao longo da
    imagem.
phong-80-jumps-caption =
    Uma barra marca cada aresta a até 60° cujas facetas estão totalmente iluminadas. A cor da barra é o salto de
    inclinação: violeta é 0, amarelo é { $full }. As regiões não medidas são omitidas.
luminance-caption =
    A luminância na tonalização plana tem degraus. Na de Gouraud ela é uma poligonal. Na de Phong ela é curva em cada
    faceta.
exact-curve = exato
luminance-80-caption =
    Com a luz a 80°, a luminância da parte iluminada do cilindro é quase linear. A tonalização de Gouraud também é quase
    linear. A de Phong é curva.
slope-80-caption =
    A inclinação da luminância nas facetas junto às arestas medidas. Na tonalização de Phong ela sobe e desce em cada
    faceta e salta nas arestas em até { $bad }. Na de Gouraud ela salta em até { $cured }.
curvature-caption =
    A inclinação da inclinação. Cada salto de inclinação aparece como um pico estreito; um salto maior tem um pico mais
    alto.
luminance-title = Luminância ao longo de uma linha de varredura
luminance-y = luminância linear Y
slope-title = Primeira derivada
slope-y = dY/dx, por raio
curvature-title = Segunda derivada
curvature-y = d²Y/dx², por raio²
luminance-x = x ao longo da imagem, em raios
overshoot-flat-by =
    ΔI′ (σ_s − σ_c)/√(2π) para um salto de inclinação, 0,111682 ΔI para um degrau; tolerância: até 11,6 % menos se a
    aresta fica entre dois pixels
narrow-facets = não comparado: as facetas são tão estreitas que o modelo responde a duas arestas ao mesmo tempo
predicted-y = excesso previsto, em luminância
predicted-title = Excesso previsto: inclinações
predicted-caption =
    Previsão de uma diferença de duas gaussianas (σ de 1 e 1,6 pixel, 67 pixels por grau). Há uma linha em cada aresta
    iluminada, com altura próxima à do salto de inclinação. É um modelo: a intensidade com que as bandas são vistas
    difere da prevista.
predicted-flat-title = Excesso previsto: degraus
predicted-flat-caption =
    O mesmo modelo aplicado à tonalização plana prevê uma linha clara e uma escura junto a cada degrau. Sabe-se que o
    modelo erra para degraus: essas bandas quase não são visíveis (Kingdom 2014).
phong-jump-measure = Phong: maior salto de inclinação a até 60° da direção de visão
fine-jump-measure = { $worse } com { $finer } segmentos: salto de inclinação na mesma aresta
finer-effect = { $worse }: salto de inclinação na aresta em que ele é maior, a até 60° da direção de visão
finer-cure = { $factor } vezes mais segmentos, na mesma aresta
shading-cure = a outra tonalização
holds-only-if =
    o maior salto de inclinação de cada tonalização for comparado, como aqui. Se a luz está a mais de 70,5288° da
    direção de visão, a tonalização de Phong pode ter o maior salto de inclinação em algumas arestas. A 90°, a
    tonalização de Gouraud de facetas totalmente iluminadas é exata, e só a de Phong tem bandas.
gouraud-title = Gouraud
phong-title = Phong
gouraud-curve = Gouraud
phong-curve = Phong
flat-curve = { flat-title }
fine-title = { $worse }, { $finer } segmentos
fine-caption = Tonalização de { $worse } com { $factor } vezes mais segmentos.
phong-80-jumps-title = Phong, luz a 80°: saltos de inclinação
gouraud-80-jumps-title = Gouraud, luz a 80°: saltos de inclinação
gouraud-80-jumps-caption = { phong-80-jumps-caption }
slope-caption =
    A inclinação da luminância. Na tonalização de Gouraud ela é constante em cada faceta totalmente iluminada. Ela salta
    nas arestas, em até { $bad } na tonalização de { $worse } e em até { $cured } na de { $better }.
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
overshoot-flat-measure = plana: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-measure = Gouraud: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-phong-measure = Phong: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-fine-measure =
    Gouraud, { $finer } segmentos: excesso previsto (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-by = { overshoot-flat-by }
overshoot-phong-by = { overshoot-flat-by }
overshoot-fine-by = { overshoot-flat-by }
