title = Normals of too few digits
claim =
    Rounding shows in highlights first: a normal that is off by δ changes diffuse light by k_d δ at most, but Blinn's
    highlight by up to about k_s √(n/e) δ, and Phong's by twice that, for the mirrored ray turns twice as far as the
    normal.
source-1 = Lectures: 1.3.1.2, 1.6.21 (normals and exponents; they do not speak of digits)
source-2 =
    Paper: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = the change of Blinn's highlight when the normal is off by δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    the error of the normal of a triangle with the sides a, b, c and the area A when its positions are rounded to
    multiples of u, which for single precision is the distance from the origin over 2²³ to 2²⁴
shown-by = a sharp highlight of some pixels (exponents from 100 to 10 000) would show it.
mean-error-measure = three times 8 bits: mean error at vertices
mean-error-by =
    every component to the nearest 127th; for normals near an axis, as these are, (√2 + ln(1 + √2))/6 of such a step in
    the mean, 0.1726°, and 0.1701° over normals of all directions
largest-error-measure = three times 8 bits: largest error at vertices
largest-error-by = the same; half a step in each of three components at most, √3/254 or 0.391°
change-over-bound-measure = 8 bits: change of the highlight over its bound
change-over-bound-by = the bound (k_d + k_s M(n)) δ holds
change-measure = 8 bits: largest change of the light
change-diffuse-measure = 8 bits: largest change of diffuse light alone, k_d = 1
change-blinn-measure = 8 bits: largest change of Blinn's highlight alone, k_s = 1
change-phong-measure = 8 bits: largest change of Phong's highlight alone, k_s = 1
change-phong-by = 2 M(n) δ: twice the bound of Blinn's, k_s = 1, for the mirrored ray turns by 2 δ
change-sixteen-measure = twice 16 bits: largest change of the light
change-sixteen-by = bound for 0.0037°, the largest error of this code; and single precision, n times as large
needle-plain-measure = needle of 1 : 10⁶, plain arithmetic: error
needles-exact-measure = needles, exact differences of products: largest error
needles-exact-by = one rounding of the result
pixels-eight-measure = pixels, 8 bits: mean error
pixels-sixteen-measure = pixels, twice 16 bits: mean error
pixels-single-measure = pixels, single precision: mean error
pixels-far-measure = pixels, far from the origin: mean error
bits-effect = largest change of the light from that of the sphere's own normals
bits-cure = normals as twice 16 bits
far-cure = positions centred before they are rounded
eight-bits-title = 3 × 8 bits a normal
eight-bits-caption = A highlight seen from close by, normals rounded to 8 bits a component.
eight-bits-seen = It is dented and blotchy.
sixteen-bits-title = 2 × 16 bits a normal
sixteen-bits-caption = The same normals on an octahedron with twice 16 bits, in a byte more.
sixteen-bits-seen = The dents are all but gone.
far-away-title = positions far away
far-away-seen = Normals computed from them make the light rough.
centred-title = positions centred
centred-caption = The same sphere with positions centred before they were rounded.
centred-seen = Nothing is rough.
note-1 =
    Far from the origin no better arithmetic helps: differences of rounded positions are exact, what was lost was lost
    when they were stored. For needles it does: with plain products the cross product of two nearly parallel edges
    cancels, with exact differences of products it is right to the last digit.
fails =
    diffuse light changes more here: √(n/e) is the slope where cos^n is steepest, which is out of sight for a highlight
    so wide.
few-faces = so few faces are no mean over rounding errors
far-faces-by =
    u √(a² + b² + c²)/(2A√12) of every face, u the distance of neighbouring numbers there; three standard deviations of
    the sample of rounding errors
needles-title = Normals of needles
needles-caption =
    Largest error of a triangle's normal against its height over its length, positions in single precision: plain
    products lose a digit with each digit of slimness, exact differences of products none.
needles-x = height over length
needles-y = largest error in degrees
plain-curve = plain products
exact-curve = exact differences of products
rounding-curve = one rounding over r: 2⁻²⁴/r
plate-effect = largest change of the light from that of the plate's one normal
plate-measure = plate of needles, plain arithmetic: change of the highlight over its bound
plate-by = the bound (k_d + k_s M(n)) δ holds for the largest error, { $largest }°
needles-plain-title = needles, plain products
needles-plain-caption =
    A flat plate in a light close by. Each stripe is the middle of a needle 300 000 times as long as high, with the
    normal that plain products of single precision give it.
needles-plain-seen = The highlight is torn into stripes.
needles-exact-title = needles, exact differences
needles-exact-caption = The same needles with normals from exact differences of products.
needles-exact-seen = The highlight is a round spot.
plate-cure = { exact-curve }
far-effect = { bits-effect }
far-faces-measure = { $distance } radii from the origin: error of face normals (rms)
far-away-caption = Positions stored in single precision { $distance } radii from the origin.
holds =
    for small errors. Half a step of 8 bits of this highlight (Blinn's, n = { $exponent }, k_s = { $strength }) requires
    normals that are right to { $needed }°. With 8 bits a component they are off by up to { $eight }° here, {
    $eight-times } times that; with twice 16 bits by up to { $sixteen }°, { $sixteen-times } times that.
