title = O brilho de Blinn precisa de quatro vezes o expoente de Phong
claim =
    O vetor intermediário de Blinn dá quase o mesmo brilho que o raio refletido de Phong, mas com outro expoente. O
    ângulo com o vetor intermediário é metade do ângulo com o raio refletido.
source-1 = Aulas: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23
source-2 = Ting 2008: “Phong modificado”
source-3 = Artigo: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994
formula-1 = {"(V·R)^n = \\cos(φ)^n ≈ \\cos(φ/2)^{4n} = (N·H)^{4n}"}
formula-1-says = no plano de L e V; φ é o ângulo entre o raio refletido e o observador
formula-2 = {"\\frac{w_\\mathrm{transversal}}{w_\\mathrm{longitudinal}} ≈ \\frac{1}{\\cos(β/2)}"}
formula-2-says =
    alongamento do brilho de Phong numa esfera, perpendicular ao plano de L e V; β é o ângulo entre eles. O brilho de
    Blinn é redondo
formula-3 = {"I_\\mathrm{trás} = k_s \\sin(β/2)^n"}
formula-3-says = brilho de Blinn no terminador, N·L = 0; sem a guarda, ele continua além do terminador
formula-4 = {"I_\\mathrm{trás} = k_s (−\\cos(β))^n"}
formula-4-says = brilho de Phong no terminador, se a luz está atrás, β > 90°
shown-by = Use um brilho de alguns pixels (expoentes de 1 a 100, ou uma imagem maior) para mostrá-lo.
same-exponent-by = maior valor entre 10 001 ângulos φ; tolerância: meio pixel
highlight-below-pixel = não comparado: o brilho é pouco mais largo que um pixel
width-phong-measure = luz a 120°: brilho de Phong, razão entre as larguras transversal e longitudinal
width-phong-by = fórmula das meias larguras à meia altura; 2 para brilhos estreitos
width-blinn-measure = luz a 120°: brilho de Blinn, razão entre as larguras transversal e longitudinal
width-blinn-by = 1, pois o brilho é redondo
exponent-effect = maior diferença em relação ao brilho de Phong
exponent-cure = quatro vezes o expoente
width-effect = razão entre as larguras transversal e longitudinal, menos 1, se ambas forem mensuráveis
why-width = um décimo da largura do brilho
same-exponent-measure = Blinn com n: maior diferença
fourfold-exponent-measure = Blinn com 4n: maior diferença
phong-title = Phong, expoente n
phong-caption = Brilho de Phong numa esfera, com luz e observador em frente; n = { $exponent }.
blinn-same-n-title = Blinn, expoente n
blinn-same-n-caption = Brilho de Blinn com o mesmo expoente.
blinn-4n-title = Blinn, expoente 4n
blinn-4n-caption = Brilho de Blinn com quatro vezes o expoente.
blinn-4n-seen = Ele fica muito mais perto do brilho de Phong.
phong-grazing-title = Phong, luz a 120°
phong-grazing-caption = Brilho de Phong com a luz a 120°, n = { $exponent }.
phong-grazing-seen =
    Aqui o brilho de Phong está errado: ele se alonga na vertical, perpendicular ao plano da luz e da visão. Superfícies
    ásperas reais não mostram isso.
blinn-grazing-title = Blinn 4n, luz a 120°
blinn-grazing-caption = Brilho de Blinn sob a mesma luz, com 4n = { $blinn-exponent }.
blinn-grazing-seen = Ele é um círculo na esfera, cortado no terminador.
note-1 =
    As aulas (1.6.19) usam um só expoente para os dois modelos, embora o brilho de Blinn seja mais largo com o mesmo
    expoente. Ting 2008 usa um expoente próprio para Blinn. A guarda remove a luz por trás, mas deixa uma borda, pois
    nenhum dos modelos é 0 onde N·L é 0.
holds-only-if =
    o expoente de Blinn for 4n e a luz estiver perto da direção de visão. Com o mesmo n, o brilho de Blinn é duas vezes
    mais largo. Com luz rasante, o brilho de Phong se alonga e o de Blinn continua redondo; ambos precisam de guarda
    contra a luz por trás.
fails =
    com um expoente tão pequeno, nenhum outro expoente iguala os dois modelos. cos(φ)^n e cos(φ/2)^4n concordam perto de
    φ = 0, e este brilho é tão largo quanto a esfera.
highlights-title = Brilho em função do ângulo
highlights-x = ângulo do raio refletido ao observador, graus
highlights-y = brilho
behind-effect = pixel mais claro de costas para a luz
behind-phong-by = (R·V)^n nos centros desses pixels, no máximo (−cos(β))^n; tolerância: precisão simples
behind-by = (N·H)^n nos centros desses pixels, no máximo sin(β/2)^n; tolerância: precisão simples
behind-measure = Blinn, luz a { $behind }°, sem guarda: pixel mais claro de costas para a luz
behind-guarded-measure = Blinn, a mesma luz com a guarda: pixel mais claro de costas para a luz
behind-guarded-by = 0: nenhuma luz por trás
behind-seen = O brilho se espalha pelo lado escuro.
behind-guarded-caption = A mesma luz com a guarda N·L > 0.
behind-guarded-seen = O brilho termina no terminador, com uma borda nítida.
highlight-too-wide = não comparado: o brilho é tão largo quanto a parte iluminada e visível da esfera
highlight-too-narrow = não comparado: o brilho é mais estreito que três pixels
fourfold-exponent-by = { same-exponent-by }
width-cure = { blinn-grazing-title }
behind-cure = a guarda N·L > 0
blinn-same-n-seen =
    Ele é mais largo: cai à metade da altura onde a normal está a { $blinn-angle }° do observador; o brilho de Phong, a
    { $phong-angle }°.
highlights-caption =
    Brilho em função do ângulo entre o raio refletido e o observador. { $is-cured ->
        [yes] A curva de Blinn é larga com o mesmo expoente, e próxima da de Phong com quatro vezes o expoente.
       *[no]
            Com um expoente tão pequeno, a curva de Blinn difere da de Phong, mesmo com quatro vezes o expoente.
    }
phong-curve = { phong-title }
blinn-same-n-curve = { blinn-same-n-title }
blinn-4n-curve = { blinn-4n-title }
behind-phong-measure = Phong, luz a { $behind }°, sem guarda: pixel mais claro de costas para a luz
behind-phong-guarded-measure = Phong, a mesma luz com a guarda: pixel mais claro de costas para a luz
behind-phong-guarded-by = { behind-guarded-by }
behind-title = Blinn, luz atrás, sem guarda
behind-guarded-title = Blinn, luz atrás, com guarda
behind-phong-title = Phong, luz atrás, sem guarda
behind-phong-guarded-title = Phong, luz atrás, com guarda
behind-caption = Brilho de Blinn com n = { $exponent }; a luz está a { $behind }°, quase atrás da esfera.
behind-phong-caption = Brilho de Phong com n = { $exponent }; a luz está a { $behind }°, quase atrás da esfera.
behind-phong-seen = { behind-seen }
behind-phong-guarded-caption = { behind-guarded-caption }
behind-phong-guarded-seen = { behind-guarded-seen }
