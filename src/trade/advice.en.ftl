# On surfaces whose normals are known.
quick =
    Quick measurement on { $few } surfaces ({ $names }). On all { $all } surfaces another weighting can be the best of a
    class: measure without --quick before you choose.
class-best =
    On { $class }: { $best } (rms { $rms }°, { $ratio } times the cost of the plain loop). The next best is { $next }
    with { $next-rms }°, the worst { $worst } with { $worst-rms }°.
class-default =
    On { $class }: { $best }, the default (rms { $rms }°, { $ratio } times the cost of the plain loop). It is within 10
    % of the best, { $next } with { $next-rms }°; the worst is { $worst } with { $worst-rms }°.
class-fit = If accuracy justifies { $ratio } times the cost of the plain loop: { $fit }, { $rms }°.
boxes =
    On flat faces with arbitrary triangulation (buildings, machine parts): { $right }. At every corner of a box its
    normal is the diagonal. Only { $invariant } do not depend on the triangulation.
precision =
    `--precision fast` differs from faithful by at most { $worst }° on these meshes, and { $time } on arrays. For a face whose
    height is a thousandth of its length, the error is up to 0.0172°. At a vertex, this error is multiplied by the
    factor by which the sum of face normals shrinks. Outside this range, faithful is used for the mesh.
time-less = takes { $share } of the time
time-more = takes { $share } times the time
time-same = saves no time
declined = fast was not applicable to { $cases }; faithful was used.
encodings =
    Stored normals: { $diffuse-bytes } bytes ({ $diffuse }) are sufficient for diffuse light within half an 8-bit step,
    { $shiny-bytes } bytes ({ $shiny }) for Blinn highlights with n = 1000 and more. Visible errors even in diffuse
    light: { $failing }.
shading =
    Shading, over all regular meshes here: the rms error in linear light is { $flat } steps of 1/255 for flat,
    { $gouraud } for Gouraud and { $phong } for Phong. A mesh four times as fine reduces all three errors. No shading
    corrects a polygonal outline.

# On a user mesh.
few-triangles =
    Costs were taken on { $triangles } triangles. On a mesh this small, most of the cost is constant per call, and
    ratios vary between runs. `crease trade` without a file measures large meshes.
alike = { $share } of the normals are the same with every weighting.
without-quadric =
    { $share } of the normals have no quadric: the vertex has too few neighbours, or the neighbours do not confirm the
    fit, as on two rings of points. They are not in the estimate.
too-few =
    Quadrics estimate only { $estimated } of { $all } normals, which is too few to rank the weightings. The mesh is flat
    between its creases, or has too few vertices.
safe = angle does not depend on the triangulation of flat faces, so it is the safe choice.
partial =
    Estimates are from { $estimated } of { $all } normals ({ $share }). For the other normals there is no estimate.
too-coarse =
    Even the closest weighting, { $best }, is { $rms }° (rms) from the quadric normals of { $estimated } normals. On a
    mesh this coarse, the quadric is no more accurate than the sums, so weightings cannot be ranked by it.
closest = { $best } is closest to the quadric normals: rms { $rms }° over { $estimated } normals.
near-closest =
    { $usual } is within 10 % of the closest weighting, { $best } ({ $usual-rms }° against { $rms }°), and does not
    depend on the triangulation of flat faces.
default = angle, the default, has an rms error of { $rms }°.
cost = It costs { $ratio } times the plain single-precision loop.
quadric-wins =
    If the surface is smooth and time is not critical, quadric itself is probably the most accurate weighting, at
    { $ratio } times the plain loop.
estimates =
    Estimates use the quadric as the reference. Its error falls when edges are short compared with the radius of
    curvature. On a coarse mesh it cannot distinguish weightings with similar errors.
any-weight = The difference is below 0.1°: for diffuse light, any weighting is suitable.
