title = The mean at a vertex
claim =
    The normal at a vertex is the mean of the normals of all faces at it. So it depends on how the surface happens to be
    cut into faces: a face that is cut through the vertex counts twice.
source-1 = Lectures: 1.5.2.1 (figure 33), 1.6.13, 1.6.21 b (figure 47)
source-2 =
    Weights: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights
    for computing vertex normals from facet normals, JGT 4(2), 1999
formula-1 = {"N = \\frac{Σ w_i N_i}{\\left|Σ w_i N_i\\right|}"}
formula-1-says =
    the mean at a vertex: w = 1 in the lectures, the angle at the vertex by Thürmer and Wüthrich, sin(α)/(|e_1| |e_2|)
    by Max
formula-2 = {"\\cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, \\cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}"}
formula-2-says =
    the corner of a cube of which one face or two are cut: δ = 19.4712° and 15.7932° off the diagonal with w = 1
formula-3 = {"w = α: δ = 0"}
formula-3-says = angles of the parts of a flat face add up to that of the face, however it is cut
shown-by = other weights (--weight uniform) would show it.
equal-weights = equal weights
area-weights = area weights
angle-weights = angle weights
angle-area-weights = weights angle × area
max-weights = Max's weights
edge-weights = weights 1/(|e₁| |e₂|) of edges
slivers-effect = ball of slivers: error of the normals at vertices (rms)
cube-effect = cube: largest angle to the diagonal
box-effect = box: largest angle to the diagonal
torus-effect = irregular torus: error of the normals at vertices (rms)
note-1 =
    On the cube each corner has three faces. Where one of them is cut through the corner, two triangles vote for it and
    the mean leans over. The angle at the corner is shared out between the two, so that their votes add up to one again.
note-2 =
    Not to depend on the cut is not yet to be right: on the box of 1 × 1 × 10 Max's weights give the same normal for all
    64 cuts, 46.7° off, for they favour small faces. On a ball, where the mean is meant to stand for something round,
    they are exact, and angles are not.
fails =
    these weights give the cube the same normals however its faces are cut. On round surfaces the mean depends on the
    triangles still.
torus-rms-by = another program on the same mesh, to the digits that it printed
ball-by = exact where all vertices of a fan lie on a sphere (Max 1999)
error-by-slivers-title = Weights on a ball of slivers
error-by-slivers-caption =
    The error of normals at vertices (rms) when every other row of triangles is so many times narrower: it grows with
    most weights, and stays 0 with Max's.
error-by-slivers-x = height of a wide row over that of a narrow one
error-by-slivers-y = error in degrees
cube-1-caption = The cube smoothed, its faces cut along one diagonal.
cube-1-seen = Some corners lean to one side.
cube-2-caption = The same cube with all faces cut along the other diagonal.
cube-2-seen = Light and shadow are elsewhere.
cube-difference-title = between both
cube-difference-caption = How far both pictures differ: violet 0, yellow { $full-light } of the full range and more.
cube-angle-caption = Weights by the angle.
cube-angle-seen = Every corner has the diagonal for its normal, however the faces are cut.
box-max-caption = The box of 1 × 1 × 10 with Max's weights.
box-max-seen = Normals lean towards the small faces at the ends, and the long faces look bent.
box-angle-caption = The box with weights by the angle.
box-angle-seen = Each of the three faces at a corner counts alike.
slivers-caption = A ball of which every other row of triangles is twelve times narrower.
slivers-seen = The rows show as bands in the light.
slivers-angle-caption = Weights by the angle do not help here.
slivers-angle-seen = A sliver between two vertices has as large an angle as a wide triangle.
slivers-max-caption = Max's weights on the same triangles.
slivers-max-seen = They are exact at every vertex of a sphere, and round between them.
torus-caption = A torus of triangles cut at random.
torus-seen = The light is uneven.
torus-max-caption = The same triangles with Max's weights.
torus-max-seen = The light is more even.
torus-itself-title = the torus itself
torus-itself-caption = The torus with its own normal at every pixel.
slivers-cure = { $round }
torus-cure = { $round }
cube-cure = { $flat }
box-cure = { $flat }
torus-largest-by = { torus-rms-by }
torus-rms-measure = irregular torus: rms error at vertices, { $weighting }
torus-largest-measure = irregular torus: largest error at vertices, { $weighting }
ball-measure = ball of slivers: rms error at vertices, { $weighting }
cube-largest-measure = cube: largest angle over all cuts, { $weighting }
cube-next-measure = cube: smallest that is not 0, { $weighting }
box-largest-measure = box 1 × 1 × 10: largest, { $weighting }
box-least-measure = box 1 × 1 × 10: least, { $weighting }
cube-largest-by = each face counts with the weights of its triangles at the corner, one or two; a few roundings
cube-next-by = { cube-largest-by }
box-largest-by = { cube-largest-by }
box-least-by = { cube-largest-by }
cube-1-title = cube cut one way, { $weight }
cube-2-title = cut the other way, { $weight }
cube-angle-title = cube, { $flat }
box-max-title = box, { $round }
box-angle-title = box, { $flat }
slivers-title = slivers, { $weight }
slivers-angle-title = slivers, { $flat }
slivers-max-title = slivers, { $round }
slivers-error-title = slivers, error, { $weight }
slivers-error-caption = The angle between interpolated and true normals: violet 0°, yellow { $full-angle }° and more.
torus-title = irregular torus, { $weight }
torus-max-title = irregular torus, { $round }
torus-error-title = irregular torus, error, { $weight }
torus-error-caption = { slivers-error-caption }
equal-weights-curve = { equal-weights }
area-weights-curve = { area-weights }
angle-weights-curve = { angle-weights }
angle-area-weights-curve = { angle-area-weights }
max-weights-curve = { max-weights }
edge-weights-curve = { edge-weights }
holds =
    with weights that change where a face is cut through the vertex, as those of these pictures do ({ $weight }). Angle
    weights do not depend on how flat faces are cut, and Max's are exact on spheres; none is right everywhere.
