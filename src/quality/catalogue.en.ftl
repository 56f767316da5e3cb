no-normals-title = no normals are stored
no-normals-meaning =
    Viewers compute their own: glTF asks for flat normals, other viewers smooth everything. So the same file looks
    faceted in one and soft in another. The angle is between the flat normal of a corner and the normal that `crease
    normals` computes.
no-normals-advice = Store normals, so that the file looks the same everywhere.

missing-normals-title = some corners have no normal
missing-normals-meaning =
    Other corners of the same mesh have a normal. A viewer fills the gaps with flat normals, zeros or nothing:
    single faces look faceted or black among smooth ones.
missing-normals-advice = Compute the missing normals. The others stay unchanged.

not-finite-normals-title = normals that are infinite or not a number
not-finite-normals-meaning =
    Light on such a corner is not a number either. Pixels turn black or white, and bloom or denoising spreads them
    over the picture as blocks.
not-finite-normals-advice = Replace them by computed ones.

zero-normals-title = normals of length zero
zero-normals-meaning =
    They have no direction. A shader that normalises them divides by zero; one that does not computes no light. The
    faces are black, or flicker. Corners of faces without area are not counted, because no normal is right there.
zero-normals-advice = Replace them by computed ones.

not-unit-normals-title = normals that are not of unit length
not-unit-normals-meaning =
    The length is off by more than 0.00674, the tolerance of the glTF validator. If a vertex shader does not
    normalise them, faces are too dark or too bright by that factor, and highlights by its power. Interpolation
    leans towards the longer normal.
not-unit-normals-advice = Divide them by their length. Their directions stay.

loose-length-title = normals of nearly unit length
loose-length-meaning =
    The length is off by more than 0.001, but not by more than 8-bit storage causes. It shows only in a sharp
    highlight of a renderer that does not normalise.
loose-length-advice = No action needed, unless your renderer skips normalising. Then compute them anew.

inverted-normals-title = nearly all normals point against their faces
inverted-normals-meaning =
    The winding of the faces and the normals disagree about the outer side, all over the mesh. Lit from the front
    the mesh is black; lit from behind it shines. Either the normals or the faces are reversed. Over nine tenths of
    the corners are affected; fewer are reported as flipped normals.
inverted-normals-advice =
    If the faces have the right side outside, compute the normals anew. If not, reverse the faces with `--orient
    outward` or `--flip`, and compute the normals anew.

flipped-normals-title = normals that point opposite to the expected direction
flipped-normals-meaning =
    The normal is nearly the opposite of what the faces around its vertex give, while its faces agree with their
    neighbours. The surface is dark there in the light, with bright fringes where interpolation passes through zero.
flipped-normals-advice = Replace them by computed ones. The others stay unchanged.

normals-against-face-title = normals that point behind their own face
normals-against-face-meaning =
    The normal is more than 95° from its face, but not its opposite, and it is not the mean at a sharp fold either.
    Light from behind the face reaches parts of it. It is a note if the normals follow no recipe and several such
    corners are neighbours: foliage and cloth are authored that way.
normals-against-face-advice = Replace them by computed ones, unless they are authored.

constant-normals-title = all normals are equal, although the shape is curved
constant-normals-meaning =
    The whole mesh is lit like a flat card: only its outline shows the shape. Usually this is the default value of
    an exporter. It may be intended for grass or signs.
constant-normals-advice = Compute them from the faces.

swapped-axes-title = all normals have exchanged or reversed axes
swapped-axes-meaning =
    One permutation or change of sign of the axes brings all normals into agreement with the faces. The positions
    were converted (y up to z up, left- to right-handed) and the normals were not. Light seems to come from another
    side than on other objects.
swapped-axes-advice = Compute them, or convert the normals like the positions.

rotated-normals-title = all normals are rotated by the same rotation
rotated-normals-meaning =
    One rotation brings all normals into agreement with the faces: the positions were rotated and the normals were
    not. Light seems to come from another side than on other objects. It is reported if the normals lie on at least
    three lines and a recipe reproduces half of them within 5° after the inverse rotation. On flat sheets and for
    authored normals the rotation is ambiguous; deviations are then reported corner by corner or as custom.
rotated-normals-advice = Compute them, or rotate the normals like the positions.

untransformed-normals-title = the normals are in another coordinate space than the positions
untransformed-normals-meaning =
    The matrix of a node that places the mesh, or its inverse, brings all normals into agreement with the faces:
    they are stored in world space or in the space of another node, and a viewer transforms them once more. Light
    seems to come from another side, or slides over a scaled shape. The cause names the nodes. Other findings about
    these normals refer to the mesh's own space.
untransformed-normals-advice = Compute them: they are then in the space of the mesh.

