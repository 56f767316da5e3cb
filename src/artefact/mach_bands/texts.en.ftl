title = Gouraud shading has stronger Mach bands in frontal light
claim = Mach bands are stronger with Gouraud shading than with Phong shading.
source-1 = Lectures: Table 1, 1.6.13, 1.6.46, 1.6.50
source-2 = Counter-example: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979
formula-1 = {"ΔI_\\mathrm{flat} = 2 |\\sin(θ − θ_L)| \\sin(Δ/2)"}
formula-1-says = luminance step between two flat facets; their common edge is at the angle θ, and Δ = 2π/N
formula-2 = {"ΔI′_\\mathrm{Gouraud} = −\\cos(θ_L) [\\tan(θ + Δ/2) − \\tan(θ − Δ/2)]"}
formula-2-says = jump of the luminance slope across the picture at that edge
formula-3 = {"\\frac{ΔI′_\\mathrm{Phong}}{ΔI′_\\mathrm{Gouraud}} = \\frac{\\sin(θ − θ_L) \\sin(θ)}{\\cos(θ_L)}"}
formula-3-says = the jump of Phong shading is larger at some edge if cos(θ_L) < 1/3, that is θ_L > 70.5288°
shown-by = Use light within 90° of the view direction and 8 to 32 segments to show it.
gouraud-jump-measure = Gouraud: largest slope jump within 60° of the view direction
flat-step-measure = flat: largest luminance step within 60° of the view direction
flat-step-by = 2 |sin(θ − θ_L)| sin(Δ/2); tolerance: single precision
gouraud-jump-by = −cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; tolerance: rounding of the samples that determine the slope
phong-jump-by = −sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; tolerance: as for Gouraud
fine-jump-by = the same formula with the smaller Δ
shading-effect = largest slope jump within 60° of the view direction
flat-effect = largest luminance step within 60° of the view direction
fails =
    the light is so far from the view direction that Phong shading has the larger slope jumps. This is possible above
    70.5288°.
note-1 =
    Where the slope of luminance jumps, the eye sees a Mach band: a dark line at the lower end of a ramp, a bright line
    at the upper end. No pixel there is darker or brighter than its neighbours on both sides. Flat shading has jumps of
    luminance itself. Gouraud and Phong shading are continuous, but their slopes are not.
note-2 =
    The predicted overshoot is that of a difference of Gaussians, a model of lateral inhibition. The model predicts
    where bands can be visible and how they compare within one picture. It does not predict how strong they look.
note-3 =
    The exact cylinder has a band too: where the light ends. Edges are measured where both facets are lit, up to 60°
    from the view direction. Beyond 60°, facets are seen at grazing angles, and slopes across the picture grow without
    bound, for the exact cylinder too.
note-4 =
    Slope jumps are of first order in the width of a facet. Four times as many segments reduce them to about a quarter.
why-slope = a jump at which the luminance on a facet is half an 8-bit step from a smooth curve
grazing-ratio-measure =
    light at 80°: slope jump of Phong over that of Gouraud, at an edge rotated to θ = 40° (cylinder not shown)
border-angle-measure = angle of the light above which Phong has the larger slope jump
halfway-difference-measure = edge half-way between viewer and light: slope jump of Phong minus that of Gouraud (cylinder not shown)
halfway-difference-by =
    (sin²(θ_L/2) − |cos θ_L|) [tan(θ + Δ/2) − tan(θ − Δ/2)] with θ = θ_L/2, zero at 70.53°; tolerance: rounding of both
    jumps
facets-lit-in-part = not compared with sin(θ − θ_L) sin θ / cos θ_L: facets this wide are only partly lit
grazing-ratio-by = sin(θ − θ_L) sin θ / cos θ_L; tolerance: rounding of both jumps
border-angle-by = arccos(1/3), found by bisection in pictures; the ratio grows by 7.4 % per degree there
gouraud-caption = Gouraud shading of the same facets: luminance is continuous, its slope is not.
phong-caption = Phong shading of the same facets: luminance is curved on each facet.
flat-title = flat
flat-caption =
    Flat shading of { $segments } facets, with the light { $light }° from the view direction. Each facet has one
    luminance.
    In these pictures, luminance { $white } is white, and { $dark } or less is black.
