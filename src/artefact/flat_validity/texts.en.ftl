title = When flat shading is right
claim =
    Flat shading takes light and viewer to be infinitely far away. It is not realistic even for faceted objects: towards
    a near lamp, and for highlights towards a near viewer, the direction changes from point to point of a facet.
source-1 = Lectures: 1.5.1, 1.6.12, 1.6.45
formula-1 = {"|ΔI_d| ≤ 2 k_d \\sin(ε/2), \\quad \\sin(ε) = \\frac{r}{D}"}
formula-1-says = the error of diffuse light on a face of circumradius r, with the light at the distance D from its middle
formula-2 = {"|ΔI_s| ≤ k_s M(n) ε, \\quad M(n) = \\sqrt{n} \\left(1 − \\frac{1}{n}\\right)^{(n − 1)/2}"}
formula-2-says = the error of Phong's highlight with the viewer at the distance D; M is the steepest slope of cosⁿ
shown-by = light within 90° of the face, and more faces in the cured picture, would show it.
measure-lamp-ratio-circumradii = lamp at { $ratio } circumradii: largest error of diffuse light
measure-viewer-ratio-circumradii = viewer at { $ratio } circumradii: largest error of the highlight
untested-light-along-plate = light along the plate: which side it is on is a matter of rounding
measure-viewer-ratios-circumradii =
    viewer at { $ratios-0 } circumradii, light { $value }° to the side: largest error of the highlight
measure-largest-error-over = largest error over its bound
by-bounds-hold = the bounds hold
measure-lamp-circumradii-segments = lamp at 2 circumradii, { $segments } × { $segments } faces: largest error
moved = largest error of flat shading of a plate under the near lamp
cure = { $segments } × { $segments } smaller faces
holds-only-if-light-or-viewer =
    light or viewer are near. From 510 circumradii of a face on, flat shading of plane faces under diffuse light is
    right to half a step of 8 bits by its bound, often sooner: then one colour a face is all there is to see.
note-counts-light-distance =
    What counts is the light's distance over the size of the face, not of the object: cutting faces smaller cures as
    moving the lamp away does, the error falling in the end as one over their number along a side. Shading every pixel
    costs nothing in accuracy here: on a plane face the normal is known everywhere.
formula-light-every = the formula of light at every pixel's centre in double precision; single precision
chart-title = Error of flat shading by distance
chart-caption =
    Both errors stay below their bounds, which fall as one over the distance. The level line with squares is half a step
    of 8 bits.
chart-caption-error-diffuse-light =
    The error of diffuse light stays below its bound, which falls as one over the distance; that of the highlight is
    held against none for exponents below 1 and where light does not come from the front. The level line with squares is
    half a step of 8 bits.
axis-distance-circumradii-face = distance in circumradii of the face
axis-largest-error = largest error
lamp-diffuse = lamp, diffuse
viewer-highlight = viewer, highlight
bound-diffuse = bound, diffuse
bound-highlight = bound, highlight
half-step-bits = half a step of 8 bits
plate-title = plate, one face
plate-caption-plate-under-lamp = A plate under a lamp at two circumradii.
plate-caption-all-grey = All of it has one grey.
plate-small-faces-title = plate, small faces
plate-small-faces-caption-same-plate-cut = The same plate cut into { $segments } × { $segments } squares.
plate-small-faces-caption-light-falls-off = The light falls off away from the lamp.
moved-largest-error-pixel = largest error of a pixel's light
cure-smaller-faces = smaller faces
flat-title = flat, lamp near
flat-caption-lamp-stands-near = A lamp stands near the corner of the box.
flat-caption-but-each-side = But each side has one colour: nothing tells that the lamp is near.
every-pixel-title = every pixel, lamp near
every-pixel-caption-lit-every-pixel =
    Lit at every pixel, the sides are bright near the lamp and fade away from it, by the angle of the light alone:
    distance takes nothing here.
flat-small-faces-title = flat, small faces
flat-small-faces-caption-same-flat-shading = The same flat shading with each side cut into { $segments } × { $segments } squares.
flat-small-faces-caption-closer-truth = Closer to the truth.
flat-lamp-far-title = flat, lamp far
flat-lamp-far-caption-lamp-moved-hundred =
    The lamp moved a hundred times as far away, without fading: all points of a side see it at the same slant.
flat-lamp-far-caption-now-colour-side = Now one colour a side is almost right.
moved-largest-error-highlight = largest error of the highlight of light { $value }° to the side
highlight-title = highlight, one face
highlight-caption-plate-nothing-but =
    A plate with nothing but a highlight (Phong's, n = { $exponent }) of a far light { $value }° to the side, the viewer
    at two circumradii.
highlight-caption-grey-middle-no = One grey, that of the middle: there is no highlight in its place.
highlight-every-pixel-title = highlight, every pixel
highlight-every-pixel-caption-lit-every-pixel = Lit at every pixel: the direction to the viewer changes from point to point.
highlight-small-faces-title = highlight, small faces
highlight-small-faces-caption-flat-shading-segments = Flat shading of { $segments } × { $segments } squares.
highlight-small-faces-caption-highlight-place-steps = The highlight is in its place, in steps.
