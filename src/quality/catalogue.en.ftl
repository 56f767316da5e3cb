no-normals-title = no normals are stored
no-normals-meaning =
    Each viewer makes its own: glTF asks for flat ones, others smooth everything, so the same file looks faceted here
    and like soap there. The angle is between the flat normal of a corner and what `crease normals` gives it.
no-normals-advice = Store normals, so that it looks alike everywhere.

missing-normals-title = some corners have no normal
missing-normals-meaning =
    Other corners of the same mesh have one. A viewer fills the gaps with flat normals, zeros or nothing: single faces
    look faceted or black among smooth ones.
missing-normals-advice = Compute the missing ones; those that are there stay as they are.

not-finite-normals-title = normals that are not a number, or infinite
not-finite-normals-meaning =
    Light on such a corner is not a number either. Pixels turn black or white, and bloom or denoising spreads them over
    the picture as blocks.
not-finite-normals-advice = Replace them by computed ones.

zero-normals-title = normals of length zero
zero-normals-meaning =
    They have no direction: a shader that normalises them divides by zero, one that does not gets no light. The faces
    are black, or flicker. Corners of faces without area are not counted, since nothing right could stand there.
zero-normals-advice = Replace them by computed ones.

not-unit-normals-title = normals that are not of unit length
not-unit-normals-meaning =
    The length is off by more than 0.00674, the bound of the glTF validator. Where a vertex shader passes them on
    unnormalised, faces are too dark or too bright by that factor, highlights by its power; interpolation leans towards
    the longer normal.
not-unit-normals-advice = Divide them by their length; their directions stay.

loose-length-title = normals of nearly unit length
loose-length-meaning =
    The length is off by more than 0.001 and no more than 8-bit storage makes it. It shows only where a highlight is
    raised to a high power without normalising first.
loose-length-advice = Nothing, unless your renderer skips normalising; then compute them again.

inverted-normals-title = nearly all normals point against their faces
inverted-normals-meaning =
    The winding of the faces says outside where the normals say inside, all over the mesh. Lit from the front it is
    black, lit from behind it shines: either the normals or the faces are turned round. Distinguished from single
    flipped normals by their share, over nine tenths.
inverted-normals-advice =
    If the faces are right side out, compute the normals again; if not, turn the faces with `--orient outward` or
    `--flip`, and compute the normals again.

flipped-normals-title = normals turned round
flipped-normals-meaning =
    The normal is nearly the opposite of what the faces round its vertex give, while its faces agree with their
    neighbours. It is dark where the surface is lit, and interpolation sweeps through zero on the way to it: black spots
    with bright fringes.
flipped-normals-advice = Replace them by computed ones; the others stay.

normals-against-face-title = normals that point behind their own face
normals-against-face-meaning =
    The normal is more than 95° from its face, but not its opposite, and is no mean round a sharp fold either. Parts of
    the face are lit by lamps behind it. A note where no rule made the normals, of the mesh or of a piece of it, and
    several stand so together: foliage and cloth cards are made so on purpose, up to the opposite.
normals-against-face-advice = Replace them by computed ones, unless they are meant.

constant-normals-title = all normals are the same, though the shape bends
constant-normals-meaning =
    The whole mesh is lit like one flat card: no form shows but its outline. Usually an exporter's default value;
    sometimes meant, for grass or signs.
constant-normals-advice = Compute them from the faces.

swapped-axes-title = all normals have axes exchanged or reversed
swapped-axes-meaning =
    One permutation or change of sign of the axes brings all normals into agreement with the faces: positions were
    converted (y up to z up, left to right handed) and normals were not. Light seems to come from another side than on
    all other objects.
swapped-axes-advice = Compute them, or convert the normals like the positions.

rotated-normals-title = all normals are turned by one rotation
rotated-normals-meaning =
    One rotation brings all normals into agreement with the faces: the positions were turned and the normals stayed
    behind. It is told where the normals lie on three lines at least and a rule gives half of them within 5° once they
    are turned back: of a flat sheet, or of normals made by hand, it cannot be told, and what is off there is told
    corner by corner or as custom. Light seems to come from another side than on all other objects.
