# The help of `crease trade`.

about = Measure accuracy against speed

    Without an input, crease measures the error and the cost of every weight on surfaces with known normals. It also measures
    encodings of normals and kinds of shading. This takes about a minute and a half. Errors are the same in every run; times
    depend on the machine. With a mesh, it measures the errors and costs of the weights on that mesh, and recommends one. The true
    normals of a mesh are estimated by fits, together with the error of these fits, unless `--truth stored` reads them from the
    file.
example-1 = crease trade --quick
example-2 = crease trade -o trade
example-3 = crease trade part.stl --crease 30 -o part-trade

input = User mesh, or `-` for standard input
output = Folder for an HTML page with plots and pictures, and for its plots as SVG; created if necessary
quick = Measure less, in a few seconds
full = Measure more: finer meshes and larger pictures, in several minutes
markdown = Print the main tables as Markdown
crease = Crease angle of the input in degrees; `off` for none [default: 40 without smoothing groups]
truth = Normals that errors are measured from [default: estimated]

## What `-h` shows.

output-short = Folder for an HTML page with plots and pictures
quick-short = Measure less, in a few seconds
full-short = Measure more
markdown-short = Print the main tables as Markdown
crease-short = Crease angle of the input in degrees [default: 40 without smoothing groups]
