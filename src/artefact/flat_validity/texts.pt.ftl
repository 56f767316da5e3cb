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
lamp-measure = lâmpada a { $ratio } circunraios: maior erro da luz difusa
viewer-measure = observador a { $ratio } circunraios: maior erro do brilho
light-along-plate = luz ao longo da placa: de que lado está depende de arredondamento
viewer-aside-measure = observador a { $ratio } circunraios, luz { $aside }° ao lado: maior erro do brilho
share-of-bound-measure = maior erro sobre o seu limite
share-of-bound-by = os limites valem
lamp-small-faces-measure = lâmpada a 2 circunraios, { $segments } × { $segments } faces: maior erro
plate-effect = maior erro do sombreamento plano de uma placa sob a lâmpada próxima
plate-cure = { $segments } × { $segments } faces menores
holds-only-if =
    a luz ou o observador estão próximos. A partir de 510 circunraios da face, o sombreamento plano de faces planas sob
    luz difusa está certo até meio passo de 8 bits por seu limite, muitas vezes antes: então uma cor por face é tudo o
    que há para ver.
note-1 =
    O que conta é a distância da luz sobre o tamanho da face, não do objeto: dividir as faces cura tanto quanto afastar
    a lâmpada, e o erro cai por fim como um sobre o número delas ao longo de um lado. Iluminar cada pixel é exato aqui:
    numa face plana a normal é conhecida em toda parte.
lamp-by = a fórmula da luz no centro de cada pixel em precisão dupla; precisão simples
error-by-distance-title = Erro do sombreamento plano pela distância
error-by-distance-caption =
    { $is-bounded ->
        [yes] Ambos os erros ficam abaixo dos seus limites, que caem como um sobre a distância.
       *[no]
            O erro da luz difusa fica abaixo do seu limite, que cai como um sobre a distância; o do brilho não tem
            limite para expoentes menores que 1 nem onde a luz não vem da frente.
    } A linha horizontal com quadrados é meio passo de 8 bits.
error-by-distance-x = distância em circunraios da face
error-by-distance-y = maior erro
lamp-curve = lâmpada, difusa
viewer-curve = observador, brilho
bound-diffuse-curve = limite, difusa
bound-highlight-curve = limite, brilho
half-step-curve = meio passo de 8 bits
plate-title = placa, uma face
plate-caption = Uma placa sob uma lâmpada a dois circunraios.
plate-seen = Toda ela tem um só cinza.
plate-small-faces-title = placa, faces pequenas
plate-small-faces-caption = A mesma placa dividida em { $segments } × { $segments } quadrados.
plate-small-faces-seen = A luz diminui para longe da lâmpada.
small-faces-effect = maior erro da luz de um pixel
small-faces-cure = faces menores
flat-title = plano, lâmpada próxima
flat-caption = Há uma lâmpada perto do canto da caixa.
flat-seen = Mas cada lado tem uma só cor: nada mostra que a lâmpada está próxima.
every-pixel-title = cada pixel, lâmpada próxima
every-pixel-caption =
    Iluminados pixel a pixel, os lados são claros perto da lâmpada e escurecem longe dela, só pelo ângulo da luz: a
    distância nada tira aqui.
flat-small-faces-title = plano, faces pequenas
flat-small-faces-caption =
    O mesmo sombreamento plano com cada lado dividido em { $segments } × { $segments } quadrados.
flat-small-faces-seen = Mais perto da verdade.
flat-lamp-far-title = plano, lâmpada distante
flat-lamp-far-caption =
    A lâmpada cem vezes mais longe, sem enfraquecer: todos os pontos de um lado a veem com a mesma inclinação.
flat-lamp-far-seen = Agora uma cor por lado está quase certa.
highlight-effect = maior erro do brilho de uma luz { $aside }° ao lado
highlight-title = brilho, uma face
highlight-caption =
    Uma placa só com um brilho (de Phong, n = { $exponent }) de uma luz distante { $aside }° ao lado, o observador a
    dois circunraios.
highlight-seen = Um só cinza, o do meio: não há brilho no seu lugar.
highlight-every-pixel-title = brilho, cada pixel
highlight-every-pixel-caption = Iluminada pixel a pixel: a direção ao observador varia de ponto a ponto.
highlight-small-faces-title = brilho, faces pequenas
highlight-small-faces-caption = Sombreamento plano de { $segments } × { $segments } quadrados.
highlight-small-faces-seen = O brilho está no lugar, em degraus.
highlight-cure = { small-faces-cure }
viewer-by = { lamp-by }
viewer-aside-by = { lamp-by }
lamp-small-faces-by = { lamp-by }
