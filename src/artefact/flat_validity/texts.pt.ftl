title = A tonalização plana só é correta com luz e observador distantes
claim =
    A tonalização plana supõe luz e observador no infinito. Ela não é realista nem para objetos facetados. Com luz
    próxima ou, nos brilhos, observador próximo, a direção varia de ponto a ponto da faceta.
source-1 = Aulas: 1.5.1, 1.6.12, 1.6.45
formula-1 = {"|ΔI_d| ≤ 2 k_d \\sin(ε/2), \\quad \\sin(ε) = \\frac{r}{D}"}
formula-1-says = erro da reflexão difusa numa face de circunraio r; a luz está à distância D do centro da face
formula-2 = {"|ΔI_s| ≤ k_s M(n) ε, \\quad M(n) = \\sqrt{n} \\left(1 − \\frac{1}{n}\\right)^{(n − 1)/2}"}
formula-2-says = erro do brilho de Phong com o observador à distância D; M é a maior inclinação de cosⁿ
shown-by = Para mostrá-lo, use luz a menos de 90° da normal da face e mais faces na imagem curada.
lamp-measure = luz pontual a { $ratio } circunraios: maior erro da reflexão difusa
viewer-measure = observador a { $ratio } circunraios: maior erro do brilho
light-along-plate = não comparado: com luz paralela à placa, o arredondamento decide qual lado é iluminado
viewer-aside-measure = observador a { $ratio } circunraios, luz a { $aside }°: maior erro do brilho
share-of-bound-measure = maior erro dividido pelo seu limite
share-of-bound-by = no máximo 1, pelos limites
lamp-small-faces-measure = luz pontual a 2 circunraios, { $segments } × { $segments } faces: maior erro
plate-effect = maior erro da tonalização plana de uma placa sob uma luz pontual próxima
plate-cure = { $segments } × { $segments } faces menores
holds-only-if =
    a luz ou o observador estiverem próximos. A partir de 510 circunraios da face, o limite da reflexão difusa em faces
    planas é meio passo de 8 bits. Muitas vezes o erro já é tão pequeno a distâncias menores. Nesse caso, uma cor por
    face é visualmente exata.
note-1 =
    O erro depende da razão entre a distância da luz e o tamanho da face, e não o do objeto. Por isso, faces menores têm
    o mesmo efeito que uma luz mais distante. Com faces pequenas, o erro é inversamente proporcional ao número de faces
    por lado. A tonalização em cada pixel é exata aqui, pois a normal de uma face plana é conhecida em toda parte.
lamp-by = a fórmula no centro de cada pixel em precisão dupla; tolerância: precisão simples
error-by-distance-title = Erro da tonalização plana em função da distância
error-by-distance-caption =
    { $is-bounded ->
        [yes] Os dois erros ficam abaixo dos seus limites, que caem com o inverso da distância.
       *[no]
            O erro da reflexão difusa fica abaixo do seu limite, que cai com o inverso da distância. O erro do brilho
            não tem limite para expoentes menores que 1 ou se a luz não estiver à frente.
    } A linha horizontal com quadrados é meio passo de 8 bits.
error-by-distance-x = distância em circunraios da face
error-by-distance-y = maior erro
lamp-curve = reflexão difusa
viewer-curve = brilho
bound-diffuse-curve = limite, difusa
bound-highlight-curve = limite, brilho
half-step-curve = meio passo de 8 bits
plate-title = placa, uma face
plate-caption = Uma placa sob uma luz pontual a dois circunraios.
plate-seen = A placa toda tem um só tom de cinza.
plate-small-faces-title = placa, faces pequenas
plate-small-faces-caption = A mesma placa dividida em { $segments } × { $segments } quadrados.
plate-small-faces-seen = A placa é mais escura longe da luz.
small-faces-effect = maior erro da luz num pixel
small-faces-cure = faces menores
flat-title = plana, luz próxima
flat-caption = Uma caixa com uma luz pontual perto de um vértice.
flat-seen = Cada lado tem uma só cor, e a imagem não mostra que a luz está próxima.
every-pixel-title = cada pixel, luz próxima
every-pixel-caption =
    Com tonalização em cada pixel, os lados são claros perto da luz e mais escuros longe dela. Só o ângulo da luz muda;
    não há atenuação pela distância.
flat-small-faces-title = plana, faces pequenas
flat-small-faces-caption = Tonalização plana com cada lado dividido em { $segments } × { $segments } quadrados.
flat-small-faces-seen = Os lados ficam próximos da tonalização exata.
flat-lamp-far-title = plana, luz distante
flat-lamp-far-caption =
    A luz está cem vezes mais longe, sem atenuação. Todos os pontos de um lado têm quase o mesmo ângulo em relação a
    ela.
flat-lamp-far-seen = Uma cor por lado é quase correta.
highlight-effect = maior erro do brilho com luz a { $aside }°
highlight-title = brilho, uma face
highlight-caption =
    Uma placa apenas com o brilho de Phong (n = { $exponent }) de uma luz distante a { $aside }°, com o observador a
    dois circunraios.
highlight-seen = A placa toda tem o tom de cinza do seu centro; o brilho não é visível.
highlight-every-pixel-title = brilho, cada pixel
highlight-every-pixel-caption = Tonalização em cada pixel: a direção ao observador varia de ponto a ponto.
highlight-small-faces-title = brilho, faces pequenas
highlight-small-faces-caption = Tonalização plana com { $segments } × { $segments } quadrados.
highlight-small-faces-seen = O brilho está na posição certa, em degraus.
highlight-cure = { small-faces-cure }
viewer-by = { lamp-by }
viewer-aside-by = { lamp-by }
lamp-small-faces-by = { lamp-by }
