title = Quando o sombreamento plano está certo
claim =
    O sombreamento plano supõe luz e observador no infinito. Não é realístico nem para objetos facetados: para uma
    lâmpada próxima, e nos brilhos para um observador próximo, a direção varia de ponto a ponto da faceta.
source-1 = Aulas: 1.5.1, 1.6.12, 1.6.45
formula-1 = {"|ΔI_d| ≤ 2 k_d \\sin(ε/2), \\quad \\sin(ε) = \\frac{r}{D}"}
formula-1-says = o erro da luz difusa numa face de circunraio r, com a luz à distância D do seu centro
formula-2 = {"|ΔI_s| ≤ k_s M(n) ε, \\quad M(n) = \\sqrt{n} \\left(1 − \\frac{1}{n}\\right)^{(n − 1)/2}"}
formula-2-says = o erro do brilho de Phong com o observador à distância D; M é a maior inclinação de cosⁿ
shown-by = luz a menos de 90° da face, e mais faces na imagem curada, o mostrariam.
measure-lamp-ratio-circumradii = lâmpada a { $ratio } circunraios: maior erro da luz difusa
measure-viewer-ratio-circumradii = observador a { $ratio } circunraios: maior erro do brilho
untested-light-along-plate = luz ao longo da placa: de que lado está depende de arredondamento
measure-viewer-ratios-circumradii = observador a { $ratios-0 } circunraios, luz { $value }° ao lado: maior erro do brilho
measure-largest-error-over = maior erro sobre o seu limite
by-bounds-hold = os limites valem
measure-lamp-circumradii-segments = lâmpada a 2 circunraios, { $segments } × { $segments } faces: maior erro
moved = maior erro do sombreamento plano de uma placa sob a lâmpada próxima
cure = { $segments } × { $segments } faces menores
holds-only-if-light-or-viewer =
    a luz ou o observador estão próximos. A partir de 510 circunraios da face, o sombreamento plano de faces planas sob
    luz difusa está certo até meio passo de 8 bits por seu limite, muitas vezes antes: então uma cor por face é tudo o
    que há para ver.
note-counts-light-distance =
    O que conta é a distância da luz sobre o tamanho da face, não do objeto: dividir as faces cura tanto quanto afastar
    a lâmpada, e o erro cai por fim como um sobre o número delas ao longo de um lado. Iluminar cada pixel é exato aqui:
    numa face plana a normal é conhecida em toda parte.
formula-light-every = a fórmula da luz no centro de cada pixel em precisão dupla; precisão simples
chart-title = Erro do sombreamento plano pela distância
chart-caption =
    Ambos os erros ficam abaixo dos seus limites, que caem como um sobre a distância. A linha horizontal com quadrados é
    meio passo de 8 bits.
chart-caption-error-diffuse-light =
    O erro da luz difusa fica abaixo do seu limite, que cai como um sobre a distância; o do brilho não é comparado com
    limite para expoentes menores que 1 nem onde a luz não vem da frente. A linha horizontal com quadrados é meio passo
    de 8 bits.
axis-distance-circumradii-face = distância em circunraios da face
axis-largest-error = maior erro
lamp-diffuse = lâmpada, difusa
viewer-highlight = observador, brilho
bound-diffuse = limite, difusa
bound-highlight = limite, brilho
half-step-bits = meio passo de 8 bits
plate-title = placa, uma face
plate-caption-plate-under-lamp = Uma placa sob uma lâmpada a dois circunraios.
plate-caption-all-grey = Toda ela tem um só cinza.
plate-small-faces-title = placa, faces pequenas
plate-small-faces-caption-same-plate-cut = A mesma placa dividida em { $segments } × { $segments } quadrados.
plate-small-faces-caption-light-falls-off = A luz diminui para longe da lâmpada.
moved-largest-error-pixel = maior erro da luz de um pixel
cure-smaller-faces = faces menores
flat-title = plano, lâmpada próxima
flat-caption-lamp-stands-near = Há uma lâmpada perto do canto da caixa.
flat-caption-but-each-side = Mas cada lado tem uma só cor: nada mostra que a lâmpada está próxima.
every-pixel-title = cada pixel, lâmpada próxima
every-pixel-caption-lit-every-pixel =
    Iluminados pixel a pixel, os lados são claros perto da lâmpada e escurecem longe dela, só pelo ângulo da luz: a
    distância nada tira aqui.
flat-small-faces-title = plano, faces pequenas
flat-small-faces-caption-same-flat-shading =
    O mesmo sombreamento plano com cada lado dividido em { $segments } × { $segments } quadrados.
flat-small-faces-caption-closer-truth = Mais perto da verdade.
flat-lamp-far-title = plano, lâmpada distante
flat-lamp-far-caption-lamp-moved-hundred =
    A lâmpada cem vezes mais longe, sem enfraquecer: todos os pontos de um lado a veem com a mesma inclinação.
flat-lamp-far-caption-now-colour-side = Agora uma cor por lado está quase certa.
moved-largest-error-highlight = maior erro do brilho de uma luz { $value }° ao lado
highlight-title = brilho, uma face
highlight-caption-plate-nothing-but =
    Uma placa só com um brilho (de Phong, n = { $exponent }) de uma luz distante { $value }° ao lado, o observador a
    dois circunraios.
highlight-caption-grey-middle-no = Um só cinza, o do meio: não há brilho no seu lugar.
highlight-every-pixel-title = brilho, cada pixel
highlight-every-pixel-caption-lit-every-pixel = Iluminada pixel a pixel: a direção ao observador varia de ponto a ponto.
highlight-small-faces-title = brilho, faces pequenas
highlight-small-faces-caption-flat-shading-segments = Sombreamento plano de { $segments } × { $segments } quadrados.
highlight-small-faces-caption-highlight-place-steps = O brilho está no lugar, em degraus.
