# What findings say about a file in addition to their titles.

in-closed-components = in { $count } closed { $count ->
    [one] component
   *[other] components
 }
in-open-components = in { $count } open { $count ->
    [one] component
   *[other] components
 }
could-be-merged = { $count } { $count ->
    [one] vertex
   *[other] vertices
 } could be merged
contradicted = { $sum }, contradicted by the stored normals; not counted: { $components } { $components ->
    [one] other component
   *[other] other components
 } with { $count } faces, which no stored normals contradict
of-lower-severity = not counted: { $count } of lower severity in other submeshes

far-from-origin =
    { $bits } bits remain for the height of a typical face, and rounding rotates its normal by up to { $largest }°; the
    expected mean over all faces, including slender ones, is { $mean }°
slope = the slope of brightness jumps by up to { $steps } steps a pixel
outline = off by up to { $pixels } pixels if the mesh is { $size } pixels wide

quantised = { $grid }, { $error }
quantised-measured = { $grid }, { $measured }; { $error }
rounding-error =
    the error of rounding is at most { $degrees }°, { $visibility }; the exponent { $exponent } of the material needs
    { $bits } bits a component
visible-from = not visible up to the exponent { $exponent }
always-visible = which may be visible even on a matt surface
measured-error = they differ from their recipe by up to { $largest }° (rms { $rms }°)
measured-error-of-some =
    they differ from their recipe by up to { $largest }° (rms { $rms }°) at the { $explained } of { $compared } corners
    that rounding explains

decimals = { $count ->
    [1] one decimal
    [2] two decimals
    [3] three decimals
   *[other] four decimals
 }
signed-integers = { $bits }-bit signed integers over { $scale }
unsigned-integers = { $bits }-bit unsigned integers, 2k/{ $largest } − 1
renormalised = { $numbers }, renormalised
octahedral-codes = octahedral codes of 2 × { $numbers }

stored-as = { $from } is stored as { $to }
or-another-change = { $change } (or another change with the same effect on this shape)
or-other-changes = { $change } (or one of { $count } changes with the same effect on this shape)
rotated-by = by { $degrees }°
rotated-and-reversed = by { $degrees }°, and reversed

applied-twice-node = the matrix of node `{ $first }` is already applied to the normals and applies twice
applied-twice-nodes = the matrices of nodes `{ $first }` to `{ $last }` are already applied to the normals and apply twice
undone-node = the matrix of node `{ $first }` is undone in the normals
undone-nodes = the matrices of nodes `{ $first }` to `{ $last }` are undone in the normals
applied-elsewhere-node = the matrix of node `{ $first }` is applied to the normals in the wrong space
applied-elsewhere-nodes = the matrices of nodes `{ $first }` to `{ $last }` are applied to the normals in the wrong space
undone-elsewhere-node = the matrix of node `{ $first }` is undone in the normals in the wrong space
undone-elsewhere-nodes = the matrices of nodes `{ $first }` to `{ $last }` are undone in the normals in the wrong space
or-another-mistake = { $mistake }, or another mistake with the same effect
