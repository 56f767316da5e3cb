# The help of `crease normals`.

about = Compute normals and write them

    Everything else in a file stays unchanged, byte for byte if input and output have the same format.
example-1 = crease normals gear.obj --crease 40 -o gear.glb
example-2 = crease normals scan.ply --crease off --weight quadric -o smooth.ply
example-3 = crease normals models --recursive --out-dir out --json > report.jsonl

output = Output file, or `-` for standard output (one input only); folders are created if necessary
out-dir = Output folder, created if necessary; files of an input folder keep their relative paths
in-place = Replace each input
to = Format of the output [default: by name, else that of the input]
dry-run = Do everything except writing outputs and the journal
sync = Wait until each output is on the disk
emit = Kind of normals to write
weight = Weight of each face at a corner
crease = Crease angle in degrees: edges with a larger dihedral angle stay sharp; `off` for none. The test adds 0.01° (or a
    tenth of DEG, if that is less), so that chamfers at exactly DEG stay smooth. If the file has smoothing groups, the angle
    applies in addition to them only if it is given here [default: 40 without smoothing groups]
crease-rule = Effect of sharp edges
groups = Use of smoothing groups of OBJ files
hard-edges = Further edges to keep sharp; repeatable
when = Stored normals to replace
weld = Coincident edges to smooth across: those with equal positions, none, or those closer than a fraction of the bounding
    box's diagonal. Vertices are not merged
merge = Vertices to merge in the output. Default: in a new file, those of meshes without shared vertices (STL, glTF without
    indices, PLY with three vertices a face) that agree in all attributes. `exact`: all that agree in all attributes, also when
    a glTF is edited. A fraction of the bounding box's diagonal also moves each vertex to the first within that distance, and
    needs another format than that of the input. `off`: none
slivers = Use of slivers: faces with a height below the rounding of their coordinates
precision = Precision of the computation
up = Up axis of the file that is not glTF: z for most CAD files. A new glTF is rotated so that this axis becomes y; a new file
    from glTF is rotated back. Normals keep their bits
scale = Unit of the file that is not glTF (mm, cm, m, in), converted to or from metres; or a factor that multiplies coordinates
    of a new file
degenerate = Treatment of faces without area
flip = Reverse every face, and its normals with it
orient = Reverse faces so that neighbours agree; `outward` also makes components face outward. Stored normals that --when keeps stay unchanged
confidence = Minimum confidence for --orient outward to reverse an open component, whose outer side is found by counting
    escaping rays: from 0.5 to 1; 1 reverses none
force = Drop faces whose positions are infinite or not a number, instead of refusing the file
tangents = Treatment of tangents when normals change
material = Material of faces without one in a new glTF
normal-format = Storage of normals in glTF; other formats have no choice, and a warning says so
compress = Compression of a GLB. Files that meshopt or Draco compressed are read, and written without compression by default

## What `-h` shows.

output-short = Output file, or `-` for standard output (one input only)
out-dir-short = Output folder, created if necessary
in-place-short = Replace each input
to-short = Format of the output [default: by name, else that of the input]
recursive-short = Include all mesh files in folders and below, except hidden ones
dry-run-short = Do everything except writing
weight-short = Weight of each face at a corner
crease-short = Crease angle in degrees [default: 40 without smoothing groups]
hard-edges-short = Further edges to keep sharp
when-short = Stored normals to replace
emit-short = Kind of normals to write
orient-short = Reverse faces so that neighbours agree
degenerate-short = Treatment of faces without area