stray-normals-title = single normals deviate from all others
stray-normals-meaning =
    They deviate from the recipe that fits the mesh best by more than the threshold. Either the other normals follow
    that recipe, or nothing at the vertex explains them: no sector of its faces has such a mean, and no other corner
    there has the same normal. The surface shows a dent or a bump that it does not have.
stray-normals-advice =
    Compute them with the weight and the crease angle of the other normals. If these follow no recipe, fix the
    outliers one by one: computing all normals would change the others.

custom-normals-title = normals that no weighting reproduces
custom-normals-meaning =
    No weight and crease angle reproduces them. They were transferred from a finer mesh, edited by hand, or made
    from marked edges. In a mesh that otherwise follows a recipe they may belong to components that were made in
    another way, such as leaves next to a trunk. They are not wrong; computing them anew would change the picture.
custom-normals-advice = Keep them: `--when missing` and `--when broken` leave them unchanged.

faceted-normals-title = flat normals on a smooth shape
faceted-normals-meaning =
    Every face has its own normal, although the dihedral angles of most edges are small. Each facet shows, and each
    vertex is stored once for every face.
faceted-normals-advice = Compute smooth normals, unless the facets are intended.

soft-normals-title = smooth normals on a shape with sharp edges
soft-normals-meaning =
    Nearly all edges with a dihedral angle above 50° have one normal on both sides, although the shape has sharp
    edges: few others have 30° to 50°, or most sharp edges border a broad flat side. Its sides show gradients
    towards their edges and look inflated. It is a note if the mesh has smoothing groups, if the normals follow
    no recipe, or if most edges are gentle and the sharp ones border no flat side, as at the rim of a lens.
soft-normals-advice = Compute normals with a crease angle, unless the mesh is meant to look soft.

coarse-normals-title = normals stored with low precision
coarse-normals-meaning =
    All of them lie on one grid: components of few decimals or bits, or octahedral codes. A broad highlight does not
    show it. A narrow one moves in steps over smooth surfaces, and reflections look like hammered metal.
coarse-normals-advice =
    Compute them anew if the material is glossy. In glTF, store them as floats or 16-bit integers with
    `--normal-format`.

tangents-off-normals-title = tangents that do not match the normals
tangents-off-normals-meaning =
    A tangent is perpendicular to its normal, has length 1, and its handedness is 1 or −1. These are not. Normal
    maps are evaluated in a skewed frame: bumps are lit from the wrong side, and seams show where neighbours differ.
    Usually normals were computed anew and tangents were not.
tangents-off-normals-advice = Compute both anew.

wrong-morph-normals-title = normals of morphed shapes that do not fit the shape
wrong-morph-normals-meaning =
    At full weight of a morph target the normal is far from what the morphed faces give, further than without the
    target. The surface moves and its shading does not follow, or moves the wrong way. A target without normals is
    not reported, though it shows the same.
wrong-morph-normals-advice = Compute them: normals of morph targets are computed together with those of the mesh.

averaged-crease-title = sharp edges with one normal on both sides
averaged-crease-meaning =
    The dihedral angle of these edges exceeds the crease angle of the mesh by more than 10°, yet both sides have
    the same normal. Flat faces show a gradient towards the edge, and the corner looks inflated. It is a note if
    the normals follow no recipe, if the crease angle does not separate sharp from smooth edges in more than one
    case in fifty, or if there are fewer than eight such edges and no other edge is sharp.
averaged-crease-advice = Compute normals with a crease angle below the dihedral angle of these edges.

split-seam-title = smooth edges with different normals on both sides
split-seam-meaning =
    The recipe of the mesh is smooth at these edges, but the normals on the two sides differ at both ends by
    more than `--seam` allows. Such edges lie at a texture seam, between two primitives, or where meshes were
    joined. A line shows where the surface has none. It is a note if the normals follow no recipe, or if the
    crease angle does not separate sharp from smooth edges and the edges are not a cut through a smooth surface.
split-seam-advice = Compute normals: coincident edges are joined for smoothing, and vertices stay separate.

needless-seam-title = seams with equal normals on both sides
needless-seam-meaning =
    Position, normal and texture coordinates are equal on both sides, but there are two vertices. No picture shows
    it, so its angle is 0. It costs memory, and tools that use indices see a boundary and do not smooth across it.
needless-seam-advice = Merge the vertices with a tool for that. Normals need no action.

cracked-seam-title = edges that are separated by the rounding of their vertices
cracked-seam-meaning =
    Two open edges are closer to each other at both ends than a millionth of the bounding box's diagonal, but not
    equal: positions were printed with few digits, or submeshes were moved by different matrices. Tools that compare
    positions exactly, such as `crease normals` without `--weld`, see a boundary and shade the two sides separately.
    A line shows where the surface continues.
