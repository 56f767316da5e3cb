# The help of values that options take, by type and name.

emit-corner = one per corner of a face, shared where equal; vertices are split where the format needs it
emit-vertex = one per vertex, over all faces at it; sharp edges are ignored
emit-face = one per face: PLY face properties, STL facets, or rows of the JSON report

creaserule-fan = sharp edges cut the fan of faces at a vertex into smooth groups with one normal each
creaserule-cone = each corner averages the faces within the angle of its own face

groups-honour = edges between different groups, or without one, are sharp
groups-ignore = smoothing groups have no effect

hardedge-uv = edges with different texture coordinates on both sides
hardedge-material = edges between two materials
hardedge-authored = edges whose stored normals on both sides differ by more than 0.1°

slivers-exclude = ignored, unless a smooth group has no other face
slivers-keep = averaged like any other face

precision-faithful = each component of a face normal within 1 ulp of its exact value (f32 triangles and quads), at any
    magnitude, offset or thinness
precision-fast = f32 arithmetic for well-shaped faces with edges of 1e-6 to 1e6, else as faithful; cheaper (see `crease
    trade`)

degenerate-keep = they stay, with a fallback normal
degenerate-drop = they are removed

orient-keep = faces stay unchanged
orient-consistent = neighbours agree; in each component the minority is reversed
orient-outward = closed components face outward, cavities inward, rooms as their stored normals; open components face their
    outer side, if it is certain

meshcompression-none = no compression: every program reads it
meshcompression-meshopt = without loss by meshopt (EXT_meshopt_compression), which not every program reads

tangentpolicy-auto = computed by MikkTSpace where normals change, from the texture coordinates of the normal or anisotropy
    texture. Without coordinates they stay if normals rotate by less than 30°, else they are omitted with a warning
tangentpolicy-drop = omitted, with a warning; viewers then generate them if there is a normal texture
tangentpolicy-keep = kept unchanged
tangentpolicy-regenerate = computed by MikkTSpace, also where normals do not change; omitted without coordinates

materialfallback-default = light grey, not metallic, roughness 0.6; white if vertices have colours
materialfallback-none = no material: viewers then show a rough metal

upaxis-x = +x
upaxis-y = +y
upaxis-z = +z

normalformat-same = as in the input, else f32
normalformat-f32 = 32-bit floats
normalformat-i16 = 16-bit integers (KHR_mesh_quantization)
normalformat-i8 = 8-bit integers (KHR_mesh_quantization)

action-summary = counts of files, errors, bytes and seconds
action-failed = the inputs that failed, one on each line
action-merge = all entries as one journal

sight-auto = from the side that most of the worst positions face
sight-front = from +z
sight-back = from −z
sight-right = from +x
sight-left = from −x
sight-top = from +y
sight-bottom = from −y

severity-error = wrong in any picture
severity-warning = visible in some light or in some viewers
severity-note = for information, may be intended

language-en = English
language-pt = Portuguese

kind-plane = a rectangle
kind-sphere = a sphere
kind-ellipsoid = three different axes
kind-cylinder = a tube, open at both ends
kind-cone = with a tip, open at the base
kind-torus = a ring
kind-catenoid = the film between two rings: mean curvature zero
kind-wave = z = 0.3 sin 3x cos 3y
kind-monkey-saddle = z = x³ − 3xy²
kind-superquadric = between box, ellipsoid and octahedron
kind-bezier = one bicubic patch
kind-teapot = Newell's, of 32 patches

pattern-triangles = a grid of the parameters, its cells cut in two
pattern-stretched = the same, with cells stretched by --ratio in one direction
pattern-slivers = every second row of vertices is --ratio times closer to the next row
pattern-quads = the cells themselves
pattern-polygons = the dual of the triangles: mostly hexagons; the tip of a cone is cut off
pattern-icosphere = a subdivided icosahedron (sphere, ellipsoid, superquadric)
pattern-marching = marching tetrahedra (not bezier and teapot); --segments along the longest side
pattern-scattered = Delaunay triangles of random points (plane, wave, monkey-saddle)

shading-flat = once a face
shading-gouraud = at the corners; colours are interpolated (Gouraud 1971)
shading-phong = at every sample; normals are interpolated (Phong 1973)
shading-wireframe = only edges are drawn
shading-exact = at every sample, on the analytic surface of the object
shading-traced = at every sample, with shadows, reflection and refraction (Whitted 1980)

