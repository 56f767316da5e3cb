title = The lost highlight
claim =
    If all vertices of a polygon are badly lit, Gouraud's shading shows all of it badly lit: a highlight inside is lost.
    Phong's shading finds it.
source-1 = Lectures: 1.6.7, 1.6.13, 1.6.15
source-2 = Ting 2008: “perda de pontos de brilho” (loss of highlights)
formula-1 = {"I_{\\max} = k_d \\cos(α) + k_s \\cos(α)^n"}
formula-1-says =
    all that Gouraud's shading can reach, α the angle from the true highlight to the nearest vertex's normal; here k_d =
    0.4 and k_s = 0.6
formula-2 = {"F = 1 − k_d \\cos(Δ/2) − k_s \\cos(Δ/2)^n"}
formula-2-says = how much the highlight of a turning sphere flickers: α goes from 0 to Δ/2 and back, Δ = 2π/N
shown-by =
    a highlight of some pixels on facets that are wider than it (exponents from 16 to 1000, in a picture large enough)
    would show it.
untested-true-highlight-narrower = the true highlight is narrower than a pixel
untested-not-held-against = not held against the law: facets are hardly larger than pixels
pixel-centre-up = a pixel's centre is up to 0.71 pixels from the vertex
measure-plate-gouraud-peak = plate: Gouraud's peak over Phong's
by-k-d-cos = k_d cos α + k_s cos(α)^n at the corners, α = 35°; single precision, and Phong's peak between pixels
measure-sphere-gouraud-peak = sphere: Gouraud's peak over the true one, the highlight between two vertices
measure-sphere-turned-quarter = sphere turned by a quarter of a segment: displacement of the peak
by-r-sin-nearest = R sin(Δ/4), to the nearest vertex; half a pixel's diagonal at either peak
measure-gouraud-flicker-peak = Gouraud: flicker of the peak over a turn
measure-phong-flicker-peak = Phong: flicker of the peak over a turn
measure-gouraud-same-beyond = Gouraud: the same, beyond the flicker of diffuse light
moved = flicker of the highlight's peak, beyond that of diffuse light
moved-flicker-highlight-peak = flicker of the highlight's peak, as far as pixels hold it
cure = Phong's shading
moved-highlight-missing-peak = what of the highlight is missing at its peak
moved-highlight-missing-peak-far = what of the highlight is missing at its peak, as far as pixels hold it
plate-gouraud-title = plate, Gouraud
plate-gouraud-caption-all-four-corners = All four corners of the plate lean away from the light.
plate-gouraud-caption-whole-plate-evenly = So the whole plate is evenly dull: the highlight in its middle is lost.
plate-gouraud-caption-highlight-wide-they =
    The highlight is so wide that they have much of it: in the middle it is dulled, not lost.
plate-phong-title = plate, Phong
plate-phong-caption-same-triangles-interpolated = The same two triangles: interpolated normals face the light in the middle.
plate-phong-caption-highlight = The highlight is there.
sphere-gouraud-title = sphere, Gouraud
sphere-gouraud-caption-n-facets-round = N = { $from } facets round, n = { $exponent }: the highlight falls between two vertices.
sphere-gouraud-caption-dull-bar-between = A dull bar between them is all that is left of it.
sphere-gouraud-caption-wider-facet-dulled = It is wider than a facet: dulled, not lost.
sphere-phong-title = sphere, Phong
sphere-phong-caption-same-sphere-phong = The same sphere with Phong's shading.
sphere-phong-caption-highlight-round-place = The highlight is round and in its place.
sphere-exact-title = the sphere itself
sphere-exact-caption-every-pixel-normal = Every pixel with the normal of the true sphere.
film-title = Gouraud above, Phong below
film-caption-highlight-close-while =
    The highlight from close by while the sphere turns by one segment, from left to right, as in the animation
    (--animate).
film-caption-gouraud-gets-dimmer = Gouraud's gets dimmer and comes back, Phong's stays.
film-caption-both-get-dimmer = Both get dimmer and come back.
note-gouraud-shading-mixes =
    Gouraud's shading mixes colours of vertices, and no mixture is brighter than the brightest vertex. When the sphere
    turns, vertices pass under the highlight one by one and it pulses, once for each. Phong's shading mixes normals and
    lights every pixel anew.
chart-title = The highlight of a turning sphere
chart-caption =
    The brightest pixel against the turn: with Gouraud's shading it falls and rises again with every segment, as the
    closed form says, which is of the very vertex: pixels have their centres up to half a pixel beside it, and their
    tops are a little lower. With Phong's it stays.
chart-caption-brightest-pixel-against =
    The brightest pixel against the turn, with Gouraud's shading and with Phong's, and the closed form of Gouraud's.
axis-turn-degrees = turn in degrees
axis-peak-luminance = peak luminance
closed-form-gouraud = closed form, Gouraud