cracked-seam-advice = Compute normals with such edges joined. Vertices stay unchanged.

group-mismatch-title = smoothing groups and stored normals disagree
group-mismatch-meaning =
    The groups say smooth where the normals are split, or sharp where they are shared. A program that uses groups
    shows another shape than one that uses normals.
group-mismatch-advice = Compute normals from the groups, or ignore the groups.

no-faces-title = a file without faces
no-faces-meaning =
    There are only points or lines, so there is no surface with normals. A picture of it is empty. Nothing else was
    checked.
no-faces-advice = Check the source of the export: the faces may have been omitted, or be of a kind that is not read.

inconsistent-winding-title = faces with opposite winding to their neighbours
inconsistent-winding-meaning =
    Their corners have the opposite order to those of the neighbouring faces. With back-face culling there are
    holes; without it they are lit from behind, and averaged normals cancel. It is a warning if none of them shares
    a vertex with its neighbours.
inconsistent-winding-advice = Reverse them so that neighbours agree.

non-orientable-title = surfaces with only one side
non-orientable-meaning =
    Its faces cannot all agree, as on a Möbius strip. Where the two windings meet, shading jumps from one side to
    the other.
non-orientable-advice = Cut it open along a line, or draw it two-sided and with flat normals.

inside-out-title = closed surfaces with reversed winding
inside-out-meaning =
    The signed volume of the component has the wrong sign: negative for a solid, positive for a cavity in one. With
    back-face culling one sees its far side from inside; lit, it is dark on the side of the light. It is an error if
    most stored normals of the component contradict the faces. It is a warning if they agree or if none are stored:
    empty rooms and skies are made that way on purpose. A closed surface around other objects may be reported as
    `room`.
inside-out-advice = Reverse its faces, unless it is meant to be seen from inside.

open-inside-out-title = open surfaces with the less visible side in front
open-inside-out-meaning =
    An open surface has no inside, but usually an outer side. crease casts rays from both sides of sample points and
    counts how many escape; the side with more escaping rays is the outer one, with a confidence. For nearly flat
    surfaces the test is inconclusive. With back-face culling one sees through the surface from outside. It is a
    warning if the stored normals contradict the faces, else a note: a bowl or a valley may be meant to be seen from
    above.
open-inside-out-advice = Reverse its faces, unless it is meant to be seen from this side.

room-title = closed surfaces that face inwards, around other surfaces
room-meaning =
    Most stored normals of the component point inward, as its faces do, and at least half of the normals of the
    objects directly inside it, in the same mesh, point outward. So it is taken for a room and is right when seen
    from inside. A solid with cavities whose faces and normals are all reversed looks the same to this test. Without
    stored normals every closed surface is taken for a solid.
room-advice =
    No action needed if it is meant to be seen from inside. If it is a solid with cavities, reverse everything with
    `crease normals --flip`.

zero-area-faces-title = faces without area
zero-area-faces-meaning =
    They have no direction. They are not visible, so no angle measures them. But tools that normalise their zero
    normal spread invalid numbers to the neighbours.
zero-area-faces-advice = Remove them.

faces-below-storage-title = faces thinner than the rounding of their coordinates
faces-below-storage-meaning =
    Their direction is noise of the rounding of the file. They are not visible, but if they count in averages,
    normals of single corners have random directions.
faces-below-storage-advice = No action needed for crease: it ignores these faces when averaging. Other tools may not.

needle-faces-title = long, thin faces
needle-faces-meaning =
    They are less than a thousandth as wide as long. Rounding rotates their normals far, interpolation across them
    is a jump, and in motion they flicker. The angle is the largest rotation of a normal if the corners are rounded
    to single precision.
needle-faces-advice = Mesh the surface with better-shaped faces at the source.

duplicate-faces-title = duplicate faces
duplicate-faces-meaning =
    They have the same corners in the same order. The two compete for each pixel where their shading differs. Each
    edge has more than two faces, so smoothing stops there. The angle is the change of the averaged normal by the
    copy.
duplicate-faces-advice = Remove the copies at the source.

back-to-back-faces-title = faces back to back with another face
back-to-back-faces-meaning =
    They have the same corners in the opposite order: a sheet with two sides. Without culling the two compete for
    each pixel. Smoothed together, their normals cancel.
back-to-back-faces-advice = Keep one of them and draw it two-sided, if the renderer can.

duplicate-vertices-title = vertices with equal positions and attributes
duplicate-vertices-meaning =
    Texture coordinates, colours, material and object are equal as well as the position, and no normals are stored.
    crease smooths across such edges. Programs that use indices see a boundary, shade the edge as a sharp one, and
    store more vertices than the shape needs. The angle is between the normal by index and the normal that crease
    computes.
