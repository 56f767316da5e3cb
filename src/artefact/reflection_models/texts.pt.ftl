title = O brilho de Phong e o de Blinn
claim =
    O vetor intermediário de Blinn dá mais ou menos o brilho do raio espelhado de Phong, mas com outro expoente, pois o
    ângulo ao vetor intermediário é a metade do ângulo ao raio espelhado.
source-1 = Aulas: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23
source-2 = Ting 2008: “Phong modificado”
source-3 = Artigo: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994
formula-1 = {"(V·R)^n = \\cos(φ)^n ≈ \\cos(φ/2)^{4n} = (N·H)^{4n}"}
formula-1-says = no plano de L e V, φ o ângulo do raio espelhado ao observador
formula-2 = {"\\frac{w_\\mathrm{transversal}}{w_\\mathrm{longitudinal}} ≈ \\frac{1}{\\cos(β/2)}"}
formula-2-says =
    quanto o brilho de Phong numa esfera se alonga na direção perpendicular ao plano de L e V, β o ângulo entre eles; o
    de Blinn é redondo
formula-3 = {"I_\\mathrm{trás} = k_s \\sin(β/2)^n"}
formula-3-says = o brilho de Blinn na fronteira da luz, N·L = 0: sem guarda ele continua atrás
formula-4 = {"I_\\mathrm{trás} = k_s (−\\cos(β))^n"}
formula-4-says = o mesmo do de Phong, onde a luz está de fato atrás, β > 90°
shown-by = um brilho de alguns pixels (expoentes de 1 a 100, ou uma imagem maior) o mostraria.
largest-over-scan = o maior em φ, por uma varredura de 10 001 ângulos; meio pixel
untested-highlight-hardly-wider = o brilho mal é mais largo que um pixel
light-phong-highlight = luz a 120°: brilho de Phong, largura transversal sobre a longitudinal
half-widths-half = meias larguras à meia altura em forma fechada; 2 para brilhos estreitos
light-blinn-highlight = luz a 120°: brilho de Blinn, largura transversal sobre a longitudinal
round = redondo
moved = maior diferença do brilho de Phong
cure = expoente quatro vezes maior
moved-width-across-over = largura transversal sobre a longitudinal, menos 1
moved-width-across-over-width = largura transversal sobre a longitudinal, menos 1, onde ambas se podem medir
why-tenth-width = um décimo da sua largura
measure-same-n-largest = mesmo n: maior diferença
measure-blinn-n-largest = Blinn com 4n: maior diferença
phong-title = Phong, expoente n
phong-caption-phong-highlight-sphere = O brilho de Phong numa esfera, luz e observador em frente; n = { $exponent }.
blinn-same-n-title = Blinn, expoente n
blinn-same-n-caption-blinn-same-exponent = O de Blinn com o mesmo expoente.
blinn-4n-title = Blinn, expoente 4n
blinn-4n-caption-blinn-four-times = O de Blinn com expoente quatro vezes maior.
blinn-4n-caption-much-closer-phong = Fica muito mais perto do de Phong.
phong-grazing-title = Phong, luz a 120°
phong-grazing-caption-light-far-round = Luz vinda de trás e de lado, n = { $exponent }.
phong-grazing-caption-here-phong-highlight =
    Aqui é o brilho de Phong que erra: ele se alonga para cima e para baixo, através do plano da luz e da visão, como
    superfícies ásperas reais não o mostram.
blinn-grazing-title = Blinn 4n, luz a 120°
blinn-grazing-caption-blinn-under-same = O de Blinn sob a mesma luz, com 4n = { $blinn-exponent }.
blinn-grazing-caption-circle-sphere-cut = É um círculo na esfera, cortado onde a esfera se vira para longe da luz.
note-lectures-give-both =
    As aulas (1.6.19) dão aos dois modelos um só expoente, embora com o mesmo o brilho de Blinn seja mais largo; Ting
    2008 dá ao de Blinn um expoente próprio. A guarda retém a luz por trás mas deixa uma borda, pois nenhum dos modelos
    vai a 0 junto com N·L.
holds-only-if-blinn-exponent-n =
    o expoente de Blinn é 4n e a luz está perto da direção de visão. Com o mesmo n o seu brilho é duas vezes mais largo;
    com luz rasante o de Phong se alonga onde o de Blinn fica redondo. Ambos precisam de guarda contra a luz por trás.
fails-small-exponent-no =
    com um expoente tão pequeno nenhum outro iguala os dois: cos(φ)^n e cos(φ/2)^4n concordam perto de φ = 0, e este
    brilho é tão largo quanto a esfera.
chart-title = Altura do brilho
chart-caption =
    Em função do ângulo do raio espelhado ao observador: o de Blinn com o mesmo expoente é largo; com expoente quatro
    vezes maior a curva se aproxima da de Phong.
chart-caption-against-angle-mirrored =
    Em função do ângulo do raio espelhado ao observador: com um expoente tão pequeno a curva de Blinn se afasta da de
    Phong, também com expoente quatro vezes maior.
axis-degrees = φ em graus
axis-highlight = brilho
moved-brightest-pixel-faces = pixel mais claro voltado para longe da luz
r-v-n = (R·V)^n nos centros desses pixels, no máximo (−cos(β))^n; precisão simples
n-h-n = (N·H)^n nos centros desses pixels, no máximo sin(β/2)^n; precisão simples
name-light-no = { $name }, luz a 150°, sem guarda: pixel mais claro voltado para longe da luz
name-same-guard = { $name }, o mesmo com a guarda
by-nothing-behind = nada por trás
highlight-n-exponent = {" "}com n = { $exponent }, a luz a { $value }°, quase atrás da esfera.
shot-yet-highlight-spreads = Mas o brilho se espalha pelo lado escuro.
shot-guard-n-l = Com a guarda N·L > 0.
shot-highlight-ends-light = O brilho termina onde a luz termina, numa borda dura.
untested-highlight-wide-part = o brilho é tão largo quanto a parte iluminada e visível da esfera
untested-highlight-narrower-three = o brilho é mais estreito que três pixels
straight-lines-between = retas entre centros de pixels
