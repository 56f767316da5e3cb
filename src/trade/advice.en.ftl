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
    Costs were measured on { $triangles } { $triangles ->
        [one] triangle
       *[other] triangles
    }. On a mesh this small, most of the cost is constant per call, and
    ratios vary between runs. `crease trade` without a file measures large meshes.
alike = { $share } of the normals are the same with every weighting.
too-few =
    Only { $estimated } of { $all } normals can be estimated, which is too few to compare the weightings. The mesh is flat
    between its creases, or has too few vertices.
safe = angle does not depend on the triangulation of flat faces, so it is the safe choice.
partial = Only { $share } of the normals have a reference, so errors of the others are unknown.
unknown-error =
    Fits can be compared with those of wider neighbourhoods at only { $known } of { $estimated } normals. The error of the
    reference is unknown, so the weightings cannot be compared.
reference-stored =
    Errors are angles to the normals that the mesh stores, at { $estimated } of { $all } normals. Open boundaries are omitted.
reference-jet =
    The reference is the normals of jet, at { $estimated } of { $all } normals. Open boundaries are omitted. Its own error is
    about { $error }° (rms): jets of wider neighbourhoods differ by that much.
reference-quadric =
    The reference is the normals of quadric, at { $estimated } of { $all } normals. Open boundaries are omitted. Its own error is
    about { $error }° (rms): quadrics of wider neighbourhoods differ by that much.
reference-noise =
    Jets are { $gap }° from quadrics, which is more than the error of quadrics: the vertices are noisy, or too far apart for jets.
    The reference is the normals of quadric, at { $estimated } of { $all } normals. Open boundaries are omitted. Its own error is
    about { $error }° (rms).
closest =
    { $best } has the smallest error of the sums of face normals: rms { $rms }°. angle, the default, has { $usual-rms }°.
closest-usual = angle, the default, has the smallest error of the sums of face normals: rms { $rms }°.
near-closest =
    angle, the default, is within 5 % of the closest sum of face normals, { $best } ({ $usual-rms }° and { $rms }°), and does not
    depend on the triangulation of flat faces.
undetermined =
    The most accurate sum of face normals cannot be determined on this mesh. An error of the reference of { $error }° does not
    separate these: { $candidates }.
default = angle, the default, has an rms error of { $usual-rms }°.
cost = It costs { $ratio } times the plain single-precision loop.
fit = If accuracy justifies { $ratio } times the cost of the plain loop: { $fit }, about { $rms }°.
any-weight = An error below 0.1° is not visible in diffuse light.
