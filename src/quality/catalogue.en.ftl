no-normals-title = no normals are stored
no-normals-meaning =
    Each viewer computes its own: the glTF standard requires flat normals, but some viewers smooth everything. So the
    same file looks faceted in one and soft in another.
no-normals-advice = Store normals, so that the file looks the same everywhere.

missing-normals-title = some corners have no normal
missing-normals-meaning =
    Other corners of the same mesh have a normal. A viewer fills the gaps with flat normals, zeros or nothing, so
    single faces look faceted or black among smooth ones.
missing-normals-advice = Compute the missing normals; the others stay unchanged.

not-finite-normals-title = normals that are infinite or not a number
not-finite-normals-meaning =
    Light on such a corner is not a number either. Pixels turn black or white, and bloom or denoising spreads them
    as blocks.
not-finite-normals-advice = Replace them by computed ones.

zero-normals-title = normals of length zero
zero-normals-meaning =
    They have no direction: a shader that normalises them divides by zero, and one that does not computes no light.
    The faces are black, or flicker.
zero-normals-advice = Replace them by computed ones.

not-unit-normals-title = normals that are not of unit length
not-unit-normals-meaning =
    The length is off by more than 0.00674, the tolerance of the glTF validator. In a renderer that does not
    normalise, brightness changes by that factor, and highlights by the factor raised to the specular exponent.
not-unit-normals-advice = Divide them by their length; their directions stay.

loose-length-title = normals whose length is slightly off
loose-length-meaning =
    The length is off by more than 0.001, but by no more than 8-bit storage can cause. Only a sharp highlight shows it,
    in a renderer that does not normalise.
loose-length-advice = No action needed, unless your renderer skips normalising: then recompute them.

inverted-normals-title = nearly all normals point against their faces
inverted-normals-meaning =
    Over nine tenths of the corners have a normal on the back of their face. The mesh is black under light from the
    front and bright under light from behind.
inverted-normals-advice = Recompute the normals; if the faces are reversed too, add `--orient outward` or `--flip`.

flipped-normals-title = normals that point opposite to the expected direction
flipped-normals-meaning =
    The normal points nearly opposite to the average of the faces around its vertex. The surface is dark there, with
    bright fringes where interpolation passes through zero.
flipped-normals-advice = Replace them by computed ones; the others stay unchanged.

normals-against-face-title = normals that point behind their own face
normals-against-face-meaning =
    The normal is more than 95° from its face, and no sharp fold explains it. Light from behind brightens parts of it.
normals-against-face-advice = Replace them by computed ones, unless they are authored.

constant-normals-title = all normals are equal, although the shape is curved
constant-normals-meaning =
    The whole mesh is lit like a flat card: only its outline shows the shape. Usually this is the default value of
    an exporter; for grass or signs it may be intended.
constant-normals-advice = Compute them from the faces.

swapped-axes-title = all normals have exchanged or reversed axes
swapped-axes-meaning =
    The positions were converted (y up to z up, left- to right-handed) and the normals were not. Light seems to come
    from another side than on other objects.
swapped-axes-advice = Compute them, or convert the normals like the positions.

rotated-normals-title = all normals are rotated by the same rotation
rotated-normals-meaning =
    The positions were rotated and the normals were not: one rotation brings all of them into agreement with the
    faces. Light seems to come from another side than on other objects.
rotated-normals-advice = Compute them, or rotate the normals like the positions.

untransformed-normals-title = the normals are in another coordinate space than the positions
untransformed-normals-meaning =
    They are stored in world space or in the space of another node, and a viewer transforms them once more. Light
    seems to come from another side, or slides over a scaled shape.
untransformed-normals-advice = Compute them: they are then in the space of the mesh.

stray-normals-title = isolated normals deviate from all others
stray-normals-meaning =
    They do not follow the recipe of the other normals, and no faces at the vertex explain them. The surface shows a
    dent or a bump that it does not have.
stray-normals-advice = Compute them with the weight and the crease angle of the other normals.

custom-normals-title = normals that no weighting reproduces
custom-normals-meaning =
    They were transferred from a finer mesh, manually edited, or made from marked edges. They are not wrong; recomputing
    them would change the picture.
custom-normals-advice = Keep them: `--when missing` and `--when broken` leave them unchanged.

faceted-normals-title = flat normals on a smooth shape
faceted-normals-meaning =
    Every face has its own normal, although the dihedral angles of most edges are small: each facet is visible.
faceted-normals-advice =
    Compute smooth normals, unless the facets are intended. An STL, which stores facet normals only, always looks
    faceted and is not reported: convert it with `crease normals part.stl -o part.glb`.

soft-normals-title = smooth normals on a shape with sharp edges
soft-normals-meaning =
    Nearly all edges with a dihedral angle above 50° have one normal on both sides. Flat sides show gradients
    towards their edges and look inflated.
