# Os rótulos de `crease inspect --explain --lang pt`.

about = (gravidade: no máximo { $severity }; grupo: { $group }; conta { $counted })
to-do = O que fazer: { $advice }
fix = Correção: { $command }
no-command = nenhum comando; veja acima
list-end = `crease inspect --explain ID --lang pt` explica um deles.

note = nota
warning = aviso
error = erro

stored = normais gravadas
smoothing = suavização
geometry = geometria
shading = risco de tonalização

corner = cantos
face = faces
edge = arestas
vertex = vértices
node = nós
mesh = malhas
