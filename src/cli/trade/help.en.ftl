# The help of `crease trade`.

about = Measure accuracy against speed

    Without an input: the error of every weight against surfaces whose normals are known, of encodings of normals and of kinds of
    shading, with the cost of each; about a minute and a half. Errors are the same in every run. Times depend on the machine. With
    a mesh: how the weights differ on it, what they cost, and which one to use.
example-1 = crease trade --quick
example-2 = crease trade -o trade
example-3 = crease trade part.stl --crease 30 -o part-trade

input = User mesh, or `-` for standard input
output = Folder for an HTML page with plots and pictures, and for its plots as SVG; created if necessary
quick = Measure less, in some seconds
full = Measure more: finer meshes and larger pictures, in some minutes
markdown = Print the main tables as Markdown
crease = Crease angle of the input in degrees; `off` for none [default: 40 without smoothing groups]

## What `-h` shows.

output-short = Folder for an HTML page with plots and pictures
quick-short = Measure less, in some seconds
full-short = Measure more
markdown-short = Print the main tables as Markdown
crease-short = Crease angle of the input in degrees [default: 40 without smoothing groups]