duplicate-vertices-advice =
    Merge the vertices with a tool for that, unless they mark sharp edges. Computing normals needs no action.

non-planar-polygons-title = non-planar polygons
non-planar-polygons-meaning =
    The choice of two triangles for a quad changes its shape and its shading, and programs choose differently.
non-planar-polygons-advice = Triangulate them at the source, so that all programs agree.

concave-polygons-title = concave polygons
concave-polygons-meaning =
    Programs that cut polygons into fans put triangles outside of them: dark wedges and overlaps. The angle is
    between the polygon and the worst triangle of the fan from its first corner.
concave-polygons-advice = Triangulate them at the source.

crossed-polygons-title = polygons with crossing edges
crossed-polygons-meaning =
    One part faces up and the other down. There is no right normal for the whole, and a part of it is lit from
    behind. Polygons of up to 64 corners are checked.
crossed-polygons-advice = Correct the order of their corners.

non-manifold-edges-title = edges with more than two faces
non-manifold-edges-meaning =
    It is ambiguous which of the faces continue each other, so nothing is smoothed across: a crease shows there,
    with a dihedral angle of up to that value.
non-manifold-edges-advice = Separate the sheets at the source, if the line disturbs.

pinched-vertices-title = vertices where separate fans of faces touch
pinched-vertices-meaning =
    Several fans of faces share the vertex. A program that gives it one normal mixes unrelated surfaces. The angle
    is between that normal and the one of a corner's own fan.
pinched-vertices-advice =
    No action needed for `crease normals`, which gives each fan its own normal. For other programs, separate the
    vertices.

folded-edges-title = edges where the surface folds back onto itself
folded-edges-meaning =
    The two faces lie on top of each other. A normal smoothed over the fold fits neither, and shading breaks up
    along it.
folded-edges-advice = Keep such edges sharp, or remove the overlap.

cancelling-fans-title = corners whose face normals cancel out
cancelling-fans-meaning =
    The faces around the vertex point in all directions, so their average has no direction. Tools write zero or
    noise there: a black or flickering spot.
cancelling-fans-advice =
    Check the folded faces there. `crease normals` writes a fallback normal from the neighbours, and counts it.

high-valence-poles-title = vertices with very many faces
high-valence-poles-meaning =
    Shading around such a pole shows a star, because each thin face interpolates separately. The angle is between
    the normal of the pole and the face there that deviates most.
high-valence-poles-advice = Mesh the cap in another way, for example as a grid.

far-from-origin-title = the mesh is far from the origin for its detail
far-from-origin-meaning =
    Viewers store positions in 32 bits. At this distance from the origin few bits remain for the size of a face, so
    a normal that is computed there is wrong: by the stated angle on average, and by more on slender faces. Shading
    flickers even with right stored normals.
far-from-origin-advice = Move the mesh to the origin and put the distance into its node.

mirrored-node-title = a node that mirrors its mesh
mirrored-node-meaning =
    Its matrix has a negative determinant. According to the glTF specification a viewer reverses the winding. A
    viewer that does not shows the mesh inside out, with inverted normals and tangents.
mirrored-node-advice = No action needed if your viewers support it. Otherwise apply the mirroring to the mesh.

singular-node-title = a node that flattens its mesh
singular-node-meaning =
    Its matrix has no inverse, so normals cannot be transformed. They become zero or not a number, and the mesh
    black.
singular-node-advice = Give the node a scale other than zero along every axis.

shading-terminator-title = normals far from their face
shading-terminator-meaning =
    For light from between the two directions, the normal is lit and the face is not, or the reverse. Along the edge
    of the shadow the surface breaks into triangles.
shading-terminator-advice = Use smaller faces there, or a crease.

mach-bands-title = smooth edges where the slope of brightness jumps
mach-bands-meaning =
    Interpolated brightness has a kink at the edge, which is visible as a bright or dark line along it. It is
    measured as the change of slope of a white matt surface under a key light 45° from the edge's normal, in 8-bit
    steps a pixel, with the mesh 512 pixels wide.
mach-bands-advice = Use more faces where the surface curves, or Phong shading instead of Gouraud.

coarse-outline-title = edges that make the outline look polygonal
coarse-outline-meaning =
    Where such an edge is seen against the background, its two faces deviate from the curve of the normals by more
    than the threshold, in pixels. The shading looks round and the outline polygonal.
coarse-outline-advice = Use more faces where the surface curves.

lost-highlight-title = faces too large for the highlight
lost-highlight-meaning =
    The normals at the corners of the face differ by more than the width of the highlight. With Gouraud shading the
    highlight vanishes inside the face and jumps from corner to corner in motion.
lost-highlight-advice = Use Phong shading, or more faces.
