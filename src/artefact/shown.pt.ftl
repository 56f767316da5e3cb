nothing-cure-here = Não havia o que curar aqui, { $without } sem a cura.
does-too-little = Aqui isso não basta, { $without } sem isso.
nothing-lit-here = Nada está iluminado aqui.
nothing-artefact-measured = Nada do artefato se mede aqui.
