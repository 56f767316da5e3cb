# The page of a plan.

title = { $scene } needs { $share } of its { $quantity }
title-unchanged = { $scene } needs everything that it declares
lead =
    The planned scene costs { $after } in place of { $before }. No pixel of an object differs by more than { $worst } (tolerance
    { $tolerance }).
lead-none-found = No cheaper model was found before the search ended.
lead-unchanged = No cheaper model is within the tolerance of { $tolerance }.
unproven =
    The search ended before all cheaper models were tried. No plan costs less than { $proven }: a cheaper plan saves at most { $gap }
    more.
contents = Contents
pictures = Pictures
pictures-caption = The view with the largest difference: { $worst } (tolerance { $tolerance }).
worst-place = The largest difference is seen from the eye { $eye } towards { $target }.
held-out-place = Of the views that the plan was not found with, the worst is seen from the eye { $eye } towards { $target }.
turned = The lights are rotated by { $angle } around the axis { $axis }.
shot-reference = Reference
shot-planned = Plan
shot-step = With the cheaper step
shot-difference-plain = Difference
shot-difference = Difference, amplified { $factor } times
decisions = Decisions
decisions-none-found = No cheaper model was found before the search ended.
decisions-none = Each cheaper value is beyond the tolerance.
decisions-caption = What the plan changes
column-what = object or light
column-axis = axis
column-change = change
column-saves = saves
column-difference = largest difference alone
column-bound = bound
none = none
refused = Refused steps
refused-none = There is no cheaper step from the plan.
refused-lead =
    Each of these steps would make the plan cheaper. The pictures show the surroundings of the pixel that differs most,
    magnified.
refused-title = { $what }: { $axis } { $from } → { $to }
refused-caption =
    Saves { $saved }, but pixel { $pixel } of view { $view } differs by { $difference } (tolerance { $tolerance }).
refused-outline = Saves { $saved }, but the outline moves by { $outline } in view { $view }.
tried = All that was tried
tried-caption =
    Models of single objects with all else as planned, and whole plans. A refused model may differ by more than the error that is
    shown: its comparison ends at the first large one. The declared scene has no error and is drawn at the lower end.
costs = Costs
costs-caption = Costs before and after
column-cost = cost
column-declared = declared
column-planned = planned
column-share = planned of declared
reproduce = Reproduce

sheet-reference = reference: { $cost }
sheet-plan = plan: { $cost }
sheet-difference = { $difference }, shown × { $factor }

plot-title = Error against cost
plot-description =
    { $tried ->
        [one] One model was tried.
       *[other] { $tried } models were tried.
    } The plan costs { $cost }, the declared scene { $declared }.
plot-frontier = Pareto frontier
plot-tolerance = tolerance
plot-refused = refused
plot-within = within the tolerance
plot-declared = declared
plot-planned = plan
plot-work = operations
plot-bytes = bytes
plot-vertices = vertices
plot-steps = largest difference, steps of 1/255
plot-flip = mean ꟻLIP

steps = { $value } steps of 255
flip = ꟻLIP { $value }
operations = { $value } operations
bytes = { $value } bytes
vertices = { $value } vertices
light = light { $number }
object = object { $number }
picture = picture

axis-shading = shading
axis-weight = weight
axis-creases = creases
axis-precision = precision
axis-storage = storage
axis-merging = merging
axis-interpolation = interpolation
axis-reflection = reflection
axis-tessellation = tessellation
axis-two-sided = two-sided
axis-lights = light
axis-antialiasing = samples

value-as-declared = as declared
value-none = none
value-kept = kept
value-given = given
value-on = on
value-off = off
value-exact = exact
value-flat = flat
value-gouraud = Gouraud
value-phong = Phong
value-perspective = perspective
value-affine = affine
value-diffuse = diffuse
value-ambient = ambient
value-omitted = omitted
value-constant = constant
value-attenuated = attenuated
value-directional = directional
value-point = point
value-spot = spot
value-rectangle = rectangle
value-disc = disc

because-shading =
    { $what } is lit by { $to } shading in place of { $from } shading: its normals vary so little between the corners of a face
    that colours differ by { $difference } at most.
because-weight = { $what }: averaging by { $to } in place of { $from } changes colours by { $difference }.
because-weight-angle =
    { $what }: averaging by { $to } in place of { $from } rotates normals by at most { $angle }, which changes colours by { $difference }.
because-creases = The hard edges of { $what } are not visible here: one normal for each vertex changes colours by { $difference }.
because-creases-angle =
    { $what }: one normal for each vertex rotates normals by up to { $angle } at hard edges, but visible colours change by only { $difference }.
because-precision = { $what }: single precision changes colours by { $difference }.
because-precision-angle = { $what }: single precision rotates normals by at most { $angle }, which changes colours by { $difference }.
because-storage = { $what }: normals stored as { $to } change colours by { $difference }.
because-storage-angle = { $what }: normals stored as { $to } are off by at most { $angle }, which changes colours by { $difference }.
because-merging =
    Vertices of { $what } at equal positions with equal normals are stored once. Each corner keeps its values, so colours change by
    { $difference }.
because-interpolation =
    Within the faces of { $what } perspective hardly matters: { $to } interpolation changes colours by { $difference }.
because-reflection = The reflection of { $what } is { $to }: the omitted or replaced terms change colours by { $difference }.
because-tessellation = { $what } has { $to } cells in place of { $from }: colours change by { $difference }.
because-two-sided = { $what } is lit on one side: its visible rear faces differ by { $difference } at most.
because-lights = { $what } is { $to } in place of { $from }: colours change by { $difference }.
because-lights-radii =
    { $what } is { $radii } radii of the scene away: as { $to } light its direction is off by at most { $angle }, and colours
    change by { $difference }.
because-antialiasing = { $to } samples of a pixel in place of { $from } change colours by { $difference } within objects.
