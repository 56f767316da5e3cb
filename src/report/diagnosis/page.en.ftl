heat-alternative = the mesh coloured by the deviation of its stored normals, { $scale }
facing-alternative = the mesh with front faces light blue and back faces dark red
creases-alternative = the shaded mesh, with lines along creases and seams
overview-caption =
    First: angle between stored normals and normals computed with the estimated weighting{ $marks }. Second: front faces
    light blue, back faces dark red. Third: the shaded mesh, with orange lines at edges whose two sides have different
    normals.
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
whole-alternative = the whole mesh, with a ring around that location
node-caption = The whole mesh, with a ring around the centre of the geometry of the first of these nodes.
node-alternative = the whole mesh, with a ring around a node
fix = The command below fixes { $fixed }.
not-fixed = It does not fix { $others }.

title-found = { $name }: { $counts }
title-none = No problems found in { $name }
title-omitted = No selected findings in { $name }
checked = Faces checked: { $faces }.
omitted = Findings omitted by options: { $count }.
