# Face normals of single triangles.
-face-expected = within 1 ulp, or reported as degenerate
-face-plain = n = (b-a)×(c-a); n / sqrt(n·n)
face-bound = face_normals: each f32 component within 1 ulp, or the face is reported as exactly degenerate
face-fast = 3e-7 rad times length over height, which is at most 1000 if fast is applicable

scaled-faces-what = random triangles with coordinates up to this size
scaled-faces-expected = { -face-expected }
scaled-faces-plain = { -face-plain }
mixed-faces-what = every coordinate has an arbitrary magnitude
mixed-faces-expected = { -face-expected }
mixed-faces-plain = { -face-plain }
offset-arithmetic-what =
    equilateral triangles of side 1 at this distance along each axis: error compared with the stored positions
offset-arithmetic-expected = { -face-expected }
offset-arithmetic-plain = { -face-plain }
slivers-what = triangles of length 1 and this height before rounding; one half of them has a corner at the origin
slivers-expected = { -face-expected }
slivers-plain = { -face-plain }
off-line-what = the collinear points with one coordinate moved to the next f32
off-line-expected = { -face-expected }
off-line-plain = { -face-plain }

offset-storage-what = the same triangles: error compared with the positions before rounding to f32
offset-storage-expected = at most the rotation of a face by rounding
offset-storage-plain = { -face-plain }
offset-storage-bound =
    asin((4d + 4d^2)/sin 60) for corners moved by d = sqrt(3)/2 spacings, and the rounding of the result
offset-storage-fast = the bound of storage and the bound of fast faces, 0.0172 degrees

# Vertex normals of fans.
-fan-expected = accurate to the rounding to f32
-sum-expected = accurate to the rounding to f32 and of the sum
-fan-plain = sum of w n, normalised; angles by acos(dot), Max's weight over |a|^2 |b|^2
fan-bound =
    rounding to f32, sqrt(3)/2^25 rad, and k(v + 30)/2^53 for summation over v faces whose sum shrinks by the factor k
fan-fast =
    the bound of its faces, 0.0172 degrees, and k(v + 30)/2^24 for summation over v faces whose sum shrinks by the
    factor k

scaled-fans-what = bumpy fans of seven triangles with six weightings, coordinates up to this size
scaled-fans-expected = { -fan-expected }
scaled-fans-plain = { -fan-plain }
long-spoke-what = a bumpy fan with six weightings; one of its seven spokes has this length
long-spoke-expected = { -fan-expected }
long-spoke-plain = { -fan-plain }
valence-what = the tip of a cone ten times as high as wide
valence-expected = { -sum-expected }
valence-plain = { -fan-plain }
tilt-what =
    10000 faces, uniform weights, each tilted by this angle from the vertical; their sum shrinks by the same factor
tilt-expected = { -sum-expected }
tilt-plain = { -fan-plain }
steep-tilt-what = 8 faces, each tilted by this angle from the vertical; their sum shrinks by the same factor
steep-tilt-expected = { -sum-expected }
steep-tilt-plain = { -fan-plain }
folded-what = fans that are folded back over themselves and opened by this angle, with six weightings
folded-expected = { -sum-expected }
folded-plain = { -fan-plain }
fins-what = a vertex on an edge of three faces and an edge of two faces, with six weightings
fins-expected = { -sum-expected }
fins-plain = { -fan-plain }
cone-tips-what = cones of 3, 8 and 64 faces with this height over a base of radius 1, with six weightings
cone-tips-expected = { -sum-expected }
cone-tips-plain = { -fan-plain }

opposite-what = 20 triangles, each with a reversed copy, with six weightings
opposite-expected = each corner is reported and has a unit fallback normal
opposite-plain = { -fan-plain }
opposite-bound = FaultReason::CancellingFan, with a finite unit fallback normal

quadric-what =
    open cylinders of 16, 32, 64 sides and one ring of faces in 5 rotations: the quadric through points on two lines
quadric-expected = no larger error than the rotation of faces by rounded positions
quadric-plain = uniform mean of the faces
quadric-bound =
    10 d/s: tilts of 2d/s by corners moved by d over sides s, and fits that agree with the neighbours within twice the
    tilts of both

# Faces of little or no area, and positions that are not finite.
unchanged-bound = rounding to f32, sqrt(3)/2^25 rad

sliver-threshold-what =
    heights of 1 to 8 spacings of f32, along each pair of axes: which of them are reported as slivers
