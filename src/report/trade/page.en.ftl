title = Accuracy against speed
lead =
    Which vertex normals should I use, how should I store them, and how should I shade with them? Errors against surfaces
    whose normals are known, and the cost.

weights-title = Weights by class of mesh
weights-lead =
    Each number is the root mean square error on a surface at about 64 × 32 cells, the median over all surfaces; the star
    marks the best sum of faces. quadric is no sum of faces: it fits a surface through each vertex's neighbours.
frontier-caption = Towards the lower left is better. What lies above the dashed line is beaten in both.

surfaces-title = Surfaces
surfaces-lead =
    Vertices on open sides lack half of their faces, and a cone has no normal at its tip: these are left out, and counted.
    Pictures are of irregular triangles.

convergence-title = Convergence
convergence-lead =
    The order is the slope of the error over the edge length, both as logarithms. Sums of faces are of first order on
    irregular meshes and of second order on regular grids, where errors of opposite faces cancel; quadrics are of second
    order on both.
convergence-caption = Dotted: slopes of order 1 and 2.
spread-title = How errors are spread
spread-caption = At 64 × 32 or its like. Weights that are exact here have no outline.

boxes-title = Flat faces
boxes-lead =
    On a box, a weight that depends on how flat faces happen to be triangulated gives several values. One value that is not
    0 is another thing: Max's weights do not care about the cut, but are drawn to the small faces of a long box.

cost-title = Cost
cost-lead =
    One thread. The plain loop sums cross products in single precision and looks after nothing; slices are this crate's
    kernel on the same arrays; a mesh has its topology, creases and faults as well. Ratios were taken in the same run and
    differ little from machine to machine; nanoseconds do.

precision-title = Precision
precision-lead =
    What single-precision arithmetic adds to the error of tessellation and storage. Far from the origin the stored
    positions are coarse, which no arithmetic corrects.

encodings-title = Stored normals
encodings-caption = The dotted line: what diffuse light bears unseen.

shading-title = Shading
shading-lead =
    Pictures of meshes against pictures of the surfaces themselves, over the pixels that both cover, before any rounding.
    Vertices have the surface's own normals, so what differs is the shading. A step is 1/255 of the full range of linear
    light. Where a polygonal outline covers other pixels than the surface is counted apart.
shading-caption = Regular meshes, right under perspective.

approximations-title = Approximations
approximations-lead =
    Functions that this crate computes in its own way, so that they give the same bits everywhere.

advice-title = Advice

own-title = Accuracy against speed: { $name }
own-lead =
    The surface of this mesh is not known. The quadric method replaces the truth: it is of second order, sums of faces are
    of first order.
own-weights-title = Weights
own-weights-counts =
    { $vertices } vertices, { $faces } faces, { $normals } normals; { $alike } % of them are the same with every weight. No
    quadric could be fitted for { $without-quadric }.
own-errors-caption = Normals that the quadric says something of.
own-advice = Use --weight { $weight }.

errors-alternative = { $mesh }, coloured by the error of normals. { $labels }
errors-caption =
    { $mesh }. Dark violet is an error of 0.01° or less, blue-green 0.3°, yellow 10° or more, in even steps of the logarithm.
