title = Averaged normals can depend on the triangulation
claim =
    The normal at a vertex is the mean of the normals of all incident faces. It depends on how the surface is divided
    into faces: a face with a diagonal at the vertex counts twice.
source-1 = Lectures: 1.5.2.1 (figure 33), 1.6.13, 1.6.21 b (figure 47)
source-2 =
    Weights: G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets, JGT 3(1), 1998; N. Max, Weights
    for computing vertex normals from facet normals, JGT 4(2), 1999
formula-1 = {"N = \\frac{Σ w_i N_i}{\\left|Σ w_i N_i\\right|}"}
formula-1-says =
    mean normal at a vertex: w = 1 in the lectures, the angle at the vertex by Thürmer and Wüthrich, sin(α)/(|e_1|
    |e_2|) by Max
formula-2 = {"\\cos(δ_{211}) = \\frac{4}{\\sqrt{6} \\sqrt{3}}, \\cos(δ_{221}) = \\frac{5}{3 \\sqrt{3}}"}
formula-2-says =
    corner of a cube at which one or two faces have a diagonal: with w = 1 the normal is δ = 19.4712° or 15.7932° from
    the diagonal of the cube
formula-3 = {"w = α: δ = 0"}
formula-3-says = the angles of the triangles of a flat face add up to the angle of the face, with any triangulation
shown-by = Use other weights (--weight uniform) to show it.
equal-weights = equal weights
area-weights = area weights
angle-weights = angle weights
angle-area-weights = angle × area weights
max-weights = Max's weights
edge-weights = weights by edge lengths
slivers-effect = sphere with narrow rows: error of vertex normals (rms)
cube-effect = cube: largest angle from the diagonal
box-effect = box: largest angle from the diagonal
torus-effect = irregular torus: error of vertex normals (rms)
note-1 =
    Each corner of the cube has three faces. If the diagonal of one of them ends at the corner, two triangles count for
    this face, and the mean normal tilts towards it. With angle weights, the two triangles share the angle of the face
    at the corner, so the face counts once.
note-2 =
    A mean that does not depend on the triangulation can still be wrong. On the box of 1 × 1 × 10, Max's weights give
    the same normal for all 64 triangulations, with an error of 46.7°, because they favour small faces. On a sphere
    Max's weights are exact, and angle weights are not.
fails =
    these weights give the cube the same normals with any triangulation. On curved surfaces the mean still depends on
    the triangles.
torus-rms-by = another program on the same mesh; tolerance: its printed digits
ball-by = exact if all vertices of a fan lie on a sphere (Max 1999)
error-by-slivers-title = Weights on a sphere with narrow rows
error-by-slivers-caption =
    Error of vertex normals (rms) if every other row of triangles is narrower. With most weights it grows with the ratio
    of heights; with Max's weights it stays 0.
error-by-slivers-x = height of a wide row over height of a narrow row
error-by-slivers-y = error in degrees
cube-1-caption = The smoothed cube, with one of the two diagonals in every face.
cube-1-seen = The normals at some corners lean to one side.
cube-2-caption = The same cube with the other diagonal in all faces.
cube-2-seen = The light and dark areas are elsewhere.
cube-difference-title = difference
cube-difference-caption = Difference between both pictures: violet 0, yellow { $full-light } of the full range or more.
cube-angle-caption = The cube with angle weights.
cube-angle-seen = With any triangulation, the normal at every corner is the diagonal of the cube.
box-max-caption = The box of 1 × 1 × 10 with Max's weights.
box-max-seen = The normals lean towards the small faces at the ends, and the long faces look curved.
box-angle-caption = The box with angle weights.
box-angle-seen = The three faces at a corner count equally.
slivers-caption = A sphere in which every other row of triangles is twelve times narrower.
slivers-seen = The rows are visible as bands in the light.
slivers-angle-caption = Angle weights do not help here.
slivers-angle-seen = A narrow triangle can have as large an angle at a vertex as a wide one.
slivers-max-caption = The same triangles with Max's weights.
slivers-max-seen = The normals are exact at every vertex of a sphere, and the light is smooth.
torus-caption = A torus with an irregular triangulation.
torus-seen = The light is uneven.
torus-max-caption = The same triangles with Max's weights.
torus-max-seen = The light is more even.
torus-itself-title = exact torus
torus-itself-caption = The torus with its exact normal at every pixel.
slivers-cure = { $round }
torus-cure = { $round }
cube-cure = { $flat }
box-cure = { $flat }
torus-largest-by = { torus-rms-by }
torus-rms-measure = irregular torus: rms error at vertices, { $weighting }
torus-largest-measure = irregular torus: largest error at vertices, { $weighting }
ball-measure = sphere with narrow rows: rms error at vertices, { $weighting }
cube-largest-measure = cube: largest angle over all triangulations, { $weighting }
cube-next-measure = cube: smallest angle above 0, { $weighting }
box-largest-measure = box 1 × 1 × 10: largest angle, { $weighting }
box-least-measure = box 1 × 1 × 10: smallest angle, { $weighting }
cube-largest-by =
    each face counts with the weights of its one or two triangles at the corner; tolerance: a few roundings
cube-next-by = { cube-largest-by }
box-largest-by = { cube-largest-by }
box-least-by = { cube-largest-by }
cube-1-title = cube, one diagonal, { $weight }
cube-2-title = other diagonal, { $weight }
cube-angle-title = cube, { $flat }
box-max-title = box, { $round }
box-angle-title = box, { $flat }
slivers-title = narrow rows, { $weight }
slivers-angle-title = narrow rows, { $flat }
slivers-max-title = narrow rows, { $round }
slivers-error-title = narrow rows, error, { $weight }
slivers-error-caption = Angle between interpolated and exact normals: violet 0°, yellow { $full-angle }° or more.
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
    with weights that count a face differently if its diagonal ends at the vertex, as in these pictures ({ $weight }).
    Angle weights do not depend on the triangulation of flat faces, and Max's weights are exact on spheres. No weights
    are correct everywhere.