sliver-threshold-expected = heights below 4 spacings are slivers, others are not
sliver-threshold-plain = sqrt(n·n) < 1e-6
sliver-threshold-bound = Slivers: height below four times the spacing at the largest coordinate
next-to-sliver-what =
    fans of six triangles and one sliver, uniform weights: error compared with the fan without the sliver
next-to-sliver-expected = the sliver does not change the normal
next-to-sliver-plain = { -fan-plain }

collinear-what = three points of small integers, times a power of two, exactly on a line
collinear-expected = all are reported, each with a finite unit normal
collinear-plain = { -face-plain }
duplicate-what = two or three corners at the same position
duplicate-expected = { collinear-expected }
duplicate-plain = { -face-plain }
far-collinear-what = three points exactly on a line through 1e6
far-collinear-expected = { collinear-expected }
far-collinear-plain = { -face-plain }
zero-area-bound = the area is exactly zero
next-to-zero-area-what = the tip of a cone with three additional faces of zero area, with six weightings
next-to-zero-area-expected = these faces do not change the normal
next-to-zero-area-plain = { -fan-plain }

non-finite-what = one coordinate of one vertex in a sheet of 128 triangles, with six weightings
non-finite-expected = its six faces are reported, all other normals are unchanged to the bit, meshes reject the position
non-finite-plain = sum of w n, normalised
non-finite-bound = FaultReason::NonFinite, MeshError::NonFinite; every normal is finite and unit

# Numbers without meshes.
pharr-what = 33962.035·(-30438.8) - 41563.4·(-24871.969), which is -75.1656: plain f32 says -128
pharr-expected = within 2 roundings of the difference, or exactly 0
pharr-plain = a·b - c·d
products-what = random f32 factors of 1e-6 to 1e6, d the f32 next to ab/c
products-expected = { pharr-expected }
products-plain = { pharr-plain }
double-products-what = random f64 factors whose products are not exact in f64, d the f64 next to ab/c
double-products-expected = { pharr-expected }
double-products-plain = { pharr-plain }
product-bound = 2u, u = 2^-53: Jeannerod, Louvet & Muller, Math. Comp. 82, 2013, and the rounding of the result

unit-vector-what = UnitVec3 of random vectors of these lengths
unit-vector-expected = accurate to the last bits of f64
unit-vector-plain = v / sqrt(v·v)
unit-vector-bound = UnitVec3: within 2^-51; three squares, two sums, a root, a division and a product of 2^-53 each

corner-angle-what = corners of this angle between edges of length 1/2 to 2, in f64; plain code computes in f32
corner-angle-expected = accurate to the last bits of f64, relative to the angle
corner-angle-plain = acos(dot(unit(a), unit(b)))
corner-angle-bound = 16/2^53: cross product 2, length 3, dot product 4, corner_angle 2 ulp, and a margin
straight-what = edges of small integers with a multiple of themselves, in the same and the opposite direction
straight-expected = exactly 0, and the f64 next to pi
straight-plain = { corner-angle-plain }
straight-bound = cross products of such integers are exact, and exactly zero

# Creases and encodings.
split-prisms-what =
    prisms with 8, 9, 12 sides in 40 rotations each, crease angle 45, 40, 30: edges that split contrary to their angle
    in 256 bits, and side edges that split
split-prisms-expected = no side edge splits; all other edges do
split-prisms-plain = dot(n1, n2) < cos(angle), normals of three corners
split-prisms-bound =
    dihedral angle > crease angle + 0.01 degrees, in 256 bits; rounding rotates these faces by less than that
counted-prisms-what =
    the same prisms, with side edges exactly at the crease angle before rounding: difference of near_crease from the
    count in 256 bits, and of that count from the sides
counted-prisms-expected =
    every side edge is counted, within max(0.1 degrees, rounding of the decimals), and no other edge
counted-prisms-plain = |acos(dot(n1, n2)) - angle| <= 0.1 degrees, normals of three corners
counted-prisms-bound =
    asin(d (sum |P(i+1) - P(i-1)| + n d) / |sum P(i) x P(i+1)|) for each of two faces whose corners move by d, in 256
    bits

