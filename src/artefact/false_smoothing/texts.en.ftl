title = Averaged normals smooth sharp edges
claim =
    Vertex normals are averages of face normals, so they smooth edges that should be sharp. In the worst case all
    averages are parallel, and a zig-zag looks flat. Gouraud and Phong shading both have this error.
source-1 = Lectures: 1.6.4 (figure 41), 1.6.13 (figure 44), 1.6.15, 1.6.47
source-2 = Cure in the lectures: no interpolation. Common cure since then: split vertices at sharp edges
formula-1 = {"δ_\\mathrm{cube} = \\arctan(\\sqrt{2}) = 54.7356°"}
formula-1-says = angle between a face normal of the cube and the mean normal of the three faces at its corner
formula-2 = {"δ_\\mathrm{zigzag} = s, \\quad δ_\\mathrm{roof} = s/2"}
formula-2-says = zig-zag: strips tilted by s to either side; roof: every other strip tilted by s
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{mean} = 1"}
formula-3-says = luminance of the zig-zag in frontal light, with the normals of its faces and with averaged normals
own-mesh = its normals averaged over all edges, compared with normals split at creases
shown-by = Use faces that meet at more than the crease angle, and light from the viewer's side, to show it.
shape-cube = cube
shape-zigzag = zig-zag
shape-roof = roof
front-averaged-measure = zig-zag, frontal light, averaged normals: luminance
front-faces-measure = zig-zag, frontal light, face normals: luminance
gear-share-measure = gear: share of corners whose averaged normal differs by more than { $crease }° from the face normal
gear-averaged-measure = gear, averaged: mean error of pixel normals
gear-split-measure = gear, split: mean error of pixel normals
gear-effect = gear: mean error of pixel normals
holds =
    if faces that share a vertex do not form one smooth surface. On smooth surfaces the same averages are correct, so a
    crease angle, marked edges or smoothing groups must separate the two cases. Finer faces narrow the smoothed strip
    next to a sharp edge, but do not correct the normals on the edge.
note-1 =
    On the zig-zag, every vertex has one face tilted to the left and one tilted by the same angle to the right. Every
    mean normal therefore points towards the viewer. With any light and any reflection model, the zig-zag looks like a flat
    sheet.
note-2 =
    Splitting gives each side of a sharp edge its own normal. The crease angle must be between the dihedral angles of
    sharp edges and those of curved surfaces, such as the bore of the gear. The plot shows this range as a plateau.
front-averaged-by = N·L with L = (0, 0, 1); tolerance: single precision
gear-bore-measure = gear, split: largest angle between corner and face normal
gear-bore-by = half the angle between facets of the bore, which stays smooth
error-by-crease-angle-title = The gear by crease angle
error-by-crease-angle-caption =
    Mean angle between corner and face normals. Below 7.5° nothing is smoothed; on the plateau only the bore is
    smoothed. Above the plateau the teeth, and finally the sides, are falsely smoothed.
error-by-crease-angle-x = crease angle, degrees
error-by-crease-angle-y = mean angle, degrees
gear-curve = corners of the gear
own-effect = largest angle between corner and face normal
why-crease-angle = the crease angle; smaller angles can belong to a curved surface
own-holds = this mesh has corners whose averaged normal differs from the face normal by more than the crease angle.
own-caption = Normals averaged over all edges.
own-seen = Sharp edges are smoothed too.
own-split-caption = Vertices are split where the dihedral angle exceeds the crease angle.
own-split-seen = These edges are sharp.
own-note =
    On curved surfaces, face normals differ from averaged normals too: by half the angle between neighbouring faces.
    Only larger differences are errors.
pixels-effect = mean error of pixel normals
gear-caption = A gear with one normal per vertex.
gear-seen = The teeth look inflated, and the shading continues across every edge.
gear-split-caption = The gear, split at the crease angle.
cube-caption = A cube with eight vertices and eight normals.
cube-seen = It looks like a pillow.
cube-split-caption = The cube, split at the crease angle.
cube-split-seen = Every face has one luminance.
zigzag-caption = Strips tilted by 45° to the left and to the right.
zigzag-seen = All averaged normals are parallel: only the silhouette shows the shape.
zigzag-split-caption = The same sheet in the same light, split at the crease angle.
zigzag-split-seen = Each strip has its own normal.
roof-caption = A corrugated roof of flat strips.
roof-seen = Averaged normals make it look wavy.
roof-split-caption = The roof, split at the crease angle.
roof-split-seen = The strips are uniform, with sharp edges.
gear-light-caption = Error of the diffuse light (Lambert): violet 0, yellow half of the full range or more.
front-faces-by = { front-averaged-by }
averaged-measure = { $shape }, averaged: largest angle between corner and face normal
averaged-by = angle between the mean normal and a face normal; tolerance: a few roundings
split-measure = { $shape }, split: largest angle between corner and face normal
split-by = 0 if the crease angle is less than the dihedral angle
pixels-cure = vertices split at edges above { $crease }°
own-cure = { pixels-cure }
gear-split-seen = Teeth and sides are flat.
gear-title = gear, averaged
gear-split-title = gear, split
gear-angles-title = gear, angle
gear-angles-caption = Angle between averaged normal and face normal: violet 0°, yellow { $full-angle }° or more.
gear-light-title = gear, light
cube-title = cube, averaged
cube-split-title = cube, split
cube-angles-title = cube, angle
cube-angles-caption = { gear-angles-caption }
zigzag-title = zig-zag, averaged
zigzag-split-title = zig-zag, split
roof-title = roof, averaged
roof-split-title = roof, split
own-share-averaged-measure = averaged: share of corners above the crease angle
own-share-split-measure = split: share of corners above the crease angle
own-largest-averaged-measure = averaged: largest angle between corner and face normal
own-largest-split-measure = split: largest angle between corner and face normal
own-mean-averaged-measure = averaged: mean error of pixel normals
own-mean-split-measure = split: mean error of pixel normals
own-title = mesh, averaged
own-split-title = mesh, split
own-angles-title = mesh, angle
own-angles-caption = { gear-angles-caption }
own-light-title = mesh, light
own-light-caption = { gear-light-caption }
