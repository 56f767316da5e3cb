# The help of `crease trade`.

about = Measure accuracy against speed

    Without an input: the error of every weight against surfaces whose normals are known, of encodings of normals and of kinds of
    shading, with the cost of each; about a minute and a half. Errors are the same in every run. Times depend on the machine. With
    a mesh: the errors of the weights on it, what they cost, and which one to use. The true normals of a mesh are estimated by
    fits, together with the error of these, unless `--truth stored` takes them from the file.
example-1 = crease trade --quick
example-2 = crease trade -o trade
example-3 = crease trade part.stl --crease 30 -o part-trade

input = User mesh, or `-` for standard input
output = Folder for an HTML page with plots and pictures, and for its plots as SVG; created if necessary
quick = Measure less, in some seconds
full = Measure more: finer meshes and larger pictures, in some minutes
markdown = Print the main tables as Markdown
crease = Crease angle of the input in degrees; `off` for none [default: 40 without smoothing groups]
truth = Normals that errors are measured from [default: estimated]

## What `-h` shows.

output-short = Folder for an HTML page with plots and pictures
quick-short = Measure less, in some seconds
full-short = Measure more
markdown-short = Print the main tables as Markdown
crease-short = Crease angle of the input in degrees [default: 40 without smoothing groups]
