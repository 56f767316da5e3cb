no-recipe = nenhuma receita reproduz as normais gravadas
fits = ajuste das normais gravadas: { $crease }{ $weights } ({ $share } % dos cantos a menos de { $tolerance }°)
fits-rotated =
    ajuste das normais gravadas, depois de uma rotação de todas: { $crease }{ $weights } ({ $share } % dos cantos a menos de
    { $tolerance }°)
any-crease = qualquer ângulo de vinco
crease = ângulo de vinco { $low }°
crease-from = ângulo de vinco { $low }° ou mais
crease-range = ângulo de vinco de { $low }° a { $high }°
crease-and-groups = { $crease } e grupos de suavização
one-weight = , pesos { $weight }
any-weight = , qualquer peso
equal-weights = ; { $names } e { $last } servem igualmente bem
