# The help of `crease render`.

about = Draw a mesh or a scene

    A mesh is framed automatically, lit by a key light and drawn with the normals that `crease normals` would write. A scene (TOML
    or glTF) has its own camera, lights and settings; options override them.
example-1 = crease render gear.obj --shading flat --overlay wire,creases -o gear.png
example-2 = crease render ball.glb --compare flat,gouraud,phong -o panels.png
example-3 = crease render scene.toml --camera 'eye=3,2,5 target=0,0,0 angle=40' -o scene.png

input = Mesh, glTF file, scene in TOML, or `-` for a mesh from standard input
output = Output picture: PNG, JPEG, WebP or GIF by its name, or `-` for standard output
out-dir = Folder for the pictures of a manifest. The folders of the inputs' paths are kept
to = Format of the picture [default: by its name, else png]
root = Further folder from which companion files (meshes of a scene, MTL, glTF buffers) may be read; the only one for standard
    input [default: the input's folder]
force = Omit faces with positions that are infinite or not a number, instead of refusing the file
size = Width and height in pixels, each up to 16384; with --compare those of each panel [default: 640x480]
samples = Samples per pixel, each shaded separately; 4, 8 and 16 are the patterns of Direct3D [default: 4; for scenes in TOML
    their own value, or 1]
bits = Bits of each component [default: 8]
compare = Draw panels side by side that differ in shading or interpolation, as --compare flat,gouraud,phong,exact or --compare
    scanline,affine,perspective; with --shading only interpolations, with --interpolation only shadings
turntable = Draw an animation of N frames: one rotation about the upright axis; camera and lights stay. Needs a GIF output
probe = Print the numbers behind a pixel, from 0 at the upper left: the visible face, N, L, V, R, H and every term. Objects,
    faces, vertices and lights count from 0
shading = Points at which colours are computed [default: phong]
interpolation = Interpolation of values over a face [default: perspective]
reflection = Highlight model, or the stored vertex colours without light [default: blinn]
exponent = Exponent of the highlight, 0 or more: a larger exponent gives a smaller highlight [default: the material's, or 32]
flat-sample = Point at which flat faces are lit [default: centroid]
show = Draw normals, facing, depth, face-id or deviation in place of light, with a legend below. `normals`: (n + 1)/2; `facing`:
    front light blue, back dark red; `depth`: white near, black far; `face-id`: a colour for each face. `deviation[=DEG]`: the
    angle between the interpolated normal and that of the analytic surface, or of the face if there is none. Its colours run from
    black through red and yellow to white at the given angle, or else at an angle that no visible deviation exceeds
no-legend = Omit the legend of --show, which adds to the height of the picture
overlay = Draw lines over the picture
hidden-lines = Treatment of lines behind surfaces [default: remove]
cull = Omit faces by their visible side; wireframes omit their edges, overlays keep all lines [default: none]
two-sided = Light back faces on the visible side
camera = Camera; an invalid one of a glTF file is then ignored [default: frames the mesh, 30° from top to bottom]
light = Light, in place of all lights of the scene except ambient light; repeatable
scene-help = Print the keys of scene files and exit
ambient = Ambient light, in place of that of the scene
material = Material of all objects
background = Background: a colour, black, white, `transparent` (PNG and WebP) or `gradient` (grey, darker towards the bottom);
    the wireframe of a mesh is black on a bright one [default: light grey; for scenes in TOML their own colour, or black]
up = Up axis of the mesh, for the automatic camera [default: y]
rotate = Rotate the objects about the centre of their bounding box, in degrees: about x, then y, then z; camera and lights
    stay
weight = Weight of each face at a corner [default: angle]
crease = Crease angle in degrees; `off` for none [default: 40 without smoothing groups]
when = Stored normals to replace [default: always; normals of a scene file only if --weight, --crease or --when is used]
guard = Switch one guard on or off: highlight, diffuse, spot, renormalise, underflow; repeatable. A guard keeps the result of
    a formula in range; textbooks usually omit it
literal = Switch all guards off, except those that --guard switches on
terminator = Treatment, in Phong shading, of faces that point away from the light while their interpolated normals point towards
    it [default: smooth]
tone = Treatment of colours above 1 [default: clamp]
transfer = Transfer from linear light to codes [default: srgb; for --show normals and depth, direct]

## What `-h` shows.

output-short = Output picture (PNG, JPEG, WebP, GIF), or `-` for standard output
size-short = Width and height in pixels, each up to 16384 [default: 640x480]
samples-short = Samples per pixel, each shaded separately [default: 4]
compare-short = Draw panels side by side that differ in shading or interpolation
turntable-short = Draw an animation of N frames
probe-short = Print the numbers behind a pixel, from 0 at the upper left
shading-short = Points at which colours are computed [default: phong]
interpolation-short = Interpolation of values over a face [default: perspective]
show-short = Draw normals, facing, depth, face-id or deviation in place of light
overlay-short = Draw lines over the picture
scene-help-short = Print the keys of scene files and exit
camera-short = Camera [default: frames the mesh, 30° from top to bottom]
light-short = Light, in place of all lights of the scene except ambient light
material-short = Material of all objects
weight-short = Weight of each face at a corner [default: angle]
crease-short = Crease angle in degrees [default: 40 without smoothing groups]
when-short = Stored normals to replace [default: always]
