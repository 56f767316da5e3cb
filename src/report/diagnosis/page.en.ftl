heat-alternative = the mesh coloured by the deviation of its stored normals, { $scale }
facing-alternative = the mesh with front faces light blue and back faces dark red
creases-alternative = the mesh lit, with lines along creases and seams
overview-caption =
    Left: how far stored normals are from those that the rule of their mesh gives{ $marks }. Middle: front faces light blue,
    back faces dark red. Right: lit, with orange lines where the normals of two sides differ.
marks-dots = ; dots are on what is far off and too small to be seen
marks-edges =
    ; all corners at edges that are smooth or split against it deviate, and the findings name these edges
marks-lines = ; grey lines are where that rule has two normals at an edge
marks-rings = ; red rings mark the worst place of each error and warning
marks-hidden = ; worst places that lie behind have no ring

close-up-alternative = the worst place of { $finding }, close up, seen from in front of its face
close-up-seen = Left: { -close-up } Right: the ring is round it in the whole.
close-up-hidden = Left: { -close-up } Right: the ring is round it in the whole, where it lies behind what is seen.
close-up-alone = This is { -close-up }
-close-up =
    the worst place, seen from in front of its face, with the edges of faces; what covers it is cut away.
whole-alternative = the whole mesh, with a ring round that place
node-caption = The whole mesh, with a ring round the middle of what the first of these nodes shows.
node-alternative = the whole mesh, with a ring round a node
