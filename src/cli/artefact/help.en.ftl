# The help of `crease artefact`.

about = Draw and measure the classic artefacts of shading

    Each experiment states what textbooks claim, draws it, measures it, and compares the numbers with a formula or an
    independent check. It reports whether the claim holds and under what conditions it fails. With -o it writes a page with all
    pictures; `all` adds an index. With `all`, an option changes the experiments that take it, and a note names these. If a
    measure differs from its expected value, the exit code is 1.
example-1 = crease artefact list
example-2 = crease artefact mach-bands --segments 24 --light 60 -o out
example-3 = crease artefact all -o gallery

experiment = Experiment by its id; `all` for every one, `list` to list them with their options
output = Folder for the page, pictures (PNG) and plots (SVG); created if necessary
lang = Language of pages, captions and tables
animate = GIF file for the animation of the experiment
frames = Frames of the animation
mesh = Mesh to run the experiment on, or `-` for standard input; `crease artefact list` shows what is measured on it
finer = Finer mesh of the same object at the same position, as the reference (`silhouette`)
format = Format of the meshes [default: by content, else by name]
size = Width and height of each picture in pixels, 32 to 1024
segments = Segments of a circle, or cells of a grid
light = Angle of the light, in most experiments from the view direction
turn = Angle of the rotation: of the polygon in `orientation`, of the view in `refraction`
intensity = Intensity of the light in `attenuation-and-overflow`
exponent = Exponent of the highlight
weight = Weight of faces in vertex normals
crease = Crease angle of the cure
interpolation = Interpolation in the animation of `orientation`; its pictures show all kinds

## What `-h` shows.

output-short = Folder for the page, pictures (PNG) and plots (SVG)
lang-short = Language of pages, captions and tables
animate-short = GIF file for the animation of the experiment
mesh-short = Mesh to run the experiment on, or `-` for standard input
size-short = Width and height of each picture in pixels, 32 to 1024
segments-short = Segments of a circle, or cells of a grid
light-short = Angle of the light, in most experiments from the view direction
turn-short = Angle of the rotation (`orientation`, `refraction`)
intensity-short = Intensity of the light (`attenuation-and-overflow`)
exponent-short = Exponent of the highlight
weight-short = Weight of faces in vertex normals
crease-short = Crease angle of the cure
