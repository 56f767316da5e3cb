title = False smoothing
claim =
    Normals at vertices are means of those of the faces, so edges that are meant to be sharp are smoothed as well: in
    the worst case all means are parallel, and a zig-zag looks flat. Gouraud's and Phong's shading share the fault.
source-1 = Lectures: 1.6.4 (figure 41), 1.6.13 (figure 44), 1.6.15, 1.6.47
source-2 =
    The lectures' cure is not to interpolate at all; splitting vertices where edges are sharp is the one used since
formula-1 = {"δ_\\mathrm{cube} = \\arctan(\\sqrt{2}) = 54.7356°"}
formula-1-says = the angle between a face of the cube and the mean of the three faces at its corner
formula-2 = {"δ_\\mathrm{zigzag} = s, \\quad δ_\\mathrm{roof} = s/2"}
formula-2-says = for strips that lean by s to either side, and for strips of which every other leans by s
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{mean} = 1"}
formula-3-says =
    the zig-zag in light from the front, lit by its faces' normals as it is, and by their means as it is shown
own-mesh = its normals averaged over every edge, and not over creases
shown-by = faces that meet at more than the crease angle, in light from the viewer's side, would show it.
shape-cube = cube
shape-zigzag = zig-zag
shape-roof = roof
front-averaged-measure = zig-zag, light from the front, averaged: luminance
front-faces-measure = zig-zag, light from the front, as it is: luminance
gear-share-measure = gear: share of corners whose averaged normal is more than { $crease }° off its face
gear-averaged-measure = gear, averaged: mean error of the pixels' normals
gear-split-measure = gear, split: mean error of the pixels' normals
gear-effect = gear: mean error of the pixels' normals
holds =
    wherever faces that share a vertex are not meant as one smooth surface. Where they are, the same means are right, so
    no rule without a crease angle, marks or groups can serve both. Finer faces make the smeared strip along a sharp
    edge narrower, and leave the normals on the edge as wrong as they were.
note-1 =
    On the zig-zag every vertex has one face that leans to the left and one that leans as much to the right, so that
    every mean is straight up. Whatever the light, whatever the model of reflection, it looks like a flat sheet.
note-2 =
    Splitting gives each side of a sharp edge a normal of its own. The crease angle has to lie between the bends that
    are meant and those that only stand for something round, as along the gear's bore: the plot shows that plateau.
front-averaged-by = N·L with L = (0, 0, 1); single precision
gear-bore-measure = gear, split: largest angle of a corner's normal to its face
gear-bore-by = half the angle between the facets of the bore, which stay smooth
error-by-crease-angle-title = The gear by crease angle
error-by-crease-angle-caption =
    The mean angle of the corners' normals to their faces: nothing is smooth below 7.5°, the bore alone on the plateau,
    and beyond it the teeth and at last the sides are smoothed falsely.
error-by-crease-angle-x = crease angle, degrees
error-by-crease-angle-y = mean angle, degrees
gear-curve = corners of the gear
own-effect = largest angle of a corner's normal to its face
why-crease-angle = the crease angle; less may stand for something round
own-holds = this mesh has corners whose mean is farther from their face than the crease angle.
own-caption = Normals averaged over every edge.
own-seen = Sharp edges are smoothed as well.
own-split-caption = Vertices split where edges are sharper than the crease angle.
own-split-seen = They are sharp again.
own-note =
    Faces that stand for something round are off their means as well, by half the angle between them; only more than
    that is false.
pixels-effect = mean error of the pixels' normals
gear-caption = A gear with one normal a vertex.
gear-seen = The teeth look inflated, light runs round every edge.
gear-split-caption = Split at the crease angle.
cube-caption = A cube of eight vertices with eight normals.
cube-seen = It looks like a pillow.
cube-split-caption = Split at the crease angle.
cube-split-seen = Every face has one luminance.
zigzag-caption = Strips that lean to the left and to the right by 45°.
zigzag-seen = All averaged normals are parallel: only the silhouette shows the shape.
zigzag-split-caption = The same sheet in the same light, split at the crease angle.
zigzag-split-seen = The strips have their own normals.
roof-caption = A corrugated roof of flat strips.
roof-seen = Averaged it looks like waves.
roof-split-caption = The roof, split at the crease angle.
roof-split-seen = Even strips with sharp bends.
gear-light-caption = How far the light by Lambert's law is off: violet 0, yellow half of the full range and more.
front-faces-by = { front-averaged-by }
averaged-measure = { $shape }, averaged: largest angle of a corner's normal to its face
averaged-by = the angle between the mean and a face; a few roundings
split-measure = { $shape }, split: largest angle of a corner's normal to its face
split-by = 0 where the crease angle is less than that of the edge
pixels-cure = vertices split at edges over { $crease }°
own-cure = { pixels-cure }
gear-split-seen = Teeth and sides are flat.
gear-title = gear, averaged
gear-split-title = gear, split
gear-angles-title = gear, angle
gear-angles-caption =
    The angle between the averaged normal and that of the face: violet 0°, yellow { $full-angle }° and more.
gear-light-title = gear, light
cube-title = cube, averaged
cube-split-title = cube, split
cube-angles-title = cube, angle
cube-angles-caption = { gear-angles-caption }
zigzag-title = zig-zag, averaged
zigzag-split-title = zig-zag, split
roof-title = roof, averaged
roof-split-title = roof, split
own-share-averaged-measure = averaged: share of corners over the crease angle
own-share-split-measure = split: share of corners over the crease angle
own-largest-averaged-measure = averaged: largest angle of a corner's normal to its face
own-largest-split-measure = split: largest angle of a corner's normal to its face
own-mean-averaged-measure = averaged: mean angle of the pixels
own-mean-split-measure = split: mean angle of the pixels
own-title = mesh, averaged
own-split-title = mesh, split
own-angles-title = mesh, angle
own-angles-caption = { gear-angles-caption }
own-light-title = mesh, light
own-light-caption = { gear-light-caption }
