title = Mach bands on a cylinder
claim = Mach bands are worse with Gouraud's shading than with Phong's.
source-1 = Lectures: Table 1, 1.6.13, 1.6.46, 1.6.50
source-2 = Against it: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979
formula-1 = {"ΔI_\\mathrm{flat} = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-1-says = the step between two flat facets whose common edge is at the angle θ; Δ = 2π/N
formula-2 = {"ΔI′_\\mathrm{Gouraud} = −\\cos(θ_L) [\\tan(θ + Δ/2) − \\tan(θ − Δ/2)]"}
formula-2-says = the jump of the slope across the picture at that edge
formula-3 = {"\\frac{ΔI′_\\mathrm{Phong}}{ΔI′_\\mathrm{Gouraud}} = \\frac{\\sin(θ − θ_L) \\sin(θ)}{\\cos(θ_L)}"}
formula-3-says = so Phong's is the larger one somewhere as soon as cos(θ_L) < 1/3: θ_L > 70.5288°
shown-by = light within 90° of the direction of view, and 8 to 32 segments, would show it.
name-largest-slope = { $name }: largest slope jump within 60° of the direction of view
measure-flat-largest-step = flat: largest step of luminance within 60° of the direction of view
by-sin-l-sin = 2 |sin(θ − θ_L)| sin(Δ/2); single precision
cos-l-tan = −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; roundings of the samples that a slope is taken of
sin-l-sin = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; as for Gouraud
by-same-smaller = the same with the smaller Δ
moved = largest slope jump within 60° of the direction of view
moved-largest-step-within = largest step within 60° of the direction of view
holds-only-if-no-edge-stands =
    no edge stands where it does not. The light is more than 70.5288° off the direction of view, so that Phong's slope
    jump would be the larger one at an edge halfway to the light; this cylinder has none there.
holds-only-if-largest-jumps-compared =
    the largest jumps are compared, as they are here. The light is more than 70.5288° off the direction of view, so that
    at some edges Phong's slope jump is the larger one already; a little farther off it is the largest of all.
holds-only-if-light-less-off =
    the light is less than 70.5288° off the direction of view, as it is here. Beyond that there are edges where Phong's
    slope jump is the larger one; at 90° Gouraud's shading of facets lit as a whole is exact, and only Phong's has
    bands.
fails-light-far-off =
    the light is so far off the direction of view that Phong's slope jumps are the larger ones, as they may be from
    70.5288° on.
slope-luminance-jumps =
    Where the slope of luminance jumps, the eye sees a dark line at the foot and a bright line at the knee, though no
    pixel there is darker or brighter than its neighbours on both sides. Flat shading jumps in luminance itself.
    Gouraud's and Phong's are continuous, but their slopes are not.
overshoot-called-predicted =
    The overshoot called predicted is that of a difference of Gaussians, a model of lateral inhibition. It says where
    bands may be seen and how they compare on one picture, not how strongly they are seen.
facets-meet-light =
    Facets meet where the light ends: there the cylinder itself has a band. Edges are measured where both of their
    facets are lit, up to 60° from the direction of view; farther round facets are seen from the side, and slopes across
    the picture grow without bound, those of the cylinder too.
jumps-first-order = Jumps are of first order in the width of a facet: four times the segments make them about a quarter.
why-luminance-facet-half = the luminance of a facet is then half a step of 8 bits off a round one
measure-light-slope-jump =
    light at 80°: slope jump of Phong over that of Gouraud at an edge turned to θ = 40° (a cylinder not shown)
measure-light-angle-beyond = the light's angle beyond which Phong has the larger jump
not-held-against = not held against sin(θ − θ_L) sin θ / cos θ_L: facets so wide are lit in part only
by-sin-l-sin-cos = sin(θ − θ_L) sin θ / cos θ_L; roundings of both jumps
by-arccos-found-halving = arccos(1/3), found by halving in pictures; the ratio grows by 7.4 % a degree there
gouraud-shading-same = Gouraud's shading of the same facets: luminance is continuous, its slope is not.
phong-shading-same = Phong's shading of the same facets: luminance is bent on each of them.
bands-stand-edges = Bands stand at the edges.
slopes-jump-less = Slopes jump less under this light than with the other shading.
flat-title = flat
flat-caption-flat-shading-facets =
    Flat shading of { $from } facets, the light { $value }° off the direction of view: one luminance for each facet.
flat-caption-each-stands-out = Each stands out as a stripe of one grey.
fine-caption-jumps-about-quarter = Jumps are about a quarter of what they were.
exact-title = the cylinder itself
exact-caption-cylinder-lit-every = The cylinder lit at every pixel with its own normal: no bands but where the light ends.
phong-80-jumps-title = The slope of Phong's luminance jumps more.
gouraud-80-jumps-title = Gouraud's shading has the smaller jumps here.
phong-80-title = Phong, light at 80°
phong-80-caption-light-off-direction =
    The light 80° off the direction of view, Phong's shading. Luminance bends within each facet; the jumps of its slope,
    which the map shows, are hardly seen.
gouraud-80-title = Gouraud, light at 80°
gouraud-80-caption-same-light-facets =
    The same light: where facets are lit as a whole, luminance is nearly linear across the picture.
shading-light-jumps = { $shading }, light at 80°: jumps of the slope
bars-edges-up =
    Bars at the edges up to 60° round whose facets are lit all over, as light as the slope jumps there: violet 0, yellow
    { $full }. What is not measured is left out.
light-flat-shading = Where there is light, flat shading has steps, Gouraud's is a polygon, Phong's is bent on each facet.
exact = exact
light-cylinder-luminance =
    The light at 80°: the cylinder's luminance is nearly straight where it is lit, and so is Gouraud's. Phong's is bent.
slope-facets-beside =
    The slope of that, on the facets beside the edges that are measured: Phong's goes up and down on each facet and
    jumps back at edges, by up to { $bad }; Gouraud's jumps by up to { $cured }.
light = light at 80°
slope-slope-slope =
    The slope of the slope: where the slope jumps there is a narrow spike, and the larger the jump the higher the spike.
luminance-along-scanline = Luminance along a scanline
linear-luminance-y = linear luminance Y
first-derivative = First derivative
dy-dx-per = dY/dx, per radius
second-derivative = Second derivative
d-y-dx = d²Y/dx², per radius²
axis-x-across-picture = x across the picture, in radii
by-i-s-c =
    ΔI′ (σ_s − σ_c)/√(2π) for a jump of slope, 0.111682 ΔI for a step; up to 11.6 % less where the edge lies between two
    pixels
untested-facets-narrow-model = facets are so narrow that the model sees two edges at once
axis-predicted-overshoot-luminance = predicted overshoot, in luminance
predicted-overshoot-slopes = Predicted overshoot: slopes
difference-gaussians-pixels =
    What a difference of two Gaussians (σ of 1 and 1.6 pixels, 67 pixels per degree) predicts: a line at each edge in
    the light, about as high as the slope jumps there. It is a model: the eye does not follow it in strength.
predicted-overshoot-steps = Predicted overshoot: steps
same-model-flat =
    The same model on flat shading: a bright and a dark line beside every step that there is. There the model is known
    to be wrong: the bands that it predicts beside steps are hardly seen (Kingdom 2014).
