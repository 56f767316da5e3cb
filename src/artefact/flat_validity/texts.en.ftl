title = When flat shading is right
claim =
    Flat shading takes light and viewer to be infinitely far away. It is not realistic even for faceted objects: towards
    a near lamp, and for highlights towards a near viewer, the direction changes from point to point of a facet.
source-1 = Lectures: 1.5.1, 1.6.12, 1.6.45
formula-1 = {"|ΔI_d| ≤ 2 k_d \\sin(ε/2), \\quad \\sin(ε) = \\frac{r}{D}"}
formula-1-says =
    the error of diffuse light on a face of circumradius r, with the light at the distance D from its middle
formula-2 = {"|ΔI_s| ≤ k_s M(n) ε, \\quad M(n) = \\sqrt{n} \\left(1 − \\frac{1}{n}\\right)^{(n − 1)/2}"}
formula-2-says = the error of Phong's highlight with the viewer at the distance D; M is the steepest slope of cosⁿ
shown-by = light within 90° of the face, and more faces in the cured picture, would show it.
lamp-measure = lamp at { $ratio } circumradii: largest error of diffuse light
viewer-measure = viewer at { $ratio } circumradii: largest error of the highlight
light-along-plate = light along the plate: which side it is on is a matter of rounding
viewer-aside-measure =
    viewer at { $ratio } circumradii, light { $aside }° to the side: largest error of the highlight
share-of-bound-measure = largest error over its bound
share-of-bound-by = the bounds hold
lamp-small-faces-measure = lamp at 2 circumradii, { $segments } × { $segments } faces: largest error
plate-effect = largest error of flat shading of a plate under the near lamp
plate-cure = { $segments } × { $segments } smaller faces
holds-only-if =
    light or viewer are near. From 510 circumradii of a face on, flat shading of plane faces under diffuse light is
    right to half a step of 8 bits by its bound, often sooner: then one colour a face is all there is to see.
note-1 =
    What counts is the light's distance over the size of the face, not of the object: cutting faces smaller cures as
    moving the lamp away does, the error falling in the end as one over their number along a side. Shading every pixel
    costs nothing in accuracy here: on a plane face the normal is known everywhere.
lamp-by = the formula of light at every pixel's centre in double precision; single precision
error-by-distance-title = Error of flat shading by distance
error-by-distance-caption =
    { $is-bounded ->
        [yes] Both errors stay below their bounds, which fall as one over the distance.
       *[no]
            The error of diffuse light stays below its bound, which falls as one over the distance; that of the
            highlight has none for exponents below 1 and where light does not come from the front.
    } The level line with squares is half a step of 8 bits.
error-by-distance-x = distance in circumradii of the face
error-by-distance-y = largest error
lamp-curve = lamp, diffuse
viewer-curve = viewer, highlight
bound-diffuse-curve = bound, diffuse
bound-highlight-curve = bound, highlight
half-step-curve = half a step of 8 bits
plate-title = plate, one face
plate-caption = A plate under a lamp at two circumradii.
plate-seen = All of it has one grey.
plate-small-faces-title = plate, small faces
plate-small-faces-caption = The same plate cut into { $segments } × { $segments } squares.
plate-small-faces-seen = The light falls off away from the lamp.
small-faces-effect = largest error of a pixel's light
small-faces-cure = smaller faces
flat-title = flat, lamp near
flat-caption = A lamp stands near the corner of the box.
flat-seen = But each side has one colour: nothing shows that the lamp is near.
every-pixel-title = every pixel, lamp near
every-pixel-caption =
    Lit at every pixel, the sides are bright near the lamp and fade away from it, by the angle of the light alone:
    distance takes nothing here.
flat-small-faces-title = flat, small faces
flat-small-faces-caption = The same flat shading with each side cut into { $segments } × { $segments } squares.
flat-small-faces-seen = Closer to the truth.
flat-lamp-far-title = flat, lamp far
flat-lamp-far-caption =
    The lamp moved a hundred times as far away, without fading: all points of a side see it at the same slant.
flat-lamp-far-seen = Now one colour a side is almost right.
highlight-effect = largest error of the highlight of light { $aside }° to the side
highlight-title = highlight, one face
highlight-caption =
    A plate with nothing but a highlight (Phong's, n = { $exponent }) of a far light { $aside }° to the side, the viewer
    at two circumradii.
highlight-seen = One grey, that of the middle: there is no highlight in its place.
highlight-every-pixel-title = highlight, every pixel
highlight-every-pixel-caption = Lit at every pixel: the direction to the viewer changes from point to point.
highlight-small-faces-title = highlight, small faces
highlight-small-faces-caption = Flat shading of { $segments } × { $segments } squares.
highlight-small-faces-seen = The highlight is in its place, in steps.
highlight-cure = { small-faces-cure }
viewer-by = { lamp-by }
viewer-aside-by = { lamp-by }
lamp-small-faces-by = { lamp-by }