rotated-normals-advice = Compute them, or turn the normals like the positions.

untransformed-normals-title = the normals are in another space than the positions
untransformed-normals-meaning =
    The matrix of the node that places the mesh, of one above it, or of several together, or its inverse, brings all
    normals into agreement with the faces, or with a rule that they follow nowhere else: they are stored in the space of
    the world or of another node and a viewer turns them once more, or they undo what it does. The cause names the
    nodes. What else is told of them is of what they are in the space of the mesh. Light seems to come from another
    side, or slides over a scaled shape.
untransformed-normals-advice = Compute them: they are then those of the mesh's own space.

stray-normals-title = single normals disagree with all the others
stray-normals-meaning =
    They differ from the rule that fits the mesh best by more than the threshold, and either the others follow that
    rule, or nothing at their vertex gives them, whatever made the others: no run of the faces there has such a mean,
    and no other corner there has the same normal, or most have what the rule gives. A dent or a bump is seen where the
    surface has none.
stray-normals-advice =
    Compute them with the weighting and the crease angle that the rest was made with; where the rest follows no rule,
    mend them one by one, for computing all normals would change the others.

custom-normals-title = normals that no rule derives from the faces
custom-normals-meaning =
    No weighting and crease angle of ours reproduces them: transferred from a finer mesh, edited by hand, or made by
    marks on edges. Beside what follows a rule they may be of pieces that were made otherwise, as leaves beside a trunk.
    Nothing is wrong with that; computing them again would change the picture.
custom-normals-advice = Keep them: `--when missing` and `--when broken` leave them alone.

faceted-normals-title = flat normals on a shape that bends smoothly
faceted-normals-meaning =
    Every face has its own normal although most edges bend by little. Each facet shows, and each vertex is stored once
    for every face.
faceted-normals-advice = Compute smooth normals, unless the facets are meant.

soft-normals-title = smooth normals on a shape with sharp edges
soft-normals-meaning =
    Edges that bend by more than 50° have one normal on both sides, all of them, though hardly any edge is between
    gentle and sharp: the shape is made of flat or gently curved sides, and is no coarse picture of a round one. Its
    sides show gradients towards their edges, as if it were blown up or made of soap. A note where smoothing groups ask
    for it, no rule derives the normals, or most edges bend gently and no flat lies beside the sharp ones, as at the rim
    of a lens: then it may be meant.
soft-normals-advice = Compute normals with a crease angle, unless it is meant to look soft.

coarse-normals-title = normals stored with few bits
coarse-normals-meaning =
    All of them lie on one grid: components of few decimals or bits, perhaps made unit again, or octahedral codes. A
    broad highlight does not show it; a narrow one wanders in steps over smooth surfaces, and reflections look like
    hammered metal.
coarse-normals-advice =
    Compute them again where the material is glossy; in glTF, store them as floats or 16-bit integers with
    `--normal-format`.

tangents-off-normals-title = tangents that do not fit the normals
tangents-off-normals-meaning =
    A tangent lies across its normal, has length 1, and its handedness is 1 or −1; these do not. Normal maps are read in
    a skewed frame: bumps are lit from a wrong side, and where neighbours differ a seam shows. Usually normals were
    computed again and tangents were not.
tangents-off-normals-advice = Make both again.

wrong-morph-normals-title = normals of morphed shapes that do not fit the shape
wrong-morph-normals-meaning =
    With a morph target in full, the normal that comes out is far from what its faces give, further than without it. The
    face moves and its light does not move along, or moves the wrong way. A target that stores no normals at all is left
    alone, though it shows the same.
wrong-morph-normals-advice = Compute them: those of the morph targets are computed along with the mesh's own.

averaged-crease-title = sharp edges with one normal on both sides
averaged-crease-meaning =
    Edges that bend as much as those that the mesh keeps sharp share their normals: both faces are shaded as if the edge
    were round. Flat faces show a gradient towards it, and the corner looks inflated. A note where the normals follow no
    rule, not even two in five of them to the letter, or where more than one in fifty of the ends of edges that bend is
    on the wrong side of the crease angle: they may be made by hand; and where there are fewer than eight and no other
    edge is kept sharp: on a smooth shape it is the faces that came out badly.
