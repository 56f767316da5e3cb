laboratory = The artefact laboratory
lead =
    Claims of textbooks about the artefacts of shading, tested: each with pictures, measured numbers next to their closed
    forms, and the conditions under which it fails.
contents = Contents
all = All experiments
claim = The claim
no-formulas = The closed forms of this experiment are of its own shapes; without --mesh it shows them.
verdict = Verdict
holds = It holds
holds-only-if = It holds only if
fails = It fails
absent = Not put to the test here
pictures = Pictures
effect = Effect of the cure
measured = Measured
numbers = Every quantity, with its expected value where that is known
plots = Plots
explained = Explanation
reproduce = Reproduce
command = One command draws and measures all of this again; each picture is a file of its own, named below it:
column-quantity = quantity
column-measured = measured
column-expected = expected
column-within = within
column-agrees = agrees
column-by = by
yes = yes
no = NO
nothing = –
column-experiment = experiment
column-title = title
column-options = options
column-own-mesh = measured on your mesh (--mesh)
experiments = Experiments
role-bad = artefact
role-cured = cured
role-attempt = attempted cure
role-absent = no artefact measured
role-difference = difference
role-truth = truth
role-seen = as it looks
gone = gone
gone-but-for-rounding = gone, but for rounding
times-less = { $times } times less
effect-absent =
    Measured is the { $name }: { $bad }, which is no artefact, for there is one above { $from } ({ $why }). With the cure
    ({ $cure }) it is { $cured }.
effect-present =
    Measured is the { $name }: { $bad } with the artefact, { $cured } after the cure ({ $cure }): { $less }. There is an
    artefact above { $from } ({ $why }); the cure has to bring it below that, or to make it at least { $factor } times
    smaller.
absent-below-threshold = { $name } is { $bad }, and above { $from } it would be visible ({ $why }); { $shown-by }
absent-in-pictures = with these parameters the pictures do not show it ({ $name }: { $bad }); { $shown-by }
shown-in = { $said } These pictures show something of it nevertheless: { $labels }.
cure-fails =
    { $condition } The cure fails here ({ $cure }): { $name } goes from { $bad } to { $cured }, { $less } where it has to be
    { $factor }.
near = { $value } ± { $tolerance }
at-most = at most { $value }
miss = { $name }: measured { $found }, expected { $wanted } ({ $by })
