title = Quantised normals are visible first in highlights
claim =
    Rounding of normals is visible first in highlights. A normal with error δ changes diffuse light by at most k_d δ. It
    changes the Blinn highlight by up to about k_s √(n/e) δ, and the Phong highlight by twice that, because the
    reflected ray rotates by twice the angle.
source-1 = Lectures: 1.3.1.2, 1.6.21 (normals and exponents; number precision is not discussed)
source-2 =
    Paper: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = change of the Blinn highlight if the normal has the error δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    rms error of the normal of a triangle with sides a, b, c and area A, with positions rounded to multiples of u. In
    single precision, u is the distance from the origin over 2²³ to 2²⁴
shown-by = Use a sharp highlight of some pixels (exponents from 100 to 10 000) to show it.
mean-error-measure = 3 × 8 bits: mean error at vertices
mean-error-by =
    each component rounded to a multiple of 1/127. The mean error near an axis, as here, is (√2 + ln(1 + √2))/6 of this
    step, or 0.1726°; over all directions it is 0.1701°
largest-error-measure = 3 × 8 bits: largest error at vertices
largest-error-by = the same rounding; at most half a step in each of three components, √3/254 or 0.391°
change-over-bound-measure = 3 × 8 bits: change of light over its bound
change-over-bound-by = the bound (k_d + k_s M(n)) δ
change-measure = 3 × 8 bits: largest change of light
change-diffuse-measure = 3 × 8 bits: largest change of diffuse light alone, k_d = 1
change-blinn-measure = 3 × 8 bits: largest change of the Blinn highlight alone, k_s = 1
change-phong-measure = 3 × 8 bits: largest change of the Phong highlight alone, k_s = 1
change-phong-by =
    2 M(n) δ, twice the bound of the Blinn highlight with k_s = 1, because the reflected ray rotates by 2 δ
change-sixteen-measure = 2 × 16 bits: largest change of light
change-sixteen-by = the bound for 0.0037°, the largest error of this encoding, plus single precision times n
needle-plain-measure = sliver of 1 : 10⁶, plain products: error of the normal
needles-exact-measure = slivers, exact differences of products: largest error
needles-exact-by = one rounding of the result
pixels-eight-measure = pixels, 3 × 8 bits: mean error
pixels-sixteen-measure = pixels, 2 × 16 bits: mean error
pixels-single-measure = pixels, single precision: mean error
pixels-far-measure = pixels, far from the origin: mean error
bits-effect = largest change of light compared with exact normals of the sphere
bits-cure = normals stored as 2 × 16 bits
far-cure = positions centred before rounding
eight-bits-title = 3 × 8 bits per normal
eight-bits-caption = A close view of a highlight. Each component of the normals is rounded to 8 bits.
eight-bits-seen = The highlight is dented and blotchy.
sixteen-bits-title = 2 × 16 bits per normal
sixteen-bits-caption = The same normals in octahedral encoding with 2 × 16 bits, one byte more.
sixteen-bits-seen = The highlight is almost smooth.
far-away-title = far from the origin
far-away-seen = Normals computed from these positions make the light uneven.
centred-title = positions centred
centred-caption = The same sphere with positions centred before rounding.
centred-seen = The light is smooth.
note-1 =
    Far from the origin, better arithmetic does not help. Differences of rounded positions are exact; the precision was
    lost when the positions were stored. For slivers, better arithmetic does help. With plain products, the cross
    product of two nearly parallel edges cancels; with exact differences of products, it is correct to the last digit.
fails =
    diffuse light changes more than the highlight here. √(n/e) is the slope at the steepest point of cos^n; for a
    highlight this wide, that point is not visible.
few-faces = not compared: too few faces for a mean over rounding errors
far-faces-by =
    u √(a² + b² + c²)/(2A√12) of every face, with u the distance between neighbouring numbers there; tolerance: three
    standard deviations of the sample of rounding errors
needles-title = Normals of slivers
needles-caption =
    Largest error of a triangle's normal against its height over its length, with positions in single precision. With
    plain products, a sliver ten times thinner has an error ten times larger. With exact differences of products, the
    error does not grow.
needles-x = height over length
needles-y = largest error in degrees
plain-curve = plain products
exact-curve = exact differences of products
rounding-curve = one rounding in single precision over r
plate-effect = largest change of light compared with the one exact normal of the plate
plate-measure = plate of slivers, plain products: change of light over its bound
plate-by = the bound (k_d + k_s M(n)) δ for the largest error, { $largest }°
needles-plain-title = slivers, plain products
needles-plain-caption =
    A flat plate in a near point light. Each stripe is the middle of a sliver 300 000 times as long as high, with the
    normal from plain products in single precision.
needles-plain-seen = The highlight breaks up into stripes.
needles-exact-title = slivers, exact differences
needles-exact-caption = The same slivers with normals from exact differences of products.
needles-exact-seen = The highlight is a round spot.
plate-cure = { exact-curve }
far-effect = { bits-effect }
far-faces-measure = { $distance } radii from the origin: error of face normals (rms)
far-away-caption = Positions stored in single precision at { $distance } radii from the origin.
holds =
    for small errors. To keep this highlight (Blinn, n = { $exponent }, k_s = { $strength }) within half an 8-bit step,
    normals must be accurate to { $needed }°. With 3 × 8 bits the largest error is { $eight }°, { $eight-times } times
    that; with 2 × 16 bits it is { $sixteen }°, { $sixteen-times } times that.
