# The help of `crease inspect`.

about = Report what is wrong with a mesh's normals, why, where, and how visible it is

    crease searches for the weight and the crease angle that reproduce the stored normals best, and compares the normals with
    these. Each finding has a stable id, a severity, a cause and its worst positions. An error is wrong in any picture, a warning
    is visible in some pictures, and a note may be intended. One command fixes the errors and warnings that can be fixed
    together, and the report lists which these are.
example-1 = crease inspect part.glb --html report.html
example-2 = crease inspect models --recursive --json --fail-on error
example-3 = crease inspect --explain faceted

against = Compare with this file of the same shape: by how many degrees the normals changed, how visible that is, and which
    findings were added or removed. Faces are matched by the positions of their corners, so order, splits and triangulation do not
    matter. `-` is standard input (one input only). --fail-on judges the input, not this file
html = File for a page with pictures, histograms and explanations; `-` is standard output, and the report then goes to
    standard error
heatmap = PNG file for the findings on the lit mesh, or `-` for standard output. Each error and warning has a colour, which
    deepens with the angle. The picture has a legend, and a ring around the worst position of each
heatmap-of = Content of the heat map: one finding by its id, `deviation` (angle between stored normals and those of the
    estimated recipe), or a weight (angle between stored normals and those of that weight) [default: errors and warnings]
view = View direction of the pictures
fail-on = Exit with code 1 if a reported finding has at least this severity. If a file of a batch cannot be read, the exit
    code is 5
severity = Report only findings of at least this severity, and count the others; --fail-on ignores the others [default: note in
    JSON, warning in text without -v]
ignore = Omit these findings; repeatable
only = Report only these findings; repeatable
places = Positions to report for each finding, worst first [default: 10 in JSON, 1 as text, 10 with -v]
explain = Explain findings by id or symptom (faceted, dark, seam, inside out), or all, and exit
lang = Language of --explain, --html and --heatmap [default: en]
deviation = Maximum angle between a stored normal and the one computed with the estimated recipe, in degrees [default: 15]
past-face = Maximum angle of a stored normal beyond 90° from its face, in degrees [default: 5]
rotation = Maximum common rotation of all stored normals, in degrees [default: 5]
quantisation = Maximum quantisation error of stored normals, in degrees [default: 0.05]
past-crease = Maximum dihedral angle of an edge with one normal on both sides beyond the crease angle, in degrees [default:
    10]
seam = Maximum angle between the normals on both sides of a smooth edge, in degrees [default: 2]
tangent = Maximum deviation of a tangent from perpendicular to its normal, in degrees [default: 5]
length = Maximum deviation of the length of a normal from 1 [default: 0.00674]
strict-length = Tolerance of the length below which no note is given [default: 0.001]
planarity = Maximum angle between a polygon and the planes at its corners, in degrees [default: 10]
weld = Distance below which two open edges count as one, as a fraction of the bounding box's diagonal [default: 1e-6]
needle = Ratio of width to length below which a face counts as long and thin; for a triangle, height over longest
    edge [default: 0.001]
fold = Edges with a larger dihedral angle count as folded, in degrees [default: 170]
rounding = Maximum error of face normals from rounding positions to 32 bits, in degrees [default: 0.5]
confidence = Minimum confidence needed to decide which side of an open surface is outside, from 0.5 to 1 [default: 0.9]
valence = Maximum number of faces at a vertex [default: 48]
exponent = Specular exponent (Blinn) of the highlight that each face must show [default: its material's, or 32]
band = Change of slope at an edge that is visible as a Mach band, in 8-bit steps a pixel [default: 0.1]
terminator = Maximum angle between a normal and its face before shadows break up, in degrees [default: 20]
outline = Maximum deviation of an outline from its curve, in pixels [default: 1]
size = Width of the mesh on the screen for outlines and bands, in pixels [default: 512]

## What `-h` shows.

recursive-short = Include all mesh files in folders and below, except hidden ones
against-short = Compare with this file of the same shape
html-short = File for a page with pictures, histograms and explanations
heatmap-short = PNG file for the findings on the lit mesh
heatmap-of-short = Content of the heat map: a finding, `deviation` or a weight [default: errors and warnings]
view-short = View direction of the pictures
severity-short = Report only findings of at least this severity [default: note in JSON, warning in text without -v]
fail-on-short = Exit with code 1 if a reported finding has at least this severity
only-short = Report only these findings
ignore-short = Omit these findings
explain-short = Explain findings by id or symptom (faceted, dark, seam, inside out)
deviation-short = Maximum angle between a stored normal and the one computed with the estimated recipe [default: 15]
seam-short = Maximum angle between the normals on both sides of a smooth edge [default: 2]
past-crease-short = Maximum dihedral angle of an edge with one normal on both sides beyond the crease angle [default: 10]
