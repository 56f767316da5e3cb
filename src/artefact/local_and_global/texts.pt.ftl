title = A luz ambiente não torna global o modelo de Phong
claim = O modelo de Phong é global, porque o seu termo ambiente inclui a luz do resto da cena.
source-1 = Aulas: exercícios 1.6.20, 1.6.34 e 1.6.39 (que o negam)
source-2 = Traçado de raios: T. Whitted, An improved illumination model for shaded display, Communications of the ACM 23(6), 1980
formula-1 = {"I = k_a I_a + k_d I_d (N·L)"}
formula-1-says = o modelo local: a mesma soma na luz e na sombra de outro objeto
formula-2 = {"I = k_a I_a + V k_d I_d (N·L) + k_r I_r + k_t I_t"}
formula-2-says =
    o modelo de Whitted: V é 0 se um objeto esconde a lâmpada e 1 se não; I_r e I_t são a luz ao longo do raio refletido e
    do refratado
shown-by = Use imagens maiores (--size) para mostrá-lo.
shadow-local-measure = piso na sombra da bola, modelo local
shadow-local-by = k_a I_a + k_d I_d (N·L), como no piso iluminado; tolerância: precisão simples
shadow-traced-measure = piso na sombra da bola, traçado de raios
shadow-traced-by = k_a I_a; tolerância: precisão simples
shadow-dark-measure = piso na sombra da bola, traçado de raios sem luz ambiente
shadow-dark-by = 0: só a luz ambiente chega lá; tolerância: precisão simples
mirror-local-measure = espelho diante do piso iluminado, modelo local
mirror-local-by = 0: o espelho não tem cor própria; tolerância: precisão simples
mirror-traced-measure = espelho diante do piso iluminado, traçado de raios
mirror-traced-by = k_r vezes a luz do piso; tolerância: precisão simples
share-shadow-measure = diferenças ao quadrado na sombra, no piso
share-mirror-measure = diferenças ao quadrado no espelho
share-glass-measure = diferenças ao quadrado na bola de vidro
share-elsewhere-measure = diferenças ao quadrado no restante
share-elsewhere-by = 0: sem sombra, espelho e vidro, os dois modelos são iguais; tolerância: arredondamento
ball-measure = bola opaca: maior diferença
ball-by = 0: nada esconde a lâmpada dela; tolerância: meio passo de 8 bits
global-effect = diferença da imagem traçada com 24 reflexões e refrações (rms)
global-cure = traçado de raios, 8 reflexões e refrações
ambient-effect = diferença da imagem traçada com luz ambiente (rms)
ambient-cure = luz ambiente
fails =
    a luz ambiente é uma só constante, somada em toda parte. Ela mantém visíveis as superfícies que a lâmpada não alcança,
    mas não tem sombras, nem imagens no espelho, nem refração. Todas as diferenças estão nesses lugares.
local-title = modelo local de Phong
local-caption = Uma bola, um espelho e uma bola de vidro sob uma lâmpada distante e luz ambiente de { $ambient }, com o modelo local de Phong.
local-seen = Não há sombra, e o espelho e o vidro são pretos.
traced-title = traçado de raios
traced-caption = A mesma cena por traçado de raios, com sombras, reflexão e refração.
traced-seen = As bolas têm sombra, o espelho mostra a cena, e a bola de vidro a mostra invertida.
difference-title = diferença
difference-caption = Diferença entre a imagem local e a traçada: violeta é 0, amarelo é { $full } ou mais.
dark-title = traçado, sem luz ambiente
dark-caption = A cena por traçado de raios sem luz ambiente.
dark-seen = O que a lâmpada não alcança é preto.
lit-title = traçado, com luz ambiente
lit-caption = A cena por traçado de raios com luz ambiente de { $ambient }.
lit-seen = As sombras mantêm a luz ambiente.
note-1 =
    O exercício 1.6.20 pergunta se o termo ambiente torna o modelo global. Não torna: um modelo global calcula a luz do
    resto da cena, e o termo ambiente a estima como uma constante.
note-2 =
    O exercício 1.6.39 pergunta se um objeto sem luz direta pode ser visível. Num modelo local só a luz ambiente o torna
    visível. Num modelo global, a luz de outras superfícies o faz.
note-3 =
    O traçado de raios de Whitted é global só para a luz espelhada e refratada. Ele não segue a luz entre superfícies
    difusas, por isso ainda precisa de luz ambiente. Objetos transparentes têm sombra inteira, sem cáusticas.
