half-step = meio passo de 8 bits
half-pixel = meio pixel
half-step-of-tilt = uma inclinação que muda a luz difusa vinda de lado em meio passo de 8 bits
caption = { $drawn } ({ $name }: { $value }).
nothing-to-cure = Não havia o que curar aqui, { $without } sem a cura
too-little = Aqui isso não basta, { $without } sem isso
not-lit = Nada está iluminado aqui
no-artefact = Nada do artefato se mede aqui
