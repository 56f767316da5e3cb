title = False smoothing
claim =
    Normals at vertices are means of those of the faces, so edges that are meant to be sharp are smoothed as well: in
    the worst case all means are parallel, and a zig-zag looks flat. Gouraud's and Phong's shading share the fault.
source-1 = Lectures: 1.6.4 (figure 41), 1.6.13 (figure 44), 1.6.15, 1.6.47
source-2 = The lectures' cure is not to interpolate at all; splitting vertices where edges are sharp is the one used since
formula-1 = {"δ_\\mathrm{cube} = \\arctan(\\sqrt{2}) = 54.7356°"}
formula-1-says = the angle between a face of the cube and the mean of the three faces at its corner
formula-2 = {"δ_\\mathrm{zigzag} = s, \\quad δ_\\mathrm{roof} = s/2"}
formula-2-says = for strips that lean by s to either side, and for strips of which every other leans by s
formula-3 = {"I_\\mathrm{faces} = \\cos(s), \\quad I_\\mathrm{mean} = 1"}
formula-3-says = the zig-zag in light from the front, lit by its faces' normals as it is, and by their means as it is shown
own-mesh = its normals averaged over every edge, and not over creases
shown-by = faces that meet at more than the crease angle, in light from the viewer's side, would show it.
cube = cube
zig-zag = zig-zag
roof = roof
zig-zag-light = zig-zag, light from the front, averaged: luminance
zig-zag-light-front = zig-zag, light from the front, as it is: luminance
gear-share-corners = gear: share of corners whose averaged normal is more than { $value }° off its face
measure-gear-averaged-mean = gear, averaged: mean error of the pixels' normals
measure-gear-split-mean = gear, split: mean error of the pixels' normals
moved = gear: mean error of the pixels' normals
cure = what is left is the bore, smoothed on purpose
holds-wherever-faces-share =
    wherever faces that share a vertex are not meant as one smooth surface. Where they are, the same means are right, so
    no rule without a crease angle, marks or groups can serve both. Finer faces make the smeared strip beside a sharp
    edge narrower, and leave the normals on the edge as wrong as they were.
zig-zag-every =
    On the zig-zag every vertex has one face that leans to the left and one that leans as much to the right, so that
    every mean is straight up. Whatever the light, whatever the model of reflection, it looks like a flat sheet.
splitting-gives-each =
    Splitting gives each side of a sharp edge a normal of its own. The crease angle has to lie between the bends that
    are meant and those that only stand for something round, as along the gear's bore: the plot shows that plateau.
by-n-l-l = N·L with L = (0, 0, 1); single precision
measure-gear-split-largest = gear, split: largest angle of a corner's normal to its face
by-half-angle-between = half the angle between the facets of the bore, which stay smooth
chart-title = The gear by crease angle
chart-caption =
    The mean angle of the corners' normals to their faces: nothing is smooth below 7.5°, the bore alone on the plateau,
    and beyond it the teeth and at last the sides are smoothed falsely.
axis-crease-angle-degrees = crease angle, degrees
axis-mean-angle-degrees = mean angle, degrees
curve-corners-gear = corners of the gear
moved-largest-angle-corner = largest angle of a corner's normal to its face
why-crease-angle-less = the crease angle; less may stand for something round
holds-mesh-corners-mean = this mesh has corners whose mean is farther from their face than the crease angle.
own-title = Normals averaged over every edge.
own-caption-sharp-edges-smoothed = Sharp edges are smoothed as well.
own-split-title = Vertices split where edges are sharper than the crease angle.
own-split-caption-they-sharp-again = They are sharp again.
note-faces-stand-something =
    Faces that stand for something round are off their means as well, by half the angle between them; only more than
    that is false.
mean-error-pixels = mean error of the pixels' normals
gear-normal-vertex = A gear with one normal a vertex.
teeth-look-inflated = The teeth look inflated, light runs round every edge.
split-crease-angle = Split at the crease angle.
teeth-sides-flat = Teeth and sides are flat; the bore stays round on purpose, with normals up to { $of-bore }° off its facets.
teeth-sides-flat-bore = Teeth and sides are flat, the bore stays round.
teeth-sides-flat-but = Teeth and sides are flat, but so are the facets of the bore, which is meant to be round.
cube-eight-vertices = A cube of eight vertices with eight normals.
looks-like-pillow = It looks like a pillow.
split-crease-angle-v2 = Split at the crease angle.
every-face-luminance = Every face has one luminance.
strips-lean-left = Strips that lean to the left and to the right by 45°.
all-means-parallel = All means are parallel, and only the outline tells of them.
same-sheet-same = The same sheet in the same light, split at the crease angle.
strips-their-own = The strips have their own normals.
corrugated-roof-flat = A corrugated roof of flat strips.
averaged-looks-like = Averaged it looks like waves.
roof-split-crease = The roof, split at the crease angle.
even-strips-sharp = Even strips with sharp bends.
how-far-light = How far the light by Lambert's law is off: violet 0, yellow half of the full range and more.
