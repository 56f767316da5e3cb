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
formula-2-says = the corner of a cube of which one face or two are cut: δ = 19.4712° and 15.7932° off the diagonal with w = 1
formula-3 = {"w = α: δ = 0"}
formula-3-says = angles of the parts of a flat face add up to that of the face, however it is cut
shown-by = other weights (--weight uniform) would show it.
equal-weights = equal weights
area-weights = area weights
angle-weights = angle weights
weights-angle-area = weights angle × area
max-weights = Max's weights
weights-e-e = weights 1/(|e₁| |e₂|) of edges
moved = ball of slivers: error of the normals at vertices (rms)
cube-largest-angle = cube: largest angle to the diagonal
box-largest-angle = box: largest angle to the diagonal
moved-irregular-torus-error = irregular torus: error of the normals at vertices (rms)
note-cube-each-corner =
    On the cube each corner has three faces. Where one of them is cut through the corner, two triangles vote for it and
    the mean leans over. The angle at the corner is shared out between the two, so that their votes add up to one again.
note-not-depend-cut =
    Not to depend on the cut is not yet to be right: on the box of 1 × 1 × 10 Max's weights give the same normal for all
    64 cuts, 46.7° off, for they favour small faces. On a ball, where the mean is meant to stand for something round,
    they are exact, and angles are not.
fails-these-weights-give =
    these weights give the cube the same normals however its faces are cut. On round surfaces the mean depends on the
    triangles still.
both-parts-face =
    both parts of a face cut through the corner count together as much as the one part of a face cut the other way; a
    few roundings
each-face-counts = each face counts as one triangle or as two; a few roundings
by-another-program-same = another program on the same mesh, to the digits that it printed
by-exact-all-vertices = exact where all vertices of a fan lie on a sphere (Max 1999)
chart-title = Weights on a ball of slivers
chart-caption =
    The error of normals at vertices (rms) when every other row of triangles is so many times narrower: it grows with
    most weights, and stays 0 with Max's.
axis-height-wide-row = height of a wide row over that of a narrow one
axis-error-degrees = error in degrees
cube-1-title = The cube smoothed, its faces cut along one diagonal.
cube-1-caption-some-corners-lean = Some corners lean to one side.
cube-2-title = The same cube with all faces cut along the other diagonal.
cube-2-caption-light-shadow-elsewhere = Light and shadow are elsewhere.
cube-difference-title = between both
cube-difference-caption-how-far-both = How far both pictures differ: violet 0, yellow { $full-light } of the full range and more.
cube-angle-title = Weights by the angle.
cube-angle-caption-every-corner-diagonal = Every corner has the diagonal for its normal, however the faces are cut.
box-max-title = The box of 1 × 1 × 10 with Max's weights.
box-max-caption-normals-lean-towards = Normals lean towards the small faces at the ends, and the long faces look bent.
box-angle-title = The box with weights by the angle.
box-angle-caption-each-three-faces = Each of the three faces at a corner counts alike.
slivers-title = A ball of which every other row of triangles is twelve times narrower.
slivers-caption-rows-show-bands = The rows show as bands in the light.
slivers-angle-title = Weights by the angle do not help here.
slivers-angle-caption-sliver-between-vertices = A sliver between two vertices has as large an angle as a wide triangle.
slivers-max-title = Max's weights on the same triangles.
slivers-max-caption-they-exact-every = They are exact at every vertex of a sphere, and round between them.
torus-title = A torus of triangles cut at random.
torus-caption-light-uneven = The light is uneven.
torus-max-title = The same triangles with Max's weights.
torus-max-caption-light-more-even = The light is more even.
torus-itself-title = the torus itself
torus-itself-caption-torus-own-normal = The torus with its own normal at every pixel.
