title = Vertices that are not shared
claim = Where faces meet without sharing their vertices, interpolated shading has discontinuities.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47
source-2 = Welding as the cure: crease normals --weld
formula-1 = {"ΔI = |c − ((1 − t) a + t b)|"}
formula-1-says = the jump at a vertex of colour c that lies at the share t of an edge with the colours a and b at its ends
formula-2 = {"ΔI = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-2-says =
    the jump along an unwelded seam, at the angle θ from the viewer, of a tube of N facets, Δ = 2π/N, with the light at
    θ_L: each side has the normal of its own facet; here θ = 0
formula-3 = {"A = \\frac{1}{2} L δ"}
formula-3-says = the area of the crack beside an edge of length L that a vertex is off by δ
shown-by =
    light that comes from the side of the seam (--light 50), and fewer segments, would show it there; the T-junction and
    the crack are seen in any light.
measure-t-junction-largest = T-junction: largest jump across the edge
by-c-t-tb = |c − ((1 − t)a + tb)|; the vertex lies on the row of pixels that is measured, within 1/256 of a pixel
measure-same-vertex-both = the same with the vertex in both faces
by-edge-none-pixel = on the edge none; a pixel's centre beside it, the large face is on its way to the colour of its far edge
measure-crack-area-not = crack: area not covered
by-l-sixteenth-pixel = Lδ/2; a sixteenth of a pixel for every pixel of its length, and one at either end
by-faces-share-edge = faces that share an edge cover each sample once
measure-seam-jump-luminance = seam: jump of luminance
by-sin-l-sin = 2 |sin(θ − θ_L)| sin(Δ/2); measured a pixel and a half off the seam on both sides
measure-seam-welded = seam, welded
by-normal-vertex-above = one normal a vertex; as above
moved = jump of luminance across the seam
cure = welded
moved-largest-jump-across = largest jump across the edge
moved-area-not-covered = area that is not covered
why-half-pixel = half of one pixel
holds-only-if-colour-or-normal =
    the colour or normal that one side has at a vertex is not what the other side interpolates there. A T-junction in a
    flat, evenly lit wall is not seen, and neither is a seam whose sides have the same normals.
note-vertex-long-edge =
    The vertex on the long edge belongs to the two small faces only. The large face knows nothing of its colour and
    interpolates straight past it: beside it the two sides differ.
note-moved-off-edge =
    Moved off the edge, as rounding does, it leaves a crack, through which the background shows. Put into the large face
    as a corner of its own, it cures both.
note-along-seam-rows =
    Along a seam two rows of vertices lie at the same places. Normals are means over the faces at a vertex, and each row
    has the faces of one side only. Welding takes vertices at one place as one.
t-junction-title = T-junction
t-junction-caption-three-faces-corners =
    Three faces whose corners' colours depend on their height alone. The small ones at the right are brightest at their
    common vertex, which the large one lacks.
t-junction-caption-edge-seen-middle = An edge is seen in the middle.
t-junction-shared-title = vertex in all faces
t-junction-shared-caption-vertex-corner-large = The vertex is a corner of the large face too.
t-junction-shared-caption-no-jump-edge = There is no jump at the edge any more, only a bend of the slope.
crack-title = crack
crack-caption-vertex-off-px = The vertex δ = { $off } px off the long edge of L = { $edge } px.
crack-caption-background-shows-through = The background shows through a dark crack.
crack-closed-title = crack closed
crack-closed-caption-same-vertex-corner = The same vertex as a corner of all three faces.
crack-closed-caption-no-sample-left = No sample is left open.
seam-title = seam
seam-caption-tube-n-facets =
    A tube of N = { $facets } facets, the light at θ_L = { $light }°. Its first and last column of vertices are at the
    same places (θ = 0) but not the same.
seam-caption-line-down-middle = There is a line down its middle.
seam-welded-title = seam welded
seam-welded-caption-welded-normals-means = Welded, so that normals are means over the faces of both sides.
seam-welded-caption-line-gone = The line is gone.
chart-title = Jump across the long edge
chart-caption = The jump grows from both ends of the edge to the vertex that the large face lacks; shared, there is none.
axis-height-along-edge = height along the edge
axis-jump-luminance = jump of luminance
vertex-shared = vertex shared
