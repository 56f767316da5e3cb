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
inverse-square-d = inverse square: 1/d²
quadratic-d-d = quadratic: 1/(1 + d + d²)
offset-d-k = offset: 1/(d + k)
measure-d-share-floor = 1/d²: share of the floor that overflows
by-i-h-h = π [(I₀h)^(2/3) − h²] over the window; half a pixel along the border
measure-d-k-share = 1/(d + k): share of the floor that overflows
by-i-h-k = I₀/(h + k) ≤ 1: none, but for rounding in single precision
measure-d-light-below = 1/d²: light below the lamp over that at the floor's edge
measure-d-k-light = 1/(d + k): light below the lamp over that at the floor's edge
measure-clamped-green-over = clamped: green over red below the lamp
by-both-cut = both are cut at 1
measure-divided-largest-green = divided by the largest: green over red below the lamp
measure-exercise-red-after = exercise 1.6.17: red after clamping
by-lectures = the lectures' [0.9, 1, 0.3]
measure-exercise-red-after-division = exercise 1.6.17: red after division
by-printed = 0.9/1.1, printed as 0.818
measure-depth-cueing-nearest = depth cueing: nearest plate over farthest plate
by-d-k-d = (d₂ + k)/(d₁ + k), d the distance to the pixel's centre in the middle of each plate; edges snap to 1/256 pixel
measure-d-largest-luminance = 1/d²: largest luminance
moved = share of the floor that overflows
why-half-pixel = half of one pixel
cure = 1/(d + k) with k = 1
moved-how-far-green = how far green over red below the lamp is from the lamp's own { $r }
why-hue-seen-differ = a hue that is seen to differ
moved-how-far-light = how far light of the nearest plate over that of the farthest is from the law's { $by-depth }
why-tenth-plate-light = a tenth of a plate's light
holds-only-if-colours-shown-they =
    colours are shown as they are computed. 1/d² is what geometry says of a small lamp (not the atmosphere, as the
    lectures have it); what fails is the range of the screen. 1/(d + k) with k ≥ I₀ − h fits into it, at the price of
    being no lamp's law.
inverse-square-title = A floor under a lamp of strength I₀ = { $strength } at the height h = { $height }.
inverse-square-caption-white-disc-hard =
    There is a white disc with a hard rim below the lamp, where light is more than 1, and darkness soon after.
quadratic-title = Constant, linear and quadratic term together.
quadratic-caption-no-disc-still = No disc, and still dark far away.
offset-title = The same lamp, k = { $k }.
offset-caption-no-disc-floor = No disc, and the floor can be seen to its corners.
clamped-title = warm lamp, clamped
clamped-caption-orange-lamp = An orange lamp.
clamped-caption-red-green-both = Its red and green are both cut at 1: towards the middle it turns yellow and then white.
divided-title = warm lamp, divided
divided-caption-divided-largest-component = Divided by the largest component.
divided-caption-hue-lamp-everywhere =
    The hue is the lamp's everywhere. Only brightness is lost: a flat disc is left, as large as the white one under
    1/d².
no-depth-cue-title = without depth cueing
no-depth-cue-caption-three-plates-different =
    Three plates at different distances, the farther the larger, so that all have one size here.
no-depth-cue-caption-all-alike-nearest = All are alike: which is the nearest?
depth-cue-title = depth cueing
depth-cue-caption-divided-distance-viewer = Divided by the distance to the viewer plus k.
depth-cue-caption-near-plate-bright = The near plate is bright and the far one is dark.
note-under-d-light =
    Under 1/d² light quadruples with each halving of the distance: what is just right far away is beyond the screen's
    white close by, and is cut off there. A term added to d keeps light below white at the lamp, and falls more slowly
    far away. Where a coloured light is cut off, it is cut off channel by channel, and its hue moves towards white.
note-lectures-use-letter =
    The lectures use the letter d twice: for the distance to the lamp in attenuation, and to the viewer in depth cueing.
formula-centres-these = the formula at the centres of these pixels; positions in single precision from a viewer 100 units away
curve-screen-can-show = what a screen can show
chart-title = Light on the floor
chart-caption =
    Luminance against the distance from the point below the lamp: 1/d² is { $strength } times what a screen shows there,
    and falls below 1/(d + k) at ρ = { $value }.
axis-distance = distance ρ
axis-luminance = luminance
