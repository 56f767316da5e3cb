no-recipe = no recipe reproduces the stored normals
fits = stored normals fit { $crease }{ $weights } ({ $share } % of corners within { $tolerance }°)
fits-rotated =
    stored normals, after a rotation of all, fit { $crease }{ $weights } ({ $share } % of corners within { $tolerance }°)
any-crease = any crease angle
crease = crease { $low }°
crease-from = crease { $low }° or more
crease-range = crease { $low }° to { $high }°
crease-and-groups = { $crease } and smoothing groups
one-weight = , { $weight } weights
any-weight = , any weight
equal-weights = ; { $names } and { $last } fit equally well
