title = Accuracy against speed
lead =
    Which vertex normals, storage formats and shading methods are accurate, and what do they cost? Errors are measured
    against surfaces with known normals.

weights-title = Weights by class of mesh
weights-lead =
    Each number is the root mean square (rms) error on a surface of about 64 × 32 cells, as the median over the
    surfaces that can be divided like this. Vertices on open boundaries are omitted, because half of their faces are missing. The
    spread is the largest change of such a median over five seeds of the random numbers. The star marks the most accurate
    sum of face normals. The weights quadric and jet are not sums of face normals: they fit a surface to the neighbours of each
    vertex. The weight best chooses between them and angle for each mesh.
frontier-caption =
    Lower left is better. Hollow markers are dominated weightings: another one is both cheaper and more accurate.
frontier-class = Medians over { $surfaces } surfaces, without boundary vertices. { $spread }
frontier-spread = Other seeds change a median by at most { $share } %.
frontier-no-spread = These meshes have no random numbers.

surfaces-title = Surfaces
surfaces-lead =
    Some vertices are omitted and counted: vertices on open boundaries, where half of the faces are missing, and the tip
    of a cone, which has no normal. The pictures show irregular triangles.

convergence-title = Convergence
convergence-lead =
    The order is the slope of the error over the edge length on logarithmic axes. Sums of face normals are of first
    order on irregular meshes. On regular grids they are of second order, because errors of opposite faces cancel.
    Quadrics are of second order on both, jets of third order.
convergence-caption = Dotted lines: slopes of orders 1 and 2.
spread-title = Distribution of errors
spread-caption = Meshes of about 64 × 32 cells. Weightings that are exact here have no outline.

boxes-title = Flat faces
boxes-lead =
    On a box, weightings that depend on the triangulation of flat faces have several values. A single value above 0 has
    another cause: Max's weights do not depend on the triangulation, but favour the small faces of a long box.

cost-title = Cost
cost-lead =
    One thread. The plain loop sums cross products in single precision, without any checks. The column for slices is this
    crate's kernel on the same arrays. The column for a mesh includes topology, creases and fault checks. Ratios are measured in the same run
    and differ little between machines; nanoseconds differ more.

precision-title = Precision
precision-lead =
    The error that single-precision arithmetic adds to the error of tessellation and storage. Far from the origin, the
    stored positions are coarse, and no arithmetic can correct this.

encodings-title = Stored normals
encodings-caption = Dotted line: the largest error that is not visible in diffuse light.

shading-title = Shading
shading-lead =
    Pictures of meshes are compared with pictures of the exact surfaces, before rounding and over the pixels that both
    cover. Vertices have the exact normals of the surface, so differences come from the shading. A step is 1/255 of the
    full range of linear light. Pixels that only one of both outlines covers are counted separately.
shading-caption = Regular meshes, with perspective-correct interpolation.

approximations-title = Approximations
approximations-lead = Functions that this crate computes itself, so that the results have the same bits everywhere.

advice-title = Advice

own-title = Accuracy against speed: { $name }
own-lead-stored = The normals that this mesh stores are assumed to be the true ones.
own-lead-jet =
    The exact surface of this mesh is unknown. The reference is the normals of jet: they are of third order, sums of face normals
    of first order.
own-lead-quadric =
    The exact surface of this mesh is unknown. The reference is the normals of quadric: they average noise, and have the smaller
    estimated error on this mesh.
own-weights-title = Weights
own-weights-counts =
    { $vertices } vertices, { $faces } faces, { $normals } normals. { $alike } % of the normals are the same with every
    weighting. { $estimated } normals are compared; the others are on open boundaries or have no reference.
own-errors-caption = Normals that are compared with the reference.
own-advice = Use --weight { $weight }.
own-no-advice = No weighting can be recommended on this mesh.

errors-alternative = { $mesh }, coloured by the error of normals. { $labels }
errors-caption =
    { $mesh }. Dark violet is an error of 0.01° or less, blue-green 0.3°, yellow 10° or more, on a logarithmic scale.
