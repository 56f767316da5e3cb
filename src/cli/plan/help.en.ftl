# The help of `crease plan`.

about = Find the cheapest model that a scene requires

    The plan draws like the scene, within a tolerance, with the cheapest shading, normals, storage, lights and tessellation. The
    search is exact, except where docs/plan.md states a limit: no cheaper combination is within the tolerance. The planned scene
    is an ordinary scene file with the reason at each change.
example-1 = crease plan scene.toml -o planned.toml
example-2 = crease plan scene.toml --tolerance 1 --views 12 --json
example-3 = crease plan statue.glb --views 26 --tolerance 1 --apply statue-lean.glb

input = Scene file, or a mesh or glTF file
output = Planned scene file, or `-` for standard output
tolerance = Largest difference by the metric [default: 2 steps of 1/255 before rounding, or a mean ꟻLIP of 0.01]
metric = Comparison of pictures
reference = Scene that the pictures are compared with
share = Share of the covered pixels that may be beyond the tolerance [default: 0]
outline = Largest distance of outlines, in pixels [default: 0.5]
apply = Planned glTF file, .glb or .gltf. For a scene: a folder for its glTF files and the planned scene. Only axes that files hold may
    change: weight, creases, precision and storage, in which `none` means flat faces. A file is compared with what its standard
    says: stored normals, and flat faces without any
minimise = Quantity to minimise [default: work; bytes with --apply]
views = Number of views around the scene, in place of its camera; as many others verify the plan
size = Size of the pictures [default: that of the scene]
keep = Axes that stay as declared
only = The only axes that may change
light-cone = Angle by which all lights rotate around the scene, in degrees; the tolerance holds for rotations by this angle and half of it
allow = Further change that is allowed
seconds = Maximum time; then the search ends with the best plan so far, which depends on the machine
budget = Maximum number of pixels to draw; then the search ends with the best plan so far
html = HTML page with the pictures, the reason for each decision, and the steps that were refused
picture = PNG with the reference, the plan and their difference next to each other
lang = Language of page and picture
explain = Print how costs and bounds are computed

## What `-h` shows.

output-short = Planned scene file, or `-` for standard output
tolerance-short = Largest difference of a pixel, in steps of 1/255
metric-short = Comparison of pictures
apply-short = Planned glTF file; for a scene, a folder
minimise-short = Quantity to minimise [default: work; bytes with --apply]
html-short = HTML page of the plan
views-short = Number of views around the scene
size-short = Size of the pictures
keep-short = Axes that stay as declared
only-short = The only axes that may change