soft-normals-advice = Compute normals with a crease angle, unless the mesh is meant to look soft.

coarse-normals-title = normals stored with low precision
coarse-normals-meaning =
    All of them lie on one grid: components of few decimals or bits, or octahedral codes. A narrow highlight moves
    in steps over smooth surfaces, and reflections look like hammered metal.
coarse-normals-advice =
    Recompute them if the material is glossy, and store floats or 16-bit integers (`--normal-format` in glTF).

tangents-off-normals-title = tangents that do not match the normals
tangents-off-normals-meaning =
    A tangent is perpendicular to its normal, has length 1, and its handedness is 1 or −1; these are not. Bumps of
    normal maps are lit from the wrong side, and seams are visible.
tangents-off-normals-advice = Recompute both.

wrong-morph-normals-title = normals of morphed shapes that do not fit the shape
wrong-morph-normals-meaning =
    At full weight of a morph target, the normal is far from what the morphed faces give. The surface moves and its
    shading does not follow.
wrong-morph-normals-advice = Compute them: normals of morph targets are computed together with those of the mesh.

averaged-crease-title = sharp edges with one normal on both sides
averaged-crease-meaning =
    The dihedral angle of these edges exceeds the crease angle of the mesh by more than 10°. Flat faces show a
    gradient towards the edge, and the corner looks inflated.
averaged-crease-advice = Compute normals with a crease angle below the dihedral angle of these edges.

split-seam-title = smooth edges with different normals on both sides
split-seam-meaning =
    The surface is smooth at these edges, which lie at a texture seam, between two primitives, or where meshes were
    joined. A line is visible where the surface has none.
split-seam-advice = Compute normals: coincident edges are joined for smoothing, and vertices stay separate.

needless-seam-title = seams with equal normals on both sides
needless-seam-meaning =
    Position, normal and texture coordinates are equal on both sides, but there are two vertices. No picture shows
    it; it costs memory, and tools that use indices do not smooth across it.
needless-seam-advice = Merge the vertices in a modelling program; normals need no action.

cracked-seam-title = edges that are separated by the rounding of their vertices
cracked-seam-meaning =
    Two open edges are closer to each other than a millionth of the bounding box's diagonal, but not equal. Tools
    that compare positions exactly shade the two sides separately: a line is visible.
cracked-seam-advice = Compute normals with such edges joined (`--weld`); vertices stay unchanged.

group-mismatch-title = smoothing groups and stored normals disagree
group-mismatch-meaning =
    The groups say smooth where the normals are split, or sharp where they are shared. A program that uses groups
    shows another shape than one that uses normals.
group-mismatch-advice = Compute normals from the groups, or ignore the groups.

no-faces-title = a file without faces
no-faces-meaning = There are only points or lines, so there is no surface with normals. A picture of it is empty.
no-faces-advice = Check the source of the export: the faces may have been omitted, or be of a kind that is not read.

inconsistent-winding-title = faces with opposite winding to their neighbours
inconsistent-winding-meaning =
    Their corners have the opposite order to those of the neighbouring faces. Back-face culling shows holes there;
    without it they are lit from behind, and averaged normals cancel.
inconsistent-winding-advice = Reverse them so that neighbours agree.

non-orientable-title = surfaces with only one side
non-orientable-meaning =
    Their faces cannot all have the same winding, as on a Möbius strip. Where the two windings meet, shading jumps
    from one side to the other.
non-orientable-advice = Cut them open along a line, or draw them two-sided and with flat normals.

inside-out-title = closed surfaces with reversed winding
inside-out-meaning =
    The signed volume has the wrong sign: negative for a solid, positive for a cavity in a solid. With back-face culling one
    sees the far side from inside; with lighting, the side towards the light is dark.
inside-out-advice = Reverse their faces, unless they are meant to be seen from inside.

open-inside-out-title = open surfaces whose front is the less visible side
open-inside-out-meaning =
    An open surface has no inside, but usually an outer side: the one from which more rays escape. With back-face
    culling one sees through the surface from outside.
open-inside-out-advice = Reverse their faces, unless they are meant to be seen from this side.

room-title = closed surfaces that face inwards, around other surfaces
room-meaning =
    The surface and most of its stored normals face inwards, and objects inside it face outwards. It looks right
    when seen from inside.
room-advice =
    No action needed if it is a room; if it is a solid with cavities, reverse everything with `crease normals
    --flip`.

zero-area-faces-title = faces without area
zero-area-faces-meaning =
    They have no direction and are not visible. Tools that normalise their zero normal spread invalid numbers to the
    neighbours.
zero-area-faces-advice = Remove them.

