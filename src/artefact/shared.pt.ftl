half-step = meio passo de 8 bits
half-pixel = meio pixel
half-step-of-tilt = uma inclinação que muda a reflexão difusa de luz lateral em meio passo de 8 bits
caption = { $drawn } ({ $name }: { $value }).
nothing-to-cure = Não há artefato a curar aqui: { $without } sem a cura
too-little = A cura não basta aqui: { $without } sem ela
not-lit = Nada está iluminado aqui
no-artefact = Nenhum artefato é medido aqui