interpolation-scanline = along the polygon's edges, then along the scanline; depends on the rotation of the face
interpolation-affine = barycentric on triangles of the picture: ignores perspective
interpolation-perspective = barycentric on triangles of the scene; correct under perspective

variant-flat = flat shading
variant-gouraud = Gouraud shading
variant-phong = Phong shading
variant-wireframe = edges
variant-exact = the analytic surface
variant-traced = traced rays: shadows, reflection, refraction
variant-scanline = scanline interpolation
variant-affine = affine interpolation
variant-perspective = perspective-correct interpolation

reflectionchoice-phong = (V·R)ⁿ with the mirrored ray (Phong 1973)
reflectionchoice-blinn = (N·H)ⁿ with the half-vector (Blinn 1977)
reflectionchoice-given = no light: the colours of vertices are interpolated

flatsample-centroid = at the mean of the corners
flatsample-vertex-mean = at every corner; the face has the mean of the colours

overlay-wire = edges of faces
overlay-creases = edges whose sides have different normals
overlay-vertex-normals = lines along the normals of vertices
overlay-face-normals = lines along the normals of faces

hiddenlines-remove = they are omitted
hiddenlines-show = they are drawn like all others

cull-none = none
cull-back = faces seen from behind
cull-front = faces seen from the front

samples-1 = the centre
samples-4 = a rotated square
samples-8 = 8 positions, each in its own row and column
samples-16 = 16 positions, each in its own row and column

bits-8 = 256 steps
bits-16 = 65536 steps; PNG only

terminator-smooth = kept: only the interpolated normal counts
terminator-hard = removed at once, so that shadows end at edges of faces
terminator-soft = removed gradually (Chiang, Li and Burley 2019)

tonerule-clamp = each component is clamped to 1
tonerule-max = the colour is divided by its largest component

transfer-srgb = the curve of sRGB
transfer-direct = the number itself, as in the lectures

color-auto = on a terminal, unless NO_COLOR is set; CLICOLOR_FORCE forces it
color-always = always
color-never = never

format-obj = Wavefront OBJ
format-ply = PLY, ASCII or binary
format-stl = STL, ASCII or binary
format-gltf = glTF 2.0, JSON
format-glb = glTF 2.0, binary
format-3mf = 3MF, which is read only

weight-uniform = all equal (Gouraud 1971)
weight-area = area of the face
weight-angle = angle of the face at the corner (Thürmer & Wüthrich 1998)
weight-angle-area = angle times area
weight-max = sin of the angle over the product of the edge lengths; exact on a sphere (Max 1999)
weight-edge = 1 over the product of the edge lengths
weight-quadric = least-squares quadric through the two-ring: second order; for noisy points
weight-jet = osculating jet of degree 3 (Cazals & Pouget 2005): third order; for smooth surfaces without noise
weight-best = jet, quadric or angle, whichever has the smallest estimated error on the mesh

when-always = all
when-missing = none; only corners without a normal are filled
when-broken = also those that are not finite, zero, or against their own face; other lengths are normalised

minimise-work = operations for the pictures
minimise-bytes = bytes of vertex and index buffers
minimise-vertices = vertices in buffers

axis-shading = Phong, Gouraud, flat
axis-weight = how vertex normals are averaged
axis-creases = normals split at sharp edges, or one for each vertex
axis-precision = faithful or fast normals
axis-storage = the format of stored normals
axis-merging = whether vertices that agree are stored once
axis-interpolation = perspective or affine
axis-reflection = which terms of the material are evaluated
axis-tessellation = cells of analytic surfaces
axis-two-sided = light on both sides of faces
axis-lights = kind, attenuation and presence of lights

truth-estimated = normals of a fit, with an estimate of their error
truth-stored = the normals that the file stores

reference-declared = the scene as declared
reference-accurate = the scene with Phong shading, perspective interpolation, faithful `best` normals and no rounding of them

metric-steps = the largest difference of a pixel, in steps of 1/255
metric-flip = the mean of ꟻLIP over the picture

permission-antialiasing = fewer samples of a pixel: 4 or 1

filekind-png = without loss, 8 or 16 bits
filekind-jpeg = with loss, small
filekind-webp = without loss, smaller than PNG
filekind-gif = at most 256 colours; animations
