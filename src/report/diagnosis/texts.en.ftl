# The page and the pictures of a diagnosis.

contents = Contents
heat-alternative = the mesh coloured by the deviation of its stored normals, { $scale }
facing-alternative = the mesh with front faces light blue and back faces dark red
creases-alternative = the shaded mesh, with lines along creases and seams
overview-caption =
    First: angle between stored normals and normals computed with the estimated recipe{ $marks }. Second: front faces
    light blue, back faces dark red. Third: the shaded mesh, with orange lines at edges whose two sides have different
    normals.
overview-caption-findings =
    First: errors and warnings, each in a colour of its own{ $marks }. Second: front faces light blue, back faces dark red.
    Third: the shaded mesh, with orange lines at edges whose two sides have different normals.
caption-of-deviations = The angle between stored normals and normals computed with the estimated recipe{ $marks }.
findings-alternative = the shaded mesh with each error and warning in a colour of its own
marks-dots = ; dots mark large deviations on faces too small to be visible
marks-edges =
    ; all corners deviate at edges whose smoothing does not match the estimated crease angle (see the findings)
marks-lines = ; grey lines mark edges with two computed normals
marks-rings = ; red rings mark the worst position of each error and warning
marks-hidden = ; worst positions behind other faces have no ring

close-up-alternative = close view of the worst position of { $finding }, from in front of its face
close-up-seen = First: { -close-up } Second: a ring marks it in the whole mesh.
close-up-hidden = First: { -close-up } Second: a ring marks it in the whole mesh, where it is behind other faces.
close-up-alone = This is { -close-up }
-close-up =
    the worst position, viewed from in front of its face, with the edges of faces. Faces that cover it are cut away.
whole-alternative = the whole mesh, with a ring around that position
node-caption = The whole mesh, with a ring around the centre of the geometry of the first of these nodes.
node-alternative = the whole mesh, with a ring around a node
fix = The command below fixes { $fixed }.
not-fixed = It does not fix { $others }.

there-is-nothing = There are no faces to show.
overview = Overview
to-overview = To the overview
severity-error = error
severity-warning = warning
severity-note = note
errors = { $count } { $count ->
    [one] error
   *[other] errors
 }
warnings = { $count } { $count ->
    [one] warning
   *[other] warnings
 }
notes = { $count } { $count ->
    [one] note
   *[other] notes
 }
title-found = { $name }: { $counts }
title-none = No problems found in { $name }
title-omitted = No selected findings in { $name }
checked = Faces checked: { $faces }.
omitted = Findings omitted by options: { $count }.

recipes = Recipes that reproduce the stored normals best
column-submesh = submesh
column-faces = faces
column-recipe = recipe
column-median = median
unnamed-submesh = submesh { $number }

finding = { $severity }: { $cause }. { $count } of { $of } ({ $share } %){ $details }.
finding-steps = ; up to { $angle }{ $steps } of 255 grey steps under a key light
finding-worst = ; at worst { $amount } { $unit }
finding-confidence = ; confidence { $confidence }
worst-locations = Worst positions
column-location = location
column-face = face
column-corner = corner
column-vertex = vertex
column-position = position
column-degrees = degrees
line = line { $line }
primitive = primitive { $number }

legend-absent = no valid normal
legend-line = edge with two normals
legend-dot = large deviation on a small face
worst-seen = worst position
worst-partly-hidden = worst position (others are hidden)
worst-hidden = worst position: hidden by other faces
scale-end = { $full }°
scale-end-beyond = { $full }° and more, up to { $largest }°
scale = from violet, 0°, to yellow, { $end }
scale-and-absent = { $scale }; pink where no valid normal is stored
scale-absent = pink everywhere: no valid normal is stored
angle-of-recipe = Angle between the stored normals and those of the estimated recipe, in degrees
angle-of-weight = Angle between the stored normals and those of the weight { $weight }, in degrees
elements-corner = { $count } { $count ->
    [one] corner
   *[other] corners
 }
elements-face = { $count } { $count ->
    [one] face
   *[other] faces
 }
elements-edge = { $count } { $count ->
    [one] edge
   *[other] edges
 }
elements-vertex = { $count } { $count ->
    [one] vertex
   *[other] vertices
 }
elements-node = { $count } { $count ->
    [one] node
   *[other] nodes
 }
elements-mesh = { $count } { $count ->
    [one] mesh
   *[other] meshes
 }
up-to = { $elements }, up to { $degrees }°
legend-plain = no finding
legend-clean = no errors or warnings
not-shown = findings not shown: { $count } (--heatmap-of shows one of them)

before-and-after = Before and after
lit-before = the mesh lit with the normals that it had before
lit-after = the mesh lit with the normals that it has after
changed = the mesh coloured by how far its normals changed, { $scale }
lit-caption =
    First: before. Second: after. Third: the angle by which the normal of each corner changed; a ring marks the largest
    visible change.
off-before = before: the mesh coloured by the deviation of its normals from its own recipe, { $scale }
off-after = after: the mesh coloured by the deviation of its normals from its own recipe, { $scale }
off-caption = Angle between the stored normals and those computed with the estimated recipe. First: before. Second: after.
numbers =
    In { $name }, { $changed } of { $corners } normals changed direction, { $visible } of them visibly. The largest change is { $largest }°
    ({ $largest-steps } of 255 grey steps under a key light), the mean { $mean }° ({ $mean-steps } steps), the
    rms { $rms }°. Half of the changes are at most { $median }°, 95 % at most { $p95 }°, 99 % at most { $p99 }°. Corners that
    gained a normal: { $gained }; that lost one: { $lost }. Faces with reversed winding: { $turned }; { $faces }.
same-faces = no faces were added or removed
other-faces = faces removed: { $here }, added: { $there }
findings-before-and-after = Findings, before and after
column-finding = finding
column-before = before
column-after = after

distributions = Distributions
deviation-title = Deviation of stored normals
deviation-unit = degrees
deviation-caption = Correct normals are at the left end, faults at the right. The vertical axis is logarithmic, so that a single corner is visible. Normals without a direction are omitted.
dihedral-angle-title = Dihedral angles
dihedral-angle-unit = degrees
dihedral-angle-caption = An angle in a gap between small and large angles is a good crease angle.
corner-angle-title = Angles of faces at their corners
corner-angle-unit = degrees
corner-angle-caption = Many angles near 0° or 180° mean thin faces, whose normals are inaccurate.
valence-title = Faces around a vertex
valence-unit = faces
valence-caption = The number of faces at a vertex. Vertices with many faces (poles) are at the right.
edge-length-title = Lengths of edges
edge-length-unit = median lengths
edge-length-caption = Divided by the median. The last bin has all lengths above ten medians.
histogram = histogram of { $name }
histogram-words =
    A histogram of { $count } values. The fullest bin has { $share } %, from { $from } to { $to } { $unit }.
histogram-corners = corners
histogram-share = per cent
