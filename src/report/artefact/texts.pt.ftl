laboratory = Artefatos de tonalização: afirmações e medidas
lead =
    Cada página testa uma afirmação de livros-texto sobre um artefato de tonalização. Ela mostra imagens, números
    medidos com seus valores esperados e as condições em que a afirmação não vale.
contents = Conteúdo
all = Todos os experimentos
claim = Afirmação
no-formulas = As fórmulas deste experimento só valem para as formas dele. Execute-o sem --mesh para vê-las.
verdict = Veredito
holds = A afirmação vale
holds-only-if = A afirmação vale somente se
fails = A afirmação não vale
absent = Não testada aqui
pictures = Imagens
effect = Efeito da cura
measured = Medidas
numbers = Todas as grandezas medidas e seus valores esperados
plots = Gráficos
explained = Explicação
reproduce = Reproduzir
command =
    Este comando repete as medidas e desenha as imagens de novo. Cada imagem é um arquivo separado, cujo nome está na
    legenda:
live =
    No laboratório, que funciona em um navegador, os parâmetros deste experimento são controles deslizantes: abra
    `{ $link }`. No repositório, `bash bindings/web/build` cria esse arquivo.
column-quantity = grandeza
column-measured = medido
column-expected = esperado
column-within = tolerância
column-agrees = confere
column-by = base do valor esperado
yes = sim
no = NÃO
nothing = –
column-experiment = experimento
column-title = título
column-options = opções
column-own-mesh = medido numa malha do usuário (--mesh)
experiments = Experimentos
role-bad = artefato
role-cured = curado
role-attempt = tentativa de cura
role-absent = nenhum artefato medido
role-difference = diferença
role-truth = referência
role-seen = artefato tênue
gone = sumiu
gone-but-for-rounding = sumiu, salvo arredondamento
times-less = { $times } vezes menor
effect-absent =
    Grandeza medida: { $name }. Vale { $bad }. Um artefato é visível acima de { $from } ({ $why }); portanto não há
    artefato aqui. Com a cura ({ $cure }) a grandeza vale { $cured }.
effect-present =
    Grandeza medida: { $name }. Vale { $bad } com o artefato, { $cured } depois da cura ({ $cure }): { $less }. O
    artefato é visível acima de { $from } ({ $why }). A cura deve levar a grandeza para baixo desse limiar ou torná-la ao menos
    { $factor } vezes menor.
absent-below-threshold =
    o artefato não é visível ({ $name } vale { $bad }; limiar { $from }, { $why }). { $shown-by }
absent-in-pictures = as imagens não mostram o artefato com estes parâmetros ({ $name }: { $bad }). { $shown-by }
shown-in = { $said } Mesmo assim, estas imagens o mostram em parte: { $labels }.
cure-fails =
    { $condition } A cura falha aqui ({ $cure }): { $name } vai de { $bad } a { $cured }. Ou seja, { $less }; é
    preciso que seja ao menos { $factor } vezes menor.
near = { $value } ± { $tolerance }
at-most = no máximo { $value }
miss = { $name }: medido { $found }, esperado { $wanted } ({ $by })