averaged-crease-advice = Compute normals with a crease angle below the bend of these edges.

split-seam-title = smooth edges with different normals on their two sides
split-seam-meaning =
    The edge bends less than those that the mesh keeps smooth, yet its sides have normals of their own, at both ends
    further apart than `--seam` allows: at a uv seam, between two primitives, or after pieces were joined. A line shows
    where the surface has none. A note where the normals follow no rule, not even two in five of them to the letter, or
    where more than one in fifty of the ends of edges that bend is on the wrong side of the crease angle and split edges
    bend by more than most others: they may be made by hand.
split-seam-advice = Compute normals; coincident edges are joined for smoothing, and vertices stay apart.

needless-seam-title = seams whose two sides have the same normal
needless-seam-meaning =
    Position, normal and texture coordinates are equal on both sides, but the vertices are two. No picture shows it, so
    its angle is 0; it costs memory, and tools that go by indices see a rim there and will not smooth over it.
needless-seam-advice = Merge the vertices with a tool that does; normals need nothing.

cracked-seam-title = edges that miss each other by the rounding of their vertices
cracked-seam-meaning =
    Two open edges, each at both ends closer to the other than a millionth of the bounding box's diagonal and not at
    equal places, as when positions were printed with few digits or pieces were moved by different matrices. What goes
    by equal places, as `crease normals` without `--weld` does, sees a rim there and shades the two sides apart: a line
    shows where the surface goes on. Reported where the stored normals of such edges differ, as a warning or a note like
    `split-seam`; as a note where none are stored, by the bend of the edge.
cracked-seam-advice = Compute normals with such edges joined; vertices stay where they are.

group-mismatch-title = smoothing groups and stored normals disagree
group-mismatch-meaning =
    The groups say smooth where the normals are split, or sharp where they are shared. A program that goes by groups
    shows another shape than one that goes by normals.
group-mismatch-advice = Compute normals from the groups, or leave the groups out.

no-faces-title = a file without faces
no-faces-meaning =
    There are points or lines at most, so there is no surface to have normals, and nothing else was looked for. A
    picture of it is empty.
no-faces-advice = Look for what it was exported from: the faces may have been left out, or be of a kind that is not read.

inconsistent-winding-title = faces that run against their neighbours
inconsistent-winding-meaning =
    Their corners go round the other way than those of the faces beside them. With back faces culled there are holes;
    without, they are lit from behind, and means of normals at their corners cancel. A warning where none of them shares
    a vertex with those beside it, as where normals were turned with the faces in formats that store one for each
    vertex: pieces that only touch may run as they like.
inconsistent-winding-advice = Turn them so that neighbours agree.

non-orientable-title = a surface with one side only
non-orientable-meaning =
    Its faces cannot all agree, as those of a Möbius strip. Wherever the two ways meet, light jumps from one side to the
    other, by half a turn of the normal.
non-orientable-advice = Cut it open along a line, or draw it two-sided and with flat normals.

inside-out-title = closed surfaces that face the wrong way
inside-out-meaning =
    The signed volume of the component is negative where it should be positive, or positive where that of a cavity
    should be negative, by the number of others that it lies in; that is told exactly, or not at all. What lies in the
    matter of another mesh of the file, wherever nodes put it, is a cavity and is right. With back faces culled one sees
    its far side from within; lit, it is dark on the side of the lamp. An error where most of the stored normals of such
    a component point the other way: faces and normals contradict each other. A warning where they agree, and the
    normals are then judged by the faces as they are, or where none are stored: empty rooms and skies are made so on
    purpose, and only who made it knows. Round other things it may be told to be a `room`.
inside-out-advice = Turn its faces outward, unless it is meant to be seen from within.

open-inside-out-title = surfaces with a rim that face the side from which less is seen
open-inside-out-meaning =
    Such a surface has no inside, but as a rule an outer side: rays leave points on both its sides, and more get away
    from the outer one. A vote of points tells it, with a confidence; planes and gentle hills have no votes. With back
    faces culled one sees through it from without. A warning where the stored normals point the other way as well; else
    it may be meant, as a bowl or a valley seen from above, and is a note.
