title = Gouraud shading loses highlights between vertices
claim =
    If a highlight lies inside a polygon and no vertex is in it, Gouraud shading loses the highlight. Phong shading
    shows it.
source-1 = Lectures: 1.6.7, 1.6.13, 1.6.15
source-2 = Ting 2008: “perda de pontos de brilho” (loss of highlights)
formula-1 = {"I_{\\max} = k_d \\cos(α) + k_s \\cos(α)^n"}
formula-1-says =
    largest luminance of Gouraud shading; α is the angle from the true highlight to the normal of the nearest vertex.
    Here k_d = 0.4 and k_s = 0.6
formula-2 = {"F = 1 − k_d \\cos(Δ/2) − k_s \\cos(Δ/2)^n"}
formula-2-says = flicker of the highlight on a rotating sphere: α goes from 0 to Δ/2 and back, with Δ = 2π/N
shown-by =
    Use a highlight of some pixels on facets wider than the highlight (exponents from 16 to 1000, a large picture) to
    show it.
highlight-below-pixel = not compared: the true highlight is narrower than a pixel
facets-below-pixels = not compared with the formula: facets are hardly larger than pixels
sphere-by =
    luminance at the nearest vertex by the formula; tolerance: a pixel centre is up to 0.71 pixels from the vertex
plate-measure = plate: peak of Gouraud over peak of Phong
plate-by =
    k_d cos α + k_s cos(α)^n at the corners, α = 35°; tolerance: single precision, and the peak of Phong lies between
    pixels
sphere-measure = sphere, highlight between two vertices: peak of Gouraud over the true peak
displacement-measure = sphere rotated by a quarter of a segment: displacement of the peak
displacement-by = R sin(Δ/4), the distance to the nearest vertex; tolerance: half a pixel diagonal at each peak
flicker-gouraud-measure = Gouraud: flicker of the peak over a rotation
flicker-phong-measure = Phong: flicker of the peak over a rotation
flicker-beyond-diffuse-measure = Gouraud: flicker of the peak beyond that of diffuse light
flicker-cure = Phong shading
missing-effect = loss of highlight at its peak, as far as pixels resolve it
plate-gouraud-title = plate, Gouraud
plate-gouraud-caption = The normals at all four corners of the plate point away from the light.
plate-phong-title = plate, Phong
plate-phong-caption = The same two triangles: in the middle, the interpolated normals face the light.
plate-phong-seen = The highlight is visible.
sphere-gouraud-title = sphere, Gouraud
sphere-gouraud-caption =
    N = { $segments } facets around the sphere, n = { $exponent }; the highlight falls between two vertices.
sphere-phong-title = sphere, Phong
sphere-phong-caption = The same sphere with Phong shading.
sphere-phong-seen = The highlight is round and at the right position.
sphere-exact-title = exact sphere
sphere-exact-caption = The sphere with its exact normal at every pixel.
film-title = Gouraud (top), Phong (bottom)
film-caption =
    Close view of the highlight while the sphere rotates by one segment, from left to right. The animation (--animate)
    shows the same.
note-1 =
    Gouraud shading interpolates the colours of vertices, so no point is brighter than the brightest vertex. While the
    sphere rotates, vertices pass under the highlight one by one, and the highlight pulses once for each. Phong shading
    interpolates normals and computes the light at every pixel.
flicker-title = Highlight of a rotating sphere
flicker-caption =
    { $is-cured ->
        [yes]
            Luminance of the brightest pixel against rotation. With Gouraud shading it falls and rises with every
            segment, slightly lower than the closed form, because pixel centres are up to half a pixel from the vertex.
            With Phong shading it is constant.
       *[no]
            Luminance of the brightest pixel against rotation, with Gouraud and Phong shading, and the closed form for
            Gouraud.
    }
flicker-x = rotation in degrees
flicker-y = peak luminance
law-curve = closed form, Gouraud
flicker-gouraud-by = { sphere-by }
missing-cure = { flicker-cure }
flicker-effect = flicker of the highlight's peak beyond that of diffuse light, as far as pixels resolve it
plate-gouraud-seen = The whole plate is darker than the highlight that belongs in its middle.
sphere-gouraud-seen = Between them the sphere is darker than its highlight.
film-seen = In the upper row it fades and returns.
gouraud-curve = Gouraud
phong-curve = Phong
holds =
    if the highlight is narrower than the angle from it to the nearest vertex normal. With N facets around the sphere,
    this needs exponents from about (N/π)² on, here { $least }. While the sphere rotates, the highlight flickers.
holds-only-if =
    the highlight is narrower than the angle from it to the nearest vertex normal. With N = { $segments } facets around
    this sphere, this needs exponents from about (N/π)² = { $least } on. With the exponent { $exponent } the highlight
    is wider than a facet: it is darkened, not lost.
