# The labels of `crease inspect --explain`.

about = (severity: at most { $severity }; group: { $group }; counts { $counted })
to-do = What to do: { $advice }
fix = Fix: { $command }
no-command = no command; see above
list-end = `crease inspect --explain ID` explains one of them.

note = note
warning = warning
error = error

stored = stored normals
smoothing = smoothing
geometry = geometry
shading = shading risk

corner = corners
face = faces
edge = edges
vertex = vertices
node = nodes
mesh = meshes