open-inside-out-advice = Turn its faces, unless it is meant to be seen from this side.

room-title = closed surfaces that face inwards, round what stands in them
room-meaning =
    Most of the stored normals of the component point inwards as its faces do, and of what stands directly in it, in the
    same mesh, at least half points outwards by its own. So it is taken for a room: seen from within it is right, and
    what stands in it is judged as if nothing were round it. With back faces culled one sees into it from without. What
    is not told apart is a solid with cavities whose faces and normals are all turned; and without stored normals every
    closed surface is taken for solid.
room-advice =
    Nothing, if it is meant to be seen from within. If it is a solid with cavities, turn all there is with `crease
    normals --flip`.

zero-area-faces-title = faces without area
zero-area-faces-meaning =
    They have no direction. Nothing of them is seen, so no angle measures it, but tools that normalise their zero normal
    spread values that are no numbers to their neighbours.
zero-area-faces-advice = Leave them out.

faces-below-storage-title = faces thinner than the rounding of their coordinates
faces-below-storage-meaning =
    Their direction is noise of the file's own rounding. Nothing of them is seen, but where they count in means of
    normals, single corners point anywhere: off by a right angle in the mean of all ways round the longest edge.
faces-below-storage-advice = Nothing: `crease normals` gives them no say in the means. Other tools may.

needle-faces-title = long and thin faces
needle-faces-meaning =
    They are less than a thousandth as wide as long: a triangle as its height and longest edge have it, a polygon along
    the line through two corners far apart, and across that or its longest edge. Rounding turns their normals far,
    interpolation across them is a jump, and in motion they flicker. The angle is that by which a normal may turn if the
    corners are rounded to single precision.
needle-faces-advice = Mesh the surface with better-shaped faces where it is made.

duplicate-faces-title = faces that stand twice at one place
duplicate-faces-meaning =
    The same corners, the same way round. The two fight for each pixel where their shading differs, and each edge has
    more than two faces, so smoothing stops there. The angle is that by which the mean of all faces at a corner,
    weighted by their angles, turns as the copy counts as well.
duplicate-faces-advice = Remove the copies where the mesh is made.

back-to-back-faces-title = two faces back to back
back-to-back-faces-meaning =
    The same corners, the other way round: a sheet with two sides. Drawn without culling, the two fight for each pixel;
    smoothed together, their normals cancel: they are half a turn apart.
back-to-back-faces-advice = Keep one of them and draw it two-sided, if the renderer can.

duplicate-vertices-title = vertices at one place that nothing tells apart
duplicate-vertices-meaning =
    Texture coordinates, colours, material and object are equal as well as the place, and no normals are stored that
    would differ. `crease` smooths over such edges all the same; programs that go by indices see a rim there, shade the
    edge as a sharp one, and count more vertices than the shape needs. The angle is between the mean of the faces that
    have the vertex by its index and what `crease` gives their corners: where it is 0, as on a box of unshared corners,
    nothing shows. A file with stored normals has `needless-seam` in its place.
duplicate-vertices-advice =
    Merge the vertices with a tool that does, unless they stand for sharp edges; computing normals needs nothing.

non-planar-polygons-title = polygons whose corners are in no plane
non-planar-polygons-meaning =
    Which two triangles a quad becomes changes its shape and its shading, and each program cuts its own way.
non-planar-polygons-advice = Cut them into triangles where the mesh is made, so that all programs agree.

concave-polygons-title = polygons with a corner that bends inwards
concave-polygons-meaning =
    Programs that cut polygons into fans put triangles outside of them: dark wedges and overlaps. The angle is between
    the polygon and the triangle of the fan from its first corner that is furthest off: half a turn for one that is laid
    over, and 0 where the first corner is the one that bends.
concave-polygons-advice = Cut them into triangles where the mesh is made.

crossed-polygons-title = polygons that cross themselves
crossed-polygons-meaning =
    One part faces up and the other down, half a turn apart: there is no right normal for the whole, and a part of it is
    lit from behind. Polygons of up to 64 corners are looked at.
