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
highlight-below-pixel = the true highlight is narrower than a pixel
facets-below-pixels = not held against the law: facets are hardly larger than pixels
sphere-by = a pixel's centre is up to 0.71 pixels from the vertex
plate-measure = plate: Gouraud's peak over Phong's
plate-by = k_d cos α + k_s cos(α)^n at the corners, α = 35°; single precision, and Phong's peak between pixels
sphere-measure = sphere: Gouraud's peak over the true one, the highlight between two vertices
displacement-measure = sphere turned by a quarter of a segment: displacement of the peak
displacement-by = R sin(Δ/4), to the nearest vertex; half a pixel's diagonal at either peak
flicker-gouraud-measure = Gouraud: flicker of the peak over a turn
flicker-phong-measure = Phong: flicker of the peak over a turn
flicker-beyond-diffuse-measure = Gouraud: the same, beyond the flicker of diffuse light
flicker-cure = Phong's shading
missing-effect = what of the highlight is missing at its peak, as far as pixels hold it
plate-gouraud-title = plate, Gouraud
plate-gouraud-caption = All four corners of the plate lean away from the light.
plate-phong-title = plate, Phong
plate-phong-caption = The same two triangles: interpolated normals face the light in the middle.
plate-phong-seen = The highlight is there.
sphere-gouraud-title = sphere, Gouraud
sphere-gouraud-caption = N = { $segments } facets round, n = { $exponent }: the highlight falls between two vertices.
sphere-phong-title = sphere, Phong
sphere-phong-caption = The same sphere with Phong's shading.
sphere-phong-seen = The highlight is round and in its place.
sphere-exact-title = the sphere itself
sphere-exact-caption = Every pixel with the normal of the true sphere.
film-title = Gouraud above, Phong below
film-caption =
    The highlight from close by while the sphere turns by one segment, from left to right, as in the animation
    (--animate).
note-1 =
    Gouraud's shading mixes colours of vertices, and no mixture is brighter than the brightest vertex. When the sphere
    turns, vertices pass under the highlight one by one and it pulses, once for each. Phong's shading mixes normals and
    lights every pixel anew.
flicker-title = The highlight of a turning sphere
flicker-caption =
    { $is-cured ->
        [yes]
            The brightest pixel against the turn: with Gouraud's shading it falls and rises again with every segment,
            as the closed form says, which is of the very vertex: pixels have their centres up to half a pixel from
            it, and their tops are a little lower. With Phong's it stays.
       *[no] The brightest pixel against the turn, with Gouraud's shading and with Phong's, and the closed form of Gouraud's.
    }
flicker-x = turn in degrees
flicker-y = peak luminance
law-curve = closed form, Gouraud
flicker-gouraud-by = { sphere-by }
missing-cure = { flicker-cure }
flicker-effect = flicker of the highlight's peak beyond that of diffuse light, as far as pixels resolve it
plate-gouraud-seen = The whole plate is duller than the highlight in its middle would be.
sphere-gouraud-seen = Between them the sphere is duller than its highlight.
film-seen = In the upper row it dims and comes back.
gouraud-curve = Gouraud
phong-curve = Phong
holds =
    wherever the nearest vertex's normal is farther from the highlight than the highlight is wide: with N facets round
    the sphere, for exponents from about (N/π)² on, here { $least }. As it turns, the highlight flickers.
holds-only-if =
    the nearest vertex's normal is farther from the highlight than the highlight is wide. On this sphere of N = {
    $segments } facets round, that takes exponents from about (N/π)² = { $least } on; at { $exponent } its highlight is
    wider than a facet: dulled, not lost.
