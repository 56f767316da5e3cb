title = Inverse-square light exceeds the range of the screen
claim =
    Light attenuated by 1/d² changes too much near a point light and too little far from it; 1/(d + k) looks better.
    Colour components above 1 are clamped, or the colour is divided by its largest component.
source-1 = Lectures: 1.3.1.7, 1.6.6, 1.6.11, 1.6.17, 1.6.26, 1.6.41
formula-1 = {"I(ρ) = \\frac{I_0 h}{\\sqrt{h^2 + ρ^2}} f(\\sqrt{h^2 + ρ^2})"}
formula-1-says = diffuse light on a floor at the distance ρ from the point below a point light at the height h
formula-2 = {"ρ^2 < (I_0 h)^{2/3} − h^2"}
formula-2-says = region where f = 1/d² makes I more than 1; with f = 1/(d + k), I is at most I₀/(h + k)
formula-3 = {"\\frac{I_1}{I_2} = \\frac{d_2 + k}{d_1 + k}"}
formula-3-says = depth cueing: luminance ratio of the same surface at two distances from the viewer
shown-by = Use a larger picture (--size) or a brighter light (--intensity 1.5) to show it.
inverse-square-title = inverse square: 1/d²
quadratic-title = quadratic: 1/(1 + d + d²)
offset-title = offset: 1/(d + k)
share-inverse-square-measure = 1/d²: share of the floor brighter than 1
share-inverse-square-by = π [(I₀h)^(2/3) − h²] over the area of the window; tolerance: half a pixel along the border
share-offset-measure = 1/(d + k): share of the floor brighter than 1
share-offset-by =
    π (ρ² − h²) over the area of the window, with ρ (ρ + k) = I₀h; none if I₀/(h + k) ≤ 1. Tolerance: half a pixel along
    the border
contrast-inverse-square-measure = 1/d²: luminance below the light over luminance at the edge of the floor
contrast-offset-measure = 1/(d + k): luminance below the light over luminance at the edge of the floor
clamped-measure = clamped: green over red below the light
clamped-by = the light at this pixel centre, each component clamped to 1; tolerance: the 8-bit step at this colour
divided-measure = divided by the largest component: green over red below the light
exercise-clamped-measure = exercise 1.6.17: red after clamping
exercise-clamped-by = the value in the lectures, [0.9, 1, 0.3]
exercise-divided-measure = exercise 1.6.17: red after division
exercise-divided-by = 0.9/1.1; the lectures print 0.818
depth-cue-measure = depth cueing: luminance of the nearest plate over that of the farthest
depth-cue-by =
    (d₂ + k)/(d₁ + k), with d the distance to a pixel centre in the middle of each plate; tolerance: edges snap to 1/256
    pixel
peak-measure = 1/d²: largest luminance
overflow-effect = share of the floor brighter than 1
why-half-pixel = half a pixel
overflow-cure = 1/(d + k) with k = 1
hue-effect = difference of green over red below the light from the ratio of the light's colour, { $hue }
why-hue = a visible difference of hue
depth-cue-effect = difference of the luminance ratio of nearest and farthest plate from the formula, { $law }
why-plate = a tenth of the luminance of a plate
holds-only-if =
    colours are displayed as computed. The law 1/d² follows from geometry for a small light source, not from the
    atmosphere as the lectures state; its values exceed the range of the screen. 1/(d + k) with k ≥ I₀ − h stays within
    that range, but it is not the law of any real light source.
fails =
    k = { $k } is less than I₀ − h = { $least }: below the light, 1/(d + k) exceeds the range of the screen too. Any law of
    light that is not limited does, for a light that is bright enough.
inverse-square-caption = A floor below a point light of intensity I₀ = { $intensity } at the height h = { $height }.
inverse-square-seen =
    Below the light there is a white disc with a hard edge, where luminance exceeds 1. The floor is dark farther away.
quadratic-caption = Attenuation with a constant, a linear and a quadratic term.
quadratic-seen = There is no disc, and the floor is still dark far away.
offset-caption = The same light with 1/(d + k), k = { $k }.
offset-seen = There is no disc, and the floor is visible up to its corners.
clamped-title = orange light, clamped
clamped-caption = An orange point light with clamped components.
clamped-seen = Red and green are both clamped to 1: towards the middle the colour becomes yellow, then white.
divided-title = orange light, divided
divided-caption = Each colour above 1 is divided by its largest component.
divided-seen =
    The hue is correct everywhere. Only brightness is lost: the result is a flat disc as large as the white one under
    1/d².
no-depth-cue-title = without depth cueing
no-depth-cue-caption =
    Three plates at different distances. Farther plates are larger, so all have the same size in the picture.
no-depth-cue-seen = All plates look the same; their distances are not visible.
depth-cue-title = depth cueing
depth-cue-caption = Luminance divided by the distance to the viewer plus k.
depth-cue-seen = The near plate is bright and the far plate is dark.
note-1 =
    Under 1/d² light quadruples when the distance halves. Light that is suitable far away exceeds the white of the
    screen close to the light source, and is clamped there. A constant added to d keeps light below white and makes it
    fall more slowly far away. Clamping a coloured light acts on each channel, so the hue moves towards white.
note-2 =
    The lectures use the letter d for two distances: to the light in attenuation, and to the viewer in depth cueing.
contrast-inverse-square-by =
    the formula at these pixel centres; tolerance: positions in single precision, 100 units from the viewer
white-curve = white of the screen
light-on-the-floor-title = Light on the floor
light-on-the-floor-caption =
    Luminance against the distance from the point below the light. There 1/d² is { $overflow } times the white of the
    screen. It falls below 1/(d + k) at ρ = { $crossing }.
light-on-the-floor-x = distance from the point below the light
light-on-the-floor-y = luminance
contrast-offset-by = { contrast-inverse-square-by }
divided-by = the ratio of the light's colour; tolerance: the 8-bit step at this colour
hue-cure = colours divided by their largest component
depth-cue-cure = { depth-cue-title }
inverse-square-curve = { inverse-square-title }
quadratic-curve = { quadratic-title }
offset-curve = { offset-title }
