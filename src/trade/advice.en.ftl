# On surfaces whose normals are known.
quick =
    Quick: from { $few } surfaces ({ $names }). Over all { $all } the best weight of a class may be another: measure
    without --quick before you choose.
class-best =
    On { $class }: { $best } (rms { $rms }°, { $ratio } times the plain loop; next is { $next } with { $next-rms }°, last
    { $worst } with { $worst-rms }°).
class-default =
    On { $class }: { $best }, the default (rms { $rms }°, { $ratio } times the plain loop; within a tenth of the least,
    which is { $next } with { $next-rms }°, last { $worst } with { $worst-rms }°).
class-quadric = Where accuracy is worth { $ratio } times the plain loop, quadric: { $rms }°.
boxes =
    On flat faces that may be triangulated this way or that (buildings, machine parts): { $right }, which points along the
    diagonal at every corner of a box; only { $invariant } do not depend on the cut at all.
precision =
    `--precision fast` differs from faithful by { $worst }° at the most on these meshes, and { $time }. A face it is off by
    up to 0.0172° where it is a thousandth as high as long, a vertex by that times what its sum shrinks by; beyond, it
    leaves the mesh to faithful.
time-less = takes { $share } of the time
time-more = takes { $share } times as long
time-same = saves no time
declined = It left { $cases } to faithful.
encodings =
    Stored normals: { $diffuse-bytes } bytes ({ $diffuse }) are enough for diffuse light within half an 8-bit step,
    { $shiny-bytes } bytes ({ $shiny }) for Blinn highlights of n = 1000 and more. Not even diffuse light survives
    { $failing }.
shading =
    Shading, over all regular meshes here: flat is off by { $flat } steps of 1/255, Gouraud by { $gouraud }, Phong by
    { $phong } (rms, linear light). A mesh four times as fine brings each closer; no shading repairs a silhouette.

# On a user mesh.
few-triangles =
    Costs were taken on { $triangles } triangles: on so few most of it is what every call takes, and ratios change from run
    to run. `crease trade` has those of large meshes.
alike = { $share } of the normals are the same with every weight.
without-quadric =
    { $share } of the normals have no quadric: too few neighbours, or none that bear it out, as on two rings of points. They
    are not in the estimate.
too-few =
    Quadrics estimate only { $estimated } of { $all } normals, too few to rank weights by: the mesh is flat between
    its creases, or has too few vertices.
safe = angle does not change when flat faces are cut into other triangles, so it is the safe choice.
partial = Estimates are from { $estimated } of { $all } normals ({ $share }): they say nothing of the rest.
too-coarse =
    Even { $best }, the closest, is { $rms }° from the quadric normals of { $estimated } normals: on a mesh as coarse as that
    the quadric is no nearer to the truth than the sums, and weights cannot be ranked by it.
closest = { $best } is closest to the quadric normals: rms { $rms }° of { $estimated } normals.
near-closest =
    { $usual } is within a tenth of the closest weight, { $best } ({ $usual-rms }° against { $rms }°), and does not change
    when flat faces are cut into other triangles.
default = angle, the default, is at { $rms }°.
cost = It costs { $ratio } times the plain single-precision loop.
quadric-wins =
    Where the surface is smooth and time is no matter, quadric itself is likely to be the most accurate, at { $ratio } times
    that loop.
estimates =
    Estimates take the quadric for the truth, which it approaches as edges become short compared with the surface's curves; on a coarse
    mesh, weights that are close to each other cannot be distinguished by it.
any-weight = The difference is below a tenth of a degree: any weight will do for diffuse light.
