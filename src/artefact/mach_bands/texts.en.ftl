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
gouraud-jump-measure = Gouraud: largest slope jump within 60° of the direction of view
flat-step-measure = flat: largest step of luminance within 60° of the direction of view
flat-step-by = 2 |sin(θ − θ_L)| sin(Δ/2); single precision
gouraud-jump-by = −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; roundings of the samples that a slope is taken of
phong-jump-by = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; as for Gouraud
fine-jump-by = the same with the smaller Δ
shading-effect = largest slope jump within 60° of the direction of view
flat-effect = largest step within 60° of the direction of view
fails =
    the light is so far off the direction of view that Phong's slope jumps are the larger ones, as they may be from
    70.5288° on.
note-1 =
    Where the slope of luminance jumps, the eye sees a dark line at the foot and a bright line at the knee, though no
    pixel there is darker or brighter than its neighbours on both sides. Flat shading jumps in luminance itself.
    Gouraud's and Phong's are continuous, but their slopes are not.
note-2 =
    The overshoot called predicted is that of a difference of Gaussians, a model of lateral inhibition. It says where
    bands may be seen and how they compare on one picture, not how strongly they are seen.
note-3 =
    Facets meet where the light ends: there the cylinder itself has a band. Edges are measured where both of their
    facets are lit, up to 60° from the direction of view; farther round facets are seen from the side, and slopes across
    the picture grow without bound, those of the cylinder too.
note-4 = Jumps are of first order in the width of a facet: four times the segments make them about a quarter.
why-slope = the luminance of a facet is then half a step of 8 bits off a round one
grazing-ratio-measure =
    light at 80°: slope jump of Phong over that of Gouraud at an edge turned to θ = 40° (a cylinder not shown)
border-angle-measure = the light's angle beyond which Phong has the larger jump
facets-lit-in-part = not held against sin(θ − θ_L) sin θ / cos θ_L: facets so wide are lit in part only
grazing-ratio-by = sin(θ − θ_L) sin θ / cos θ_L; roundings of both jumps
border-angle-by = arccos(1/3), found by halving in pictures; the ratio grows by 7.4 % a degree there
gouraud-caption = Gouraud's shading of the same facets: luminance is continuous, its slope is not.
phong-caption = Phong's shading of the same facets: luminance is bent on each of them.
flat-title = flat
flat-caption =
    Flat shading of { $segments } facets, the light { $light }° off the direction of view: one luminance for each facet.
flat-seen = Each stands out as a stripe of one grey.
fine-seen = Jumps are about a quarter of what they were.
exact-title = the cylinder itself
exact-caption = The cylinder lit at every pixel with its own normal: no bands but where the light ends.
phong-80-jumps-seen = The slope of Phong's luminance jumps more.
gouraud-80-jumps-seen = Gouraud's shading has the smaller jumps here.
phong-80-title = Phong, light at 80°
phong-80-caption =
    The light 80° off the direction of view, Phong's shading. Luminance bends within each facet; the jumps of its slope,
    which the map shows, are hardly seen.
gouraud-80-title = Gouraud, light at 80°
gouraud-80-caption =
    The same light: where facets are lit as a whole, luminance is nearly linear across the picture.
phong-80-jumps-caption =
    Bars at the edges up to 60° round whose facets are lit all over, as light as the slope jumps there: violet 0, yellow
    { $full }. What is not measured is left out.
luminance-caption = Where there is light, flat shading has steps, Gouraud's is a polygon, Phong's is bent on each facet.
exact-curve = exact
luminance-80-caption =
    The light at 80°: the cylinder's luminance is nearly straight where it is lit, and so is Gouraud's. Phong's is bent.
slope-80-caption =
    The slope of that, on the facets next to the edges that are measured: Phong's goes up and down on each facet and
    jumps back at edges, by up to { $bad }; Gouraud's jumps by up to { $cured }.
curvature-caption =
    The slope of the slope: where the slope jumps there is a narrow spike, and the larger the jump the higher the spike.
luminance-title = Luminance along a scanline
luminance-y = linear luminance Y
slope-title = First derivative
slope-y = dY/dx, per radius
curvature-title = Second derivative
curvature-y = d²Y/dx², per radius²
luminance-x = x across the picture, in radii
overshoot-flat-by =
    ΔI′ (σ_s − σ_c)/√(2π) for a jump of slope, 0.111682 ΔI for a step; up to 11.6 % less where the edge lies between two
    pixels
narrow-facets = facets are so narrow that the model sees two edges at once
predicted-y = predicted overshoot, in luminance
predicted-title = Predicted overshoot: slopes
predicted-caption =
    What a difference of two Gaussians (σ of 1 and 1.6 pixels, 67 pixels per degree) predicts: a line at each edge in
    the light, about as high as the slope jumps there. It is a model: the eye does not follow it in strength.
predicted-flat-title = Predicted overshoot: steps
predicted-flat-caption =
    The same model on flat shading: a bright and a dark line along every step. There the model is known
    to be wrong: the bands that it predicts along steps are hardly visible (Kingdom 2014).
phong-jump-measure = Phong: largest slope jump within 60° of the direction of view
fine-jump-measure = { $worse } with { $finer } segments: slope jump at the same edge
finer-effect = { $worse }'s slope jump at the edge, within 60° of the direction of view, where it is largest
finer-cure = { $factor } times the segments, at the same edge
shading-cure = the other shading
holds-only-if =
    the largest slope jump of each shading decides, as here. With the light more than 70.5288° off the direction of view
    there may be edges where Phong's slope jump is the larger one; at 90° Gouraud's shading of facets lit as a whole is
    exact, and only Phong's has bands.
gouraud-title = Gouraud
phong-title = Phong
gouraud-curve = Gouraud
phong-curve = Phong
flat-curve = { flat-title }
fine-title = { $worse }, { $finer } segments
fine-caption = { $worse }'s shading with { $factor } times the segments.
phong-80-jumps-title = Phong, light at 80°: jumps of the slope
gouraud-80-jumps-title = Gouraud, light at 80°: jumps of the slope
gouraud-80-jumps-caption = { phong-80-jumps-caption }
slope-caption =
    The slope of luminance: Gouraud's is constant on each facet that is lit as a whole. { $worse }'s jumps at edges by
    up to { $bad }, { $better }'s by up to { $cured }.
slope-x = { luminance-x }
curvature-x = { luminance-x }
luminance-80-title = { luminance-title }, light at 80°
luminance-80-x = { luminance-x }
luminance-80-y = { luminance-y }
slope-80-title = { slope-title }, light at 80°
slope-80-x = { luminance-x }
slope-80-y = { slope-y }
curvature-80-title = { curvature-title }, light at 80°
curvature-80-caption = { curvature-caption }
curvature-80-x = { luminance-x }
curvature-80-y = { curvature-y }
predicted-x = { luminance-x }
predicted-flat-x = { luminance-x }
predicted-flat-y = { predicted-y }
overshoot-flat-measure = flat: predicted overshoot (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-measure = Gouraud: predicted overshoot (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-phong-measure = Phong: predicted overshoot (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-fine-measure =
    Gouraud, { $finer } segments: predicted overshoot (DoG, σ { $centre } px, { $surround } px; { $density } px/°)
overshoot-gouraud-by = { overshoot-flat-by }
overshoot-phong-by = { overshoot-flat-by }
overshoot-fine-by = { overshoot-flat-by }
