title = Attenuation and overflow
claim =
    Light that falls as one over the square of the distance changes too much near a lamp and too little far from it;
    1/(d + k) does better. Colours beyond 1 are clamped, or divided by their largest component.
source-1 = Lectures: 1.3.1.7, 1.6.6, 1.6.11, 1.6.17, 1.6.26, 1.6.41
formula-1 = {"I(ρ) = \\frac{I_0 h}{\\sqrt{h^2 + ρ^2}} f(\\sqrt{h^2 + ρ^2})"}
formula-1-says = diffuse light on a floor at the distance ρ from the point below a lamp at the height h
formula-2 = {"ρ^2 < (I_0 h)^{2/3} − h^2"}
formula-2-says = where f = 1/d² makes it more than 1; with f = 1/(d + k) it is I₀/(h + k) at most
formula-3 = {"\\frac{I_1}{I_2} = \\frac{d_2 + k}{d_1 + k}"}
formula-3-says = depth cueing: the same surface at two distances from the viewer
shown-by = a larger picture would show it.
inverse-square-title = inverse square: 1/d²
quadratic-title = quadratic: 1/(1 + d + d²)
offset-title = offset: 1/(d + k)
share-inverse-square-measure = 1/d²: share of the floor that overflows
share-inverse-square-by = π [(I₀h)^(2/3) − h²] over the window; half a pixel along the border
share-offset-measure = 1/(d + k): share of the floor that overflows
share-offset-by = I₀/(h + k) ≤ 1: none, but for rounding in single precision
contrast-inverse-square-measure = 1/d²: light below the lamp over that at the floor's edge
contrast-offset-measure = 1/(d + k): light below the lamp over that at the floor's edge
clamped-measure = clamped: green over red below the lamp
clamped-by = both are cut at 1
divided-measure = divided by the largest: green over red below the lamp
exercise-clamped-measure = exercise 1.6.17: red after clamping
exercise-clamped-by = the lectures' [0.9, 1, 0.3]
exercise-divided-measure = exercise 1.6.17: red after division
exercise-divided-by = 0.9/1.1, printed as 0.818
depth-cue-measure = depth cueing: nearest plate over farthest plate
depth-cue-by =
    (d₂ + k)/(d₁ + k), d the distance to the pixel's centre in the middle of each plate; edges snap to 1/256 pixel
peak-measure = 1/d²: largest luminance
overflow-effect = share of the floor that overflows
why-half-pixel = half of one pixel
overflow-cure = 1/(d + k) with k = 1
hue-effect = how far green over red below the lamp is from the lamp's own { $hue }
why-hue = a hue that is seen to differ
depth-cue-effect = how far light of the nearest plate over that of the farthest is from the law's { $law }
why-plate = a tenth of a plate's light
holds-only-if =
    colours are shown as they are computed. 1/d² is what geometry says of a small lamp (not the atmosphere, as the
    lectures have it); what fails is the range of the screen. 1/(d + k) with k ≥ I₀ − h fits into it, at the price of
    being no lamp's law.
inverse-square-caption = A floor under a lamp of strength I₀ = { $strength } at the height h = { $height }.
inverse-square-seen =
    There is a white disc with a hard rim below the lamp, where light is more than 1, and darkness soon after.
quadratic-caption = Constant, linear and quadratic term together.
quadratic-seen = No disc, and still dark far away.
offset-caption = The same lamp, k = { $k }.
offset-seen = No disc, and the floor can be seen to its corners.
clamped-title = warm lamp, clamped
clamped-caption = An orange lamp.
clamped-seen = Its red and green are both cut at 1: towards the middle it turns yellow and then white.
divided-title = warm lamp, divided
divided-caption = Divided by the largest component.
divided-seen =
    The hue is the lamp's everywhere. Only brightness is lost: a flat disc is left, as large as the white one under
    1/d².
no-depth-cue-title = without depth cueing
no-depth-cue-caption =
    Three plates at different distances, the farther the larger, so that all have one size here.
no-depth-cue-seen = All are alike: which is the nearest?
depth-cue-title = depth cueing
depth-cue-caption = Divided by the distance to the viewer plus k.
depth-cue-seen = The near plate is bright and the far one is dark.
note-1 =
    Under 1/d² light quadruples with each halving of the distance: what is just right far away is beyond the screen's
    white close by, and is cut off there. A term added to d keeps light below white at the lamp, and falls more slowly
    far away. Where a coloured light is cut off, it is cut off channel by channel, and its hue moves towards white.
note-2 =
    The lectures use the letter d twice: for the distance to the lamp in attenuation, and to the viewer in depth cueing.
contrast-inverse-square-by =
    the formula at the centres of these pixels; positions in single precision from a viewer 100 units away
white-curve = what a screen can show
light-on-the-floor-title = Light on the floor
light-on-the-floor-caption =
    Luminance against the distance from the point below the lamp: 1/d² is { $overflow } times what a screen shows there,
    and falls below 1/(d + k) at ρ = { $crossing }.
light-on-the-floor-x = distance ρ
light-on-the-floor-y = luminance
contrast-offset-by = { contrast-inverse-square-by }
divided-by = the step of 8 bits at this colour
hue-cure = colours divided by their largest component
depth-cue-cure = { depth-cue-title }
inverse-square-curve = { inverse-square-title }
quadratic-curve = { quadratic-title }
offset-curve = { offset-title }
