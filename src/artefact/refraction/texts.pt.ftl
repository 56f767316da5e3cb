title = A água parece ter três quartos da profundidade só vista de cima
claim = Um ponto na água parece estar a 1/n da sua profundidade, e uma bola de vidro tem a distância focal nR/(2(n − 1)).
source-1 = Aulas: traçado de raios (“imagens com refrações”), exercício 1.6.34
source-2 = Traçado de raios: T. Whitted, An improved illumination model for shaded display, Communications of the ACM 23(6), 1980
formula-1 = {"\\sin θ = n \\sin θ′, \\quad \\frac{d′}{d} = \\frac{\\tan θ′}{\\tan θ}"}
formula-1-says = lei de Snell, e a profundidade aparente d′ de um ponto à profundidade d, visto ao ângulo θ da vertical
formula-2 = {"f(h) = \\frac{h}{\\sin\\left(2(\\arcsin\\frac{h}{R} − \\arcsin\\frac{h}{n R})\\right)}"}
formula-2-says =
    distância do centro de uma bola de raio R em que um raio que entra à altura h cruza o eixo; para h pequeno ela é
    nR/(2(n − 1))
shown-by = Use imagens maiores (--size) para mostrá-lo.
depth-measure = água (n = { $water }): profundidade aparente sobre profundidade, a { $view }° da vertical
depth-by = tan θ′/tan θ; tolerância: as posições no fundo são cores em precisão simples
focus-measure = bola de vidro (n = { $glass }): distância focal do raio a { $height } R
focus-by = h/sin(2(arcsin(h/R) − arcsin(h/(nR)))); tolerância: as posições em dois anteparos são cores em precisão simples
paraxial-measure = bola de vidro: distância focal no limite de raios próximos do eixo
paraxial-by = nR/(2(n − 1)); tolerância: a fração (h/R)² para a altura do raio medido, e arredondamento
stick-effect = fundo da água: deslocamento em relação à lei de Snell na imagem
stick-cure = raios refratados
power-effect = bola de vidro: diferença do inverso da distância focal em relação à lei de Snell
power-cure = raios refratados
why-power = uma mudança da distância focal de menos de um centésimo
holds-only-if =
    os raios estiverem próximos da vertical ou do eixo. A { $angle }° da vertical, a água parece ter { $share } da sua profundidade.
    Raios a 0,7 R cruzam o eixo mais perto da bola do que os próximos do eixo: é a aberração esférica.
stick-straight-title = vara, sem refração
stick-straight-caption = Uma vara em água colorida com o índice 1, vista a { $angle }° da vertical. A luz segue reta.
stick-straight-seen = A vara é reta, e a água tem toda a sua profundidade.
stick-title = vara na água
stick-caption = A mesma vara e a mesma água com o índice { $water }, por traçado de raios.
stick-seen = A vara tem uma quebra na superfície, e o fundo da água parece mais alto.
ball-straight-title = bola, sem refração
ball-straight-caption = Uma bola com o índice 1 diante de faixas oblíquas.
ball-straight-seen = A bola é invisível.
ball-title = bola de vidro
ball-caption = A mesma bola com o índice { $glass }, por traçado de raios.
ball-seen = As faixas na bola estão invertidas, e comprimidas perto do contorno.
depth-by-angle-title = Profundidade aparente da água
depth-by-angle-caption =
    Profundidade aparente sobre profundidade, em função do ângulo com a vertical. Começa em 1/n e cai até 0 em vistas
    rasantes.
depth-by-angle-x = ângulo com a vertical, graus
depth-by-angle-y = profundidade aparente sobre profundidade
focus-by-height-title = Distância focal de uma bola de vidro
focus-by-height-caption =
    Distância do centro em que um raio cruza o eixo, em função da sua altura. Começa em nR/(2(n − 1)) e cai com a
    altura.
focus-by-height-x = altura do raio, em raios da bola
focus-by-height-y = distância focal, em raios da bola
measured-curve = medido
law-curve = lei de Snell
note-1 =
    Um modelo local não tem raios que seguem adiante; por isso não desenha refração. O traçado de raios segue cada raio
    através da superfície pela lei de Snell e divide a sua luz pelas equações de Fresnel. Aqui ele mede posições: a cor
    de um anteparo é a posição nele.
