title = Normals of too few digits
claim =
    Rounding shows in highlights first: a normal that is off by δ changes diffuse light by k_d δ at most, but Blinn's
    highlight by up to about k_s √(n/e) δ, and Phong's by twice that, for the mirrored ray turns twice as far as the
    normal.
source-1 = Lectures: 1.3.1.2, 1.6.21 (normals and exponents; they do not speak of digits)
source-2 = Paper: Z. H. Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014
formula-1 = {"|ΔI_s| ≤ k_s M(n) δ, \\quad M(n) ≈ \\sqrt{n/e}"}
formula-1-says = the change of Blinn's highlight when the normal is off by δ
formula-2 = {"δ_\\mathrm{rms} = \\frac{u}{\\sqrt{12}} \\frac{\\sqrt{a^2 + b^2 + c^2}}{2A}"}
formula-2-says =
    the error of the normal of a triangle with the sides a, b, c and the area A when its positions are rounded to
    multiples of u, which for single precision is the distance from the origin over 2²³ to 2²⁴
shown-by = a sharp highlight of some pixels (exponents from 100 to 10 000) would show it.
measure-three-times-bits = three times 8 bits: mean error at vertices
by-every-component-nearest =
    every component to the nearest 127th; for normals near an axis, as these are, (√2 + ln(1 + √2))/6 of such a step in
    the mean, 0.1726°, and 0.1701° over normals of all directions
measure-three-times-bits-largest = three times 8 bits: largest error at vertices
by-same-half-step = the same; half a step in each of three components at most, √3/254 or 0.391°
measure-bits-change-highlight = 8 bits: change of the highlight over its bound
by-bound-k-d = the bound (k_d + k_s M(n)) δ holds
measure-bits-largest-change = 8 bits: largest change of the light
measure-bits-largest-change-diffuse = 8 bits: largest change of diffuse light alone, k_d = 1
measure-bits-largest-change-blinn = 8 bits: largest change of Blinn's highlight alone, k_s = 1
measure-bits-largest-change-phong = 8 bits: largest change of Phong's highlight alone, k_s = 1
by-m-n-twice = 2 M(n) δ: twice the bound of Blinn's, k_s = 1, for the mirrored ray turns by 2 δ
measure-twice-bits-largest = twice 16 bits: largest change of the light
by-bound-largest-error = bound for 0.0037°, the largest error of this code; and single precision, n times as large
measure-needle-plain-arithmetic = needle of 1 : 10⁶, plain arithmetic: error
measure-needles-exact-differences = needles, exact differences of products: largest error
by-rounding-result = one rounding of the result
measure-pixels-bits-mean = pixels, 8 bits: mean error
measure-pixels-twice-bits = pixels, twice 16 bits: mean error
measure-pixels-single-precision = pixels, single precision: mean error
measure-pixels-far-origin = pixels, far from the origin: mean error
moved = largest change of the light from that of the sphere's own normals
cure = normals as twice 16 bits
cure-positions-centred-before = positions centred before they are rounded
eight-bits-title = 3 × 8 bits a normal
eight-bits-caption-highlight-seen-close = A highlight seen from close by, normals rounded to 8 bits a component.
eight-bits-caption-dented-blotchy = It is dented and blotchy.
sixteen-bits-title = 2 × 16 bits a normal
sixteen-bits-caption-same-normals-octahedron = The same normals on an octahedron with twice 16 bits, in a byte more.
sixteen-bits-caption-dents-all-but = The dents are all but gone.
far-away-title = positions far away
far-away-caption-normals-computed-them = Normals computed from them make the light rough.
centred-title = positions centred
centred-caption-same-sphere-positions = The same sphere with positions centred before they were rounded.
centred-caption-nothing-rough = Nothing is rough.
note-far-origin-no =
    Far from the origin no better arithmetic helps: differences of rounded positions are exact, what was lost was lost
    when they were stored. For needles it does: with plain products the cross product of two nearly parallel edges
    cancels, with exact differences of products it is right to the last digit.
fails-diffuse-light-changes =
    diffuse light changes more here: √(n/e) is the slope where cos^n is steepest, which is out of sight for a highlight
    so wide.
untested-few-faces-no = so few faces are no mean over rounding errors
by-u-b-c =
    u √(a² + b² + c²)/(2A√12) of every face, u the distance of neighbouring numbers there; three standard deviations of
    the sample of rounding errors
chart-title = Normals of needles
chart-caption =
    Largest error of a triangle's normal against its height over its length, positions in single precision: plain
    products lose a digit with each digit of slimness, exact differences of products none.
axis-height-over-length = height over length
axis-largest-error-degrees = largest error in degrees
curve-plain-products = plain products
curve-exact-differences-products = exact differences of products
curve-rounding-over-r = one rounding over r: 2⁻²⁴/r
moved-largest-change-light = largest change of the light from that of the plate's one normal
measure-plate-needles-plain = plate of needles, plain arithmetic: change of the highlight over its bound
by-bound-k-d-k = the bound (k_d + k_s M(n)) δ holds for the largest error, { $largest }°
needles-plain-title = needles, plain products
needles-plain-caption-flat-plate-light =
    A flat plate in a light close by. Each stripe is the middle of a needle 300 000 times as long as high, with the
    normal that plain products of single precision give it.
needles-plain-caption-highlight-torn-into = The highlight is torn into stripes.
needles-exact-title = needles, exact differences
needles-exact-caption-same-needles-normals = The same needles with normals from exact differences of products.
needles-exact-caption-highlight-round-spot = The highlight is a round spot.
