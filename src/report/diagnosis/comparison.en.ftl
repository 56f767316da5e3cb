lit-before = the mesh lit with the normals that it had before
lit-after = the mesh lit with the normals that it has after
changed = the mesh coloured by how far its normals changed, { $scale }
lit-caption = Left: before. Middle: after. Right: by how much the normals of each corner changed; a ring marks the place that changed most of those that are seen.
off-before = before: the mesh coloured by the deviation of its normals from the rule that they follow, { $scale }
off-after = after: the mesh coloured by the deviation of its normals from the rule that they follow, { $scale }
off-caption = How far normals are from those that the rule of their own mesh gives, before and after.
numbers = In { $name }, { $changed } of { $corners } corners have another direction, { $visible } of them visibly: by { $largest }° at most ({ $largest-steps } of 255 grey steps under a key light) and { $mean }° in the mean ({ $mean-steps } steps). { $gained } corners gained a normal and { $lost } lost one; { $turned } faces go round the other way; { $here } faces stand before only, { $there } after only.