crossed-polygons-advice = Correct the order of their corners.

non-manifold-edges-title = edges of more than two faces
non-manifold-edges-meaning =
    Which of the faces go on into each other is not told, so nothing is smoothed across: a crease shows there, with a
    bend of up to that angle.
non-manifold-edges-advice = Separate the sheets where the mesh is made, if the line is in the way.

pinched-vertices-title = vertices where surfaces touch in a point
pinched-vertices-meaning =
    Several fans of faces share the vertex. A program that gives it one normal mixes surfaces that have nothing to do
    with each other; the angle is between that and what a corner's own fan gives.
pinched-vertices-advice = Nothing for `crease normals`, which gives each fan its own; for other programs, separate them.

folded-edges-title = edges where the surface turns back onto itself
folded-edges-meaning =
    The two faces lie on top of each other. A normal smoothed over the fold is that of neither, and shading breaks up
    along it.
folded-edges-advice = Keep such edges sharp, or clear the overlap.

cancelling-fans-title = corners whose face normals cancel out
cancelling-fans-meaning =
    The faces round the vertex point all ways, so their mean has no direction. Tools write zero or noise there: a black
    or flickering spot. It is no angle; all light is lost.
cancelling-fans-advice =
    Look at the folded faces there. `crease normals` gives such corners a normal of their neighbours, or else of one of
    the faces, and counts them.

high-valence-poles-title = vertices with very many faces
high-valence-poles-meaning =
    Shading round such a pole shows a star: each thin face interpolates on its own. The angle is between the pole's
    normal and the face there that looks furthest from it.
high-valence-poles-advice = Mesh the cap otherwise, for instance as a grid.

far-from-origin-title = far from the origin for its detail
far-from-origin-meaning =
    Viewers hold positions in 32 bits. At this distance from the origin so few are left for the size of a face that its
    normal, if computed there, is off: by an angle in the mean, over faces whose corners are rounded each on its own,
    and by up to a larger one, the bound for a usual face; slender ones are off by more. Shading ripples and flickers,
    though stored normals are right.
far-from-origin-advice = Move the mesh to the origin and put the distance into its node.

mirrored-node-title = a node that mirrors its mesh
mirrored-node-meaning =
    Its matrix has a negative determinant. By the standard a viewer turns the winding round; one that does not shows the
    mesh inside out, its normals turned by half a turn, and its tangents the wrong way.
mirrored-node-advice = Nothing, if your viewers know; else apply the mirroring to the mesh.

singular-node-title = a node that flattens its mesh
singular-node-meaning =
    Its matrix has no inverse, and so nothing says how to turn normals: they become zero or no numbers, and the mesh
    black.
singular-node-advice = Give the node a scale other than zero along every axis.

shading-terminator-title = normals far from their face
shading-terminator-meaning =
    For every direction between the two, a light sees the shading normal but not the face, or the face but not the
    normal. Along the edge of the shadow the surface breaks into triangles.
shading-terminator-advice = Use smaller faces there, or a crease.

mach-bands-title = smooth edges where the slope of brightness jumps
mach-bands-meaning =
    Brightness interpolated over the two faces has a kink at the edge, which eyes see as a bright or dark line along it.
    Measured as the change of slope of a white matte surface under a key light 45° from the edge's normal, in 8-bit
    steps a pixel, with the mesh 512 pixels wide.
mach-bands-advice = Use more faces where it bends, or shade each pixel (Phong) instead of each vertex (Gouraud).

coarse-outline-title = an outline with visible corners
coarse-outline-meaning =
    Where such an edge is seen against the background, its two faces cut the curve that the normals promise by more than
    the threshold, in pixels. The shading says round, the outline says polygon.
coarse-outline-advice = Use more faces where it bends.

lost-highlight-title = faces too large for the highlight
lost-highlight-meaning =
    The normals at the corners of the face are further apart than the highlight of its material is wide. Computed at the
    corners only (Gouraud), it vanishes inside the face and jumps from corner to corner in motion.
lost-highlight-advice = Shade each pixel (Phong), or use more faces.
