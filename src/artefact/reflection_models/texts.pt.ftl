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
same-exponent-by = o maior em φ, por uma varredura de 10 001 ângulos; meio pixel
highlight-below-pixel = o brilho mal é mais largo que um pixel
width-phong-measure = luz a 120°: brilho de Phong, largura transversal sobre a longitudinal
width-phong-by = meias larguras à meia altura em forma fechada; 2 para brilhos estreitos
width-blinn-measure = luz a 120°: brilho de Blinn, largura transversal sobre a longitudinal
width-blinn-by = redondo
exponent-effect = maior diferença do brilho de Phong
exponent-cure = expoente quatro vezes maior
width-effect = largura transversal sobre a longitudinal, menos 1, onde ambas se podem medir
why-width = um décimo da sua largura
same-exponent-measure = mesmo n: maior diferença
fourfold-exponent-measure = Blinn com 4n: maior diferença
phong-title = Phong, expoente n
phong-caption = O brilho de Phong numa esfera, luz e observador em frente; n = { $exponent }.
blinn-same-n-title = Blinn, expoente n
blinn-same-n-caption = O de Blinn com o mesmo expoente.
blinn-4n-title = Blinn, expoente 4n
blinn-4n-caption = O de Blinn com expoente quatro vezes maior.
blinn-4n-seen = Fica muito mais perto do de Phong.
phong-grazing-title = Phong, luz a 120°
phong-grazing-caption = Luz vinda de trás e de lado, n = { $exponent }.
phong-grazing-seen =
    Aqui é o brilho de Phong que erra: ele se alonga para cima e para baixo, através do plano da luz e da visão, como
    superfícies ásperas reais não o mostram.
blinn-grazing-title = Blinn 4n, luz a 120°
blinn-grazing-caption = O de Blinn sob a mesma luz, com 4n = { $blinn-exponent }.
blinn-grazing-seen = É um círculo na esfera, cortado onde a esfera se vira para longe da luz.
note-1 =
    As aulas (1.6.19) dão aos dois modelos um só expoente, embora com o mesmo o brilho de Blinn seja mais largo; Ting
    2008 dá ao de Blinn um expoente próprio. A guarda retém a luz por trás mas deixa uma borda, pois nenhum dos modelos
    vai a 0 junto com N·L.
holds-only-if =
    o expoente de Blinn é 4n e a luz está perto da direção de visão. Com o mesmo n o seu brilho é duas vezes mais largo;
    com luz rasante o de Phong se alonga onde o de Blinn fica redondo. Ambos precisam de guarda contra a luz por trás.
fails =
    com um expoente tão pequeno nenhum outro iguala os dois: cos(φ)^n e cos(φ/2)^4n concordam perto de φ = 0, e este
    brilho é tão largo quanto a esfera.
highlights-title = Altura do brilho
highlights-x = φ em graus
highlights-y = brilho
behind-effect = pixel mais claro voltado para longe da luz
behind-phong-by = (R·V)^n nos centros desses pixels, no máximo (−cos(β))^n; precisão simples
behind-by = (N·H)^n nos centros desses pixels, no máximo sin(β/2)^n; precisão simples
behind-measure = Blinn, luz a { $behind }°, sem guarda: pixel mais claro virado para longe da luz
behind-guarded-measure = Blinn, o mesmo com a guarda
behind-guarded-by = nada por trás
behind-seen = Mas o brilho se espalha pelo lado escuro.
behind-guarded-caption = Com a guarda N·L > 0.
behind-guarded-seen = O brilho termina onde a luz termina, numa borda dura.
highlight-too-wide = o brilho é tão largo quanto a parte iluminada e visível da esfera
highlight-too-narrow = o brilho é mais estreito que três pixels
fourfold-exponent-by = { same-exponent-by }
width-cure = { blinn-grazing-title }
behind-cure = a guarda N·L > 0
blinn-same-n-seen =
    É mais largo: à meia altura onde a normal está a { $blinn-angle }° do observador, o de Phong a { $phong-angle }°.
highlights-caption =
    Em função do ângulo do raio espelhado ao observador: { $is-cured ->
        [yes]
            o de Blinn com o mesmo expoente é largo; com expoente quatro vezes maior a curva se aproxima da de Phong.
       *[no]
            com um expoente tão pequeno a curva de Blinn se afasta da de Phong, também com expoente quatro vezes maior.
    }
phong-curve = { phong-title }
blinn-same-n-curve = { blinn-same-n-title }
blinn-4n-curve = { blinn-4n-title }
behind-phong-measure = Phong, luz a { $behind }°, sem guarda: pixel mais claro virado para longe da luz
behind-phong-guarded-measure = Phong, o mesmo com a guarda
behind-phong-guarded-by = { behind-guarded-by }
behind-title = Blinn, luz atrás, sem guarda
behind-guarded-title = Blinn, luz atrás, com guarda
behind-phong-title = Phong, luz atrás, sem guarda
behind-phong-guarded-title = Phong, luz atrás, com guarda
behind-caption = O brilho de Blinn com n = { $exponent }, a luz a { $behind }°, quase atrás da esfera.
behind-phong-caption = O brilho de Phong com n = { $exponent }, a luz a { $behind }°, quase atrás da esfera.
behind-phong-seen = { behind-seen }
behind-phong-guarded-caption = { behind-guarded-caption }
behind-phong-guarded-seen = { behind-guarded-seen }