octahedral-poles-what = the six axes, and directions up to 1e-2 from them
octahedral-poles-expected = no larger error than elsewhere
octahedral-poles-plain = v.xy / (|x|+|y|+|z|), folded by (1 - |yx|)·sign(xy) with sign(0) = 0
octahedral-edges-what = directions in the planes x = 0, y = 0, z = 0, and up to 1e-2 from them
octahedral-edges-expected = { octahedral-poles-expected }
octahedral-edges-plain = { octahedral-poles-plain }
snorm-poles-what = { octahedral-poles-what }
snorm-poles-expected = { octahedral-poles-expected }
snorm-poles-plain = round(v·s) / s
snorm-edges-what = { octahedral-edges-what }
snorm-edges-expected = { octahedral-poles-expected }
snorm-edges-plain = { snorm-poles-plain }
half-poles-what = { octahedral-poles-what }
half-poles-expected = { octahedral-poles-expected }
half-poles-plain = half(v)
half-edges-what = { octahedral-edges-what }
half-edges-expected = { octahedral-poles-expected }
half-edges-plain = { half-poles-plain }
encoding-bound = Encoding::worst_angle, over all directions

# Light on a point.
power-what = powers of f32 cosines, from the end of the highlight to 1
power-expected = accurate to a few roundings of 1
power-plain = powf(x, n)
power-bound-squaring = Power: n roundings by repeated squaring, n up to 128
power-bound-logarithm = Power: 4 roundings of 1 by exp2(n log2 x)

blinn-what = Blinn highlight at its bright part, light and viewer far away
blinn-expected = a few times n roundings; for large n, single precision has visible errors
blinn-plain = powf(dot(N, unit(L + V)), n)
blinn-bound = 8n roundings of the cosine (two directions, their sum, three roots, a dot product), and 4 of the power

opposite-light-what = a light and a viewer on a line through the point, on opposite sides
opposite-light-expected = no highlight
opposite-light-plain = { blinn-plain }
opposite-light-bound = no half-vector, no highlight
nearly-opposite-what = a light almost behind the point as seen from the viewer, n = 10
nearly-opposite-expected = roundings divided by the angle
nearly-opposite-plain = { blinn-plain }
nearly-opposite-bound = 16 roundings of L + V over its length, which is the angle; times n; 4 of the power
light-behind-what = Phong highlight with N·L from -1e-1 to -1e-5 and V·R near 1
light-behind-expected = no highlight
light-behind-plain = V·R > 0 ? powf(V·R, n) : 0
light-behind-bound = Guards::highlight: no highlight if N·L is at most 0
grazing-what = diffuse light with N·L within ±1e-5
grazing-expected = a few roundings of 1, never below 0
grazing-plain = dot(N, L)
grazing-bound = two directions of 2 roundings each and a dot product of 3

near-light-what = diffuse light of a point light this close to the point, in any direction
near-light-expected = accurate to a few roundings, or rejected with an error
near-light-plain = dot(N, unit(P - x)) / (d·d)
near-light-bound = 12 roundings: distance 3, direction 3, N·L 3, 1/d^2 3; f32 is rejected if d^2 is not a normal number
at-light-what = a point light at the point itself
at-light-expected = rejected with an error
at-light-plain = { near-light-plain }
at-light-bound = NotFinite: a colour that is not finite is always an error

# Coverage of pixels.
far-corners-what = one visible corner, two at a distance of 1e30 in any direction, 64 × 64 pixels
far-corners-expected = every pixel is correct
far-corners-plain = x/w, y/w; three edge functions >= 0 in f32
behind-eye-what = corners in front of and behind the eye, 64 × 64 pixels
behind-eye-expected = { far-corners-expected }
behind-eye-plain = { far-corners-plain }
near-plane-what =
    one corner at w = 0, at a distance of 1e-30 from it, or a millionth in front of or behind the near plane, 64 × 64
    pixels
near-plane-expected = { far-corners-expected }
near-plane-plain = { far-corners-plain }
view-bound = exact signs of volumes at pixels whose centre is 1/128 pixel or more from an edge; corners snap to 1/256
large-what = corners (0, 0), (2048, 0), (0, 2048) on a picture of 2048 × 1024
large-expected = every pixel is correct, on the edge by the top-left rule
large-plain = three edge functions >= 0 in f32
large-bound = closed form: pixel (i, j) is covered if i + j + 1 < 2048; if its centre is on the edge, it is not
thin-what = 20000 triangles around a point that form a disc of radius 30 on 64 × 64 pixels
thin-expected = every pixel of the disc is covered exactly once
thin-plain = { large-plain }
thin-bound = neighbours share corners; pixels whose centre is within 1/64 pixel of the rim are omitted
