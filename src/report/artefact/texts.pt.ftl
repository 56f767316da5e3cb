laboratory = O laboratório de artefatos
lead =
    Afirmações dos livros sobre os artefatos de tonalização, postas à prova: cada uma com imagens, números medidos ao
    lado das suas fórmulas, e as condições em que falha.
contents = Conteúdo
all = Todos os experimentos
claim = A afirmação
no-formulas = As fórmulas deste experimento são das suas próprias formas; sem --mesh ele as mostra.
verdict = Veredito
holds = Vale
holds-only-if = Vale somente se
fails = Não vale
absent = Não posto à prova aqui
pictures = Imagens
effect = Efeito da cura
measured = Medido
numbers = Cada grandeza, com o valor esperado onde é conhecido
plots = Gráficos
explained = Explicação
reproduce = Refazer
command = Um comando desenha e mede tudo isto de novo; cada imagem é um arquivo, cujo nome está abaixo dela:
column-quantity = grandeza
column-measured = medido
column-expected = esperado
column-within = tolerância
column-agrees = confere
column-by = por
yes = sim
no = NÃO
nothing = –
column-experiment = experimento
column-title = título
column-options = opções
column-own-mesh = medido na sua malha (--mesh)
experiments = Experimentos
role-bad = artefato
role-cured = curado
role-attempt = tentativa de cura
role-absent = nenhum artefato medido
role-difference = diferença
role-truth = verdade
role-seen = como se vê
gone = sumiu
gone-but-for-rounding = sumiu, salvo arredondamento
times-less = { $times } vezes menos
effect-absent =
    Grandeza medida: { $name }. Vale { $bad }, o que não é artefato: há um acima de { $from } ({ $why }). Com a cura
    ({ $cure }) fica { $cured }.
effect-present =
    Grandeza medida: { $name }. Vale { $bad } com o artefato, { $cured } depois da cura ({ $cure }): { $less }. Há artefato
    acima de { $from } ({ $why }); a cura tem de levá-la abaixo disso, ou torná-la ao menos { $factor } vezes menor.
absent-below-threshold = { $name } é { $bad }, e acima de { $from } isso seria visível ({ $why }); { $shown-by }
absent-in-pictures = com estes parâmetros as imagens não o mostram ({ $name }: { $bad }); { $shown-by }
shown-in = { $said } Estas imagens mostram algo dele mesmo assim: { $labels }.
cure-fails =
    { $condition } A cura falha aqui ({ $cure }): { $name } vai de { $bad } a { $cured }, { $less } onde devem ser { $factor }.
near = { $value } ± { $tolerance }
at-most = no máximo { $value }
miss = { $name }: medido { $found }, esperado { $wanted } ({ $by })
