lit-before = the mesh lit with the normals that it had before
lit-after = the mesh lit with the normals that it has after
changed = the mesh coloured by how far its normals changed, { $scale }
lit-caption =
    First: before. Second: after. Third: the angle by which the normal of each corner changed; a ring marks the largest
    visible change.
off-before = before: the mesh coloured by the deviation of its normals from its own weighting, { $scale }
off-after = after: the mesh coloured by the deviation of its normals from its own weighting, { $scale }
off-caption = Angle between the stored normals and those computed with the estimated weighting. First: before. Second: after.
numbers =
    In { $name }, { $changed } of { $corners } normals changed direction, { $visible } of them visibly. The largest change is { $largest }°
    ({ $largest-steps } of 255 grey steps under a key light), the mean { $mean }° ({ $mean-steps } steps), the
    rms { $rms }°. Half of the changes are at most { $median }°, 95 % at most { $p95 }°, 99 % at most { $p99 }°. Corners that
    gained a normal: { $gained }; that lost one: { $lost }. Faces with reversed winding: { $turned }; { $faces }.
same-faces = no faces were added or removed
other-faces = { $here } faces were removed, { $there } added
