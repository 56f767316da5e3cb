title = Flat shading is correct only for distant light and viewer
claim =
    Flat shading assumes that light and viewer are infinitely far away. It is not realistic even for faceted objects.
    With a near light or, for highlights, a near viewer, the direction changes from point to point of a facet.
source-1 = Lectures: 1.5.1, 1.6.12, 1.6.45
formula-1 = {"|ΔI_d| ≤ 2 k_d \\sin(ε/2), \\quad \\sin(ε) = \\frac{r}{D}"}
formula-1-says = error of diffuse light on a face of circumradius r; the light is at the distance D from its centre
formula-2 = {"|ΔI_s| ≤ k_s M(n) ε, \\quad M(n) = \\sqrt{n} \\left(1 − \\frac{1}{n}\\right)^{(n − 1)/2}"}
formula-2-says = error of the Phong highlight with the viewer at the distance D; M is the steepest slope of cosⁿ
shown-by = Use light within 90° of the face normal, and more faces in the cured picture, to show it.
lamp-measure = point light at { $ratio } circumradii: largest error of diffuse light
viewer-measure = viewer at { $ratio } circumradii: largest error of the highlight
light-along-plate = not compared: with light parallel to the plate, rounding decides which side is lit
viewer-aside-measure = viewer at { $ratio } circumradii, light at { $aside }°: largest error of the highlight
share-of-bound-measure = largest error over its bound
share-of-bound-by = at most 1, by the bounds
lamp-small-faces-measure = point light at 2 circumradii, { $segments } × { $segments } faces: largest error
plate-effect = largest error of flat shading of a plate under a near point light
plate-cure = { $segments } × { $segments } smaller faces
holds-only-if =
    the light or the viewer is near. From 510 circumradii of a face on, the bound for diffuse light on plane faces is half an
    8-bit step; often the error is that small at shorter distances. Then one colour per face is visually exact.
note-1 =
    The error depends on the distance of the light over the size of the face, not of the object. Smaller faces therefore
    have the same effect as a more distant light. For small faces, the error falls as one over their number along a
    side. Shading at every pixel is exact here, because the normal of a plane face is known everywhere.
lamp-by = the formula at every pixel centre in double precision; tolerance: single precision
error-by-distance-title = Error of flat shading by distance
error-by-distance-caption =
    { $is-bounded ->
        [yes] Both errors are below their bounds, which fall as one over the distance.
       *[no]
            The error of diffuse light is below its bound, which falls as one over the distance. The error of the
            highlight has no bound for exponents below 1 or if the light is not in front.
    } The horizontal line with squares is half an 8-bit step.
error-by-distance-x = distance in circumradii of the face
error-by-distance-y = largest error
lamp-curve = diffuse light
viewer-curve = highlight
bound-diffuse-curve = bound, diffuse
bound-highlight-curve = bound, highlight
half-step-curve = half an 8-bit step
plate-title = plate, one face
plate-caption = A plate under a point light at two circumradii.
plate-seen = The whole plate has one grey.
plate-small-faces-title = plate, small faces
plate-small-faces-caption = The same plate divided into { $segments } × { $segments } squares.
plate-small-faces-seen = The plate is darker away from the light.
small-faces-effect = largest error of the light at a pixel
small-faces-cure = smaller faces
flat-title = flat, near light
flat-caption = A box with a point light near its corner.
flat-seen = Each side has one colour, so the picture does not show that the light is near.
every-pixel-title = every pixel, near light
every-pixel-caption =
    Shaded at every pixel, the sides are bright near the light and darker away from it. Only the angle of the light
    changes; there is no attenuation by distance.
flat-small-faces-title = flat, small faces
flat-small-faces-caption = Flat shading with each side divided into { $segments } × { $segments } squares.
flat-small-faces-seen = The sides are close to the exact shading.
flat-lamp-far-title = flat, distant light
flat-lamp-far-caption =
    The light is a hundred times as far away, without attenuation. All points of a side have nearly the same angle to
    it.
flat-lamp-far-seen = One colour per side is almost correct.
highlight-effect = largest error of the highlight with light at { $aside }°
highlight-title = highlight, one face
highlight-caption =
    A plate with only a Phong highlight (n = { $exponent }) of a distant light at { $aside }°, with the viewer at two
    circumradii.
highlight-seen = The whole plate has the grey of its middle; the highlight is not visible.
highlight-every-pixel-title = highlight, every pixel
highlight-every-pixel-caption = Shaded at every pixel: the direction to the viewer changes from point to point.
highlight-small-faces-title = highlight, small faces
highlight-small-faces-caption = Flat shading with { $segments } × { $segments } squares.
highlight-small-faces-seen = The highlight is at the right position, in steps.
highlight-cure = { small-faces-cure }
viewer-by = { lamp-by }
viewer-aside-by = { lamp-by }
lamp-small-faces-by = { lamp-by }
