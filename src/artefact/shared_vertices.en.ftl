title = Unshared vertices cause edges, cracks and seams
claim = Interpolated shading is discontinuous where faces meet without shared vertices.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47
source-2 = Cure by welding: crease normals --weld
formula-1 = {"ΔI = |c − ((1 − t) a + t b)|"}
formula-1-says = jump at a vertex of colour c at the share t of an edge; the colours at the ends of the edge are a and b
formula-2 = {"ΔI = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-2-says =
    jump along an unwelded seam of a tube of N facets, Δ = 2π/N, because each side has the normal of its own facet. The
    seam is at the angle θ from the viewer (here θ = 0), the light at θ_L
formula-3 = {"A = \\frac{1}{2} L δ"}
formula-3-says = area of the crack between an edge of length L and a vertex at the distance δ from it
shown-by =
    Use light from the side of the seam (--light 50) and fewer segments to show it there. The T-junction and the crack
    are visible in any light.
t-junction-measure = T-junction: largest jump across the edge
t-junction-by = |c − ((1 − t)a + tb)|; tolerance: the vertex lies on the measured row of pixels within 1/256 pixel
t-junction-shared-measure = T-junction, vertex in both faces: largest jump across the edge
t-junction-shared-by =
    0 at the edge; at the pixel centre next to it, the colour of the large face has already changed towards its far edge
crack-measure = crack: uncovered area
crack-by = Lδ/2; tolerance: a sixteenth of a pixel for each pixel of length, and one pixel at each end
crack-closed-by = 0, because faces that share an edge cover each sample exactly once
seam-measure = seam: jump of luminance
seam-by = 2 |sin(θ − θ_L)| sin(Δ/2); measured at one and a half pixels from the seam on both sides
seam-welded-measure = welded seam: jump of luminance
seam-welded-by = 0, because each vertex has one normal; measured in the same way
seam-effect = jump of luminance across the seam
seam-cure = welded vertices
t-junction-effect = largest jump across the edge
crack-effect = uncovered area
why-half-pixel = half a pixel
holds-only-if =
    the colour or normal of a vertex on one side differs from the interpolated value on the other side. A T-junction in
    a flat, evenly lit wall is not visible. A seam with the same normals on both sides is not visible either.
note-1 =
    The vertex on the long edge belongs to the two small faces only. The large face does not have its colour and
    interpolates between the ends of the edge. The colours on both sides of the edge therefore differ.
note-2 =
    Rounding can move this vertex off the edge. Then there is a crack through which the background is visible. Adding
    the vertex to the large face cures both the jump and the crack.
note-3 =
    At a seam, two columns of vertices have the same positions. Vertex normals are averages over the incident faces, and
    each column has the faces of one side only. Welding averages over all faces at the same position.
t-junction-title = T-junction
t-junction-caption =
    Three faces whose corner colours depend only on height. The two small faces on the right are brightest at their
    common vertex; the large face does not have this vertex.
t-junction-seen = An edge is visible in the middle.
t-junction-shared-title = vertex in all faces
t-junction-shared-caption = The vertex is a corner of the large face too.
t-junction-shared-seen = There is no jump at the edge; only the slope changes.
crack-title = crack
crack-caption = The vertex is δ = { $off } px from the long edge of L = { $edge } px.
crack-seen = The background is visible through a dark crack.
crack-closed-title = crack closed
crack-closed-caption = The same vertex as a corner of all three faces.
crack-closed-seen = All samples are covered.
seam-title = seam
seam-caption =
    A tube of N = { $facets } facets with the light at θ_L = { $light }°. Its first and last columns of vertices have
    the same positions (θ = 0), but are separate vertices.
seam-seen = There is a vertical line down the middle.
seam-welded-title = welded seam
seam-welded-caption = Welded vertices: normals are averages over the faces on both sides.
seam-welded-seen = The line is not visible.
jump-title = Jump across the long edge
jump-caption =
    The jump grows from both ends of the edge to the vertex that the large face does not have. With a shared vertex
    there is no jump.
jump-x = height along the edge
jump-y = jump of luminance
t-junction-shared-curve = vertex shared
t-junction-curve = { t-junction-title }
crack-closed-measure = crack, vertex in both faces: uncovered area
t-junction-cure = vertex in all faces
crack-cure = vertex in all faces
