title = Vertices that are not shared
claim = Where faces meet without sharing their vertices, interpolated shading has discontinuities.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47
source-2 = Welding as the cure: crease normals --weld
formula-1 = {"ΔI = |c − ((1 − t) a + t b)|"}
formula-1-says =
    the jump at a vertex of colour c that lies at the share t of an edge with the colours a and b at its ends
formula-2 = {"ΔI = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-2-says =
    the jump along an unwelded seam, at the angle θ from the viewer, of a tube of N facets, Δ = 2π/N, with the light at
    θ_L: each side has the normal of its own facet; here θ = 0
formula-3 = {"A = \\frac{1}{2} L δ"}
formula-3-says = the area of the crack along an edge of length L that a vertex is off by δ
shown-by =
    light that comes from the side of the seam (--light 50), and fewer segments, would show it there; the T-junction and
    the crack are seen in any light.
t-junction-measure = T-junction: largest jump across the edge
t-junction-by = |c − ((1 − t)a + tb)|; the vertex lies on the row of pixels that is measured, within 1/256 of a pixel
t-junction-shared-measure = the same with the vertex in both faces
t-junction-shared-by =
    on the edge none; a pixel's centre next to it, the large face is on its way to the colour of its far edge
crack-measure = crack: area not covered
crack-by = Lδ/2; a sixteenth of a pixel for every pixel of its length, and one at either end
crack-closed-by = faces that share an edge cover each sample once
seam-measure = seam: jump of luminance
seam-by = 2 |sin(θ − θ_L)| sin(Δ/2); measured a pixel and a half off the seam on both sides
seam-welded-measure = seam, welded
seam-welded-by = one normal a vertex; as above
seam-effect = jump of luminance across the seam
seam-cure = welded
t-junction-effect = largest jump across the edge
crack-effect = area that is not covered
why-half-pixel = half of one pixel
holds-only-if =
    the colour or normal that one side has at a vertex is not what the other side interpolates there. A T-junction in a
    flat, evenly lit wall is not seen, and neither is a seam whose sides have the same normals.
note-1 =
    The vertex on the long edge belongs to the two small faces only. The large face knows nothing of its colour and
    interpolates straight past it: next to it the two sides differ.
note-2 =
    Moved off the edge, as rounding does, it leaves a crack, through which the background shows. Put into the large face
    as a corner of its own, it cures both.
note-3 =
    Along a seam two rows of vertices lie at the same places. Normals are means over the faces at a vertex, and each row
    has the faces of one side only. Welding takes vertices at one place as one.
t-junction-title = T-junction
t-junction-caption =
    Three faces whose corners' colours depend on their height alone. The small ones at the right are brightest at their
    common vertex, which the large one lacks.
t-junction-seen = An edge is seen in the middle.
t-junction-shared-title = vertex in all faces
t-junction-shared-caption = The vertex is a corner of the large face too.
t-junction-shared-seen = There is no jump at the edge any more, only a bend of the slope.
crack-title = crack
crack-caption = The vertex δ = { $off } px off the long edge of L = { $edge } px.
crack-seen = The background shows through a dark crack.
crack-closed-title = crack closed
crack-closed-caption = The same vertex as a corner of all three faces.
crack-closed-seen = No sample is left open.
seam-title = seam
seam-caption =
    A tube of N = { $facets } facets, the light at θ_L = { $light }°. Its first and last column of vertices are at the
    same places (θ = 0) but not the same.
seam-seen = There is a line down its middle.
seam-welded-title = seam welded
seam-welded-caption = Welded, so that normals are means over the faces of both sides.
seam-welded-seen = The line is gone.
jump-title = Jump across the long edge
jump-caption = The jump grows from both ends of the edge to the vertex that the large face lacks; shared, there is none.
jump-x = height along the edge
jump-y = jump of luminance
t-junction-shared-curve = vertex shared
t-junction-curve = { t-junction-title }
crack-closed-measure = the same with the vertex in both faces
t-junction-cure = vertex in all faces
crack-cure = vertex in all faces