flat-seen = Each facet is visible as a stripe of one grey.
fine-seen = The slope jumps are about a quarter as large.
exact-title = exact, black { $dark }, white { $white }
exact-caption = The cylinder with its exact normal at every pixel: the only band is where the light ends.
phong-80-jumps-seen = Phong shading has the larger slope jumps here.
gouraud-80-jumps-seen = Gouraud shading has the smaller slope jumps here.
phong-80-title = Phong, light at 80°
phong-80-caption =
    Phong shading with the light 80° from the view direction. Luminance is curved within each facet. Its slope jumps are
    hardly visible; the map shows them.
gouraud-80-title = Gouraud, light at 80°
gouraud-80-caption =
    The same light with Gouraud shading: on fully lit facets, luminance is nearly linear across the picture.
phong-80-jumps-caption =
    A bar marks each edge within 60° whose facets are fully lit. Its colour is the slope jump: violet 0, yellow
    { $full }. Regions that are not measured are omitted.
luminance-caption =
    Luminance under flat shading has steps. Under Gouraud shading it is a polyline. Under Phong shading it is curved on
    each facet.
exact-curve = exact
luminance-80-caption =
    With the light at 80°, the luminance of the lit part of the cylinder is nearly linear. Gouraud shading is nearly
    linear too. Phong shading is curved.
slope-80-caption =
    The slope of luminance on the facets next to the measured edges. Under Phong shading it rises and falls on each
    facet and jumps at edges by up to { $bad }. Under Gouraud shading it jumps by up to { $cured }.
curvature-caption = The slope of the slope. Each slope jump appears as a narrow peak; a larger jump has a higher peak.
luminance-title = Luminance along a scanline
luminance-y = linear luminance Y
slope-title = First derivative
slope-y = dY/dx, per radius
curvature-title = Second derivative
curvature-y = d²Y/dx², per radius²
luminance-x = x across the picture, in radii
overshoot-flat-by =
    ΔI′ (σ_s − σ_c)/√(2π) for a jump of slope, 0.111682 ΔI for a step; tolerance: up to 11.6 % less if the edge lies
    between two pixels
narrow-facets = not compared: facets are so narrow that the model responds to two edges at once
predicted-y = predicted overshoot, in luminance
predicted-title = Predicted overshoot: slopes
predicted-caption =
    Prediction of a difference of two Gaussians (σ of 1 and 1.6 pixels, 67 pixels per degree). There is a line at each
    lit edge, about as high as the slope jump. This is a model: the visible strength of bands differs from it.
predicted-flat-title = Predicted overshoot: steps
predicted-flat-caption =
    The same model applied to flat shading predicts a bright and a dark line next to each step. For steps the model is
    known to be wrong: these bands are hardly visible (Kingdom 2014).
phong-jump-measure = Phong: largest slope jump within 60° of the view direction
fine-jump-measure = { $worse } with { $finer } segments: slope jump at the same edge
finer-effect = { $worse }: slope jump at the edge within 60° of the view direction where it is largest
finer-cure = { $factor } times as many segments, at the same edge
shading-cure = the other shading
holds-only-if =
    the largest slope jump of each shading is compared, as here. If the light is more than 70.5288° from the view
    direction, Phong shading can have the larger slope jump at some edges. At 90° Gouraud shading of fully lit facets is
    exact, and only Phong shading has bands.
gouraud-title = Gouraud
phong-title = Phong
gouraud-curve = Gouraud
phong-curve = Phong
flat-curve = { flat-title }
fine-title = { $worse }, { $finer } segments
fine-caption = { $worse } shading with { $factor } times as many segments.
phong-80-jumps-title = Phong, light at 80°: slope jumps
gouraud-80-jumps-title = Gouraud, light at 80°: slope jumps
gouraud-80-jumps-caption = { phong-80-jumps-caption }
slope-caption =
    The slope of luminance. Under Gouraud shading it is constant on each fully lit facet. It jumps at edges, by up to
    { $bad } under { $worse } shading and by up to { $cured } under { $better } shading.
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