faces-below-storage-title = faces thinner than the rounding of their coordinates
faces-below-storage-meaning =
    Their direction is noise of the rounding of the file. They are not visible, but if they count in averages,
    normals of single corners have random directions.
faces-below-storage-advice =
    No action needed for crease, which ignores these faces when averaging; other tools may not.

needle-faces-title = long, thin faces
needle-faces-unit = times as wide as long
needle-faces-meaning =
    They are less than a thousandth as wide as long. Rounding rotates their normals by large angles, interpolated values
    jump across them, and in motion they flicker.
needle-faces-advice = Mesh the surface with better-shaped faces in the modelling program.

duplicate-faces-title = duplicate faces
duplicate-faces-meaning =
    They have the same corners in the same order. The two compete for each pixel where their shading differs, and
    smoothing stops at their edges.
duplicate-faces-advice = Remove the copies in the modelling program.

back-to-back-faces-title = faces back to back with another face
back-to-back-faces-meaning =
    They have the same corners in the opposite order: a sheet with two sides. Without culling the two compete for
    each pixel, and their averaged normals cancel.
back-to-back-faces-advice = Keep one of them and draw it two-sided, if the renderer can.

duplicate-vertices-title = vertices with equal positions and attributes
duplicate-vertices-meaning =
    Texture coordinates, colours, material and object are equal as well as the position, and no normals are stored.
    Programs that use indices shade the edge as a sharp one.
duplicate-vertices-advice =
    Merge the vertices in a modelling program, unless they mark sharp edges; crease smooths across them.

non-planar-polygons-title = non-planar polygons
non-planar-polygons-meaning =
    The choice of two triangles for a quad changes its shape and its shading, and programs choose differently.
non-planar-polygons-advice = Triangulate them in the modelling program, so that all programs agree.

concave-polygons-title = concave polygons
concave-polygons-meaning =
    Programs that cut polygons into fans put triangles outside of them. One sees dark wedges and overlaps.
concave-polygons-advice = Triangulate them in the modelling program.

crossed-polygons-title = polygons with crossing edges
crossed-polygons-meaning =
    One part faces up and the other down, so no single normal is correct for the whole polygon. A part of it is lit from
    behind.
crossed-polygons-advice = Correct the order of their corners.

non-manifold-edges-title = edges with more than two faces
non-manifold-edges-unit = faces at an edge
non-manifold-edges-meaning =
    It is ambiguous which of the faces continue each other, so nothing is smoothed across. A crease is visible
    there.
non-manifold-edges-advice = Separate the sheets in the modelling program, if the line is not wanted.

pinched-vertices-title = vertices where separate fans of faces touch
pinched-vertices-meaning =
    Several fans of faces share the vertex. A program that gives it one normal mixes unrelated surfaces.
pinched-vertices-advice =
    No action needed for `crease normals`, which gives each fan its own normal; for other programs, separate the
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
cancelling-fans-advice = Check the folded faces there; `crease normals` writes a fallback normal and counts it.

high-valence-poles-title = vertices with very many faces
high-valence-poles-unit = faces at a vertex
high-valence-poles-meaning = Shading around such a pole shows a star, because each thin face interpolates separately.
high-valence-poles-advice = Mesh the cap in another way, for example as a grid.

far-from-origin-title = the mesh is too far from the origin for its level of detail
far-from-origin-meaning =
    Viewers store positions in 32 bits: at this distance few bits remain for the size of a face. Normals that are
    computed there are wrong, and shading flickers even with correct stored normals.
far-from-origin-advice = Move the mesh to the origin and put the distance into its node.

mirrored-node-title = a node that mirrors its mesh
mirrored-node-meaning =
    Its matrix has a negative determinant, so a viewer has to reverse the winding. A viewer that does not shows the
    mesh inside out, with inverted normals and tangents.
mirrored-node-advice = No action needed if your viewers support it; otherwise apply the mirroring to the mesh.

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

mach-bands-title = smooth edges with a visible kink of brightness
mach-bands-unit = grey steps a pixel
mach-bands-meaning =
    Interpolated brightness has a kink at the edge, which is visible as a bright or dark line along it.
mach-bands-advice = Use more faces where the surface curves, or Phong shading instead of Gouraud.

coarse-outline-title = edges that make the outline look polygonal
coarse-outline-unit = pixels
coarse-outline-meaning =
    Against the background, the edge deviates from the curve of the normals by more than the threshold. The shading
    looks round and the outline polygonal.
coarse-outline-advice = Use more faces where the surface curves.

lost-highlight-title = faces too large for the highlight
lost-highlight-meaning =
    The normals at the corners of the face differ by more than the width of the highlight. With Gouraud shading the
    highlight vanishes inside the face and jumps from corner to corner in motion.
lost-highlight-advice = Use Phong shading, or more faces.
