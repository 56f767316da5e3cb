laboratory = Shading artefacts: claims and measurements
lead =
    Each page tests a textbook claim about a shading artefact. It shows pictures, measured numbers with their expected
    values, and the conditions under which the claim fails.
contents = Contents
all = All experiments
claim = Claim
no-formulas = The closed forms of this experiment apply to its own shapes. Run it without --mesh to see them.
verdict = Verdict
holds = The claim holds
holds-only-if = The claim holds only if
fails = The claim fails
absent = Not tested here
pictures = Pictures
effect = Effect of the cure
measured = Measurements
numbers = All measured quantities and their expected values
plots = Plots
explained = Explanation
reproduce = Reproduce
command =
    This command repeats the measurements and draws the pictures again. Each picture is a separate file; its name is in
    the caption:
live =
    In the laboratory, which runs in a browser, the parameters of this experiment are sliders: open
    `{ $link }`. `bash bindings/web/build` in the repository makes this file.
column-quantity = quantity
column-measured = measured
column-expected = expected
column-within = tolerance
column-agrees = agrees
column-by = basis of the expected value
yes = yes
no = NO
nothing = –
column-experiment = experiment
column-title = title
column-options = options
column-own-mesh = measured on a user mesh (--mesh)
experiments = Experiments
role-bad = artefact
role-cured = cured
role-attempt = attempted cure
role-absent = no artefact measured
role-difference = difference
role-truth = reference
role-seen = faint artefact
gone = gone
gone-but-for-rounding = gone, except for rounding
times-less = { $times } times smaller
effect-absent =
    Measured quantity, { $name }: { $bad }. An artefact is visible above { $from } ({ $why }), so there is none here.
    With the cure ({ $cure }) the quantity is { $cured }.
effect-present =
    Measured quantity, { $name }: { $bad } with the artefact, { $cured } after the cure ({ $cure }): { $less }. The
    artefact is visible above { $from } ({ $why }). The cure must bring the quantity below this threshold or make it at
    least { $factor } times smaller.
absent-below-threshold =
    the artefact is not visible ({ $name } is { $bad }; threshold { $from }, { $why }). { $shown-by }
absent-in-pictures = the pictures do not show the artefact with these parameters ({ $name }: { $bad }). { $shown-by }
shown-in = { $said } These pictures still show it in part: { $labels }.
cure-fails =
    { $condition } The cure fails here ({ $cure }): { $name } changes from { $bad } to { $cured }. This is { $less }; at
    least { $factor } times smaller is required.
near = { $value } ± { $tolerance }
at-most = at most { $value }
miss = { $name }: measured { $found }, expected { $wanted } ({ $by })
