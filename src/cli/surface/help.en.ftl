# The help of `crease surface`.

about = Write an analytic surface as a mesh with its exact normals

    Positions lie on the surface to the last digits of a double. Normals are those of the surface, not of the mesh. OBJ and PLY
    store positions as doubles, PLY also normals. OBJ and glTF store normals in single precision, with an error of up to 3e-6
    degrees. STL stores facet normals instead. The axis of surfaces of revolution is y; planes, waves and saddles lie in x and y
    and face +z.
example-1 = crease surface torus --segments 64x32 --jitter 0.5 -o torus.ply
example-2 = crease surface sphere --pattern icosphere --level 4 -o sphere.glb
example-3 = crease surface teapot --segments 16 --uv -o teapot.obj

kind = Surface by its name
output = Output file, or `-` for standard output; folders are created if necessary
to = Format of the output [default: by name]
sync = Wait until the output is on the disk
radius = Radius of a sphere, a cylinder, or the base of a cone [default: 1]
height = Height of a cylinder or a cone [default: 2], or a catenoid [default: 1.5]
major = Torus: distance from the axis to the middle of the tube [default: 1]
minor = Torus: radius of the tube [default: 0.4]
waist = Catenoid: smallest radius [default: 0.5]
size = Plane, wave or saddle: width and, for the plane, height [default: 2]
semi-axes = Semi-axes along x, y and z of an ellipsoid [default: 1,0.6,0.4] or a superquadric [default: 1,1,1]
roundness = Superquadric: exponents from north to south and from east to west; 0.1 is a box, 1 an ellipsoid, 1.9 an
    octahedron [default: 0.5,0.5]
scale = Stretch the surface, by one factor or along each axis; a negative one mirrors
offset = Move the surface, after scaling
pattern = Arrangement of vertices and faces
segments = Cells in both directions, of each patch for the teapot [default: 64x32; bezier 32x32; teapot 8x8]
ratio = Ratio of cells: stretched [default: 10], slivers [default: 1000]
level = Subdivisions of an icosphere [default: 3]
jitter = Random displacement of vertices within the surface, in cells, from 0 to 1. Cells are then cut along a random diagonal
noise = Random displacement of vertices along the normal, in mean edge lengths, from 0 to 1. Normals stay
seed = Seed of the random numbers
uv = Write the parameters as texture coordinates, which splits vertices at seams in most formats

## What `-h` shows.

output-short = Output file, or `-` for standard output
to-short = Format of the output [default: by name]
radius-short = Radius of a sphere, a cylinder, or the base of a cone [default: 1]
height-short = Height of a cylinder or a cone
size-short = Plane, wave or saddle [default: 2]
semi-axes-short = Semi-axes along x, y and z of an ellipsoid
scale-short = Stretch the surface, by one factor or along each axis
offset-short = Move the surface, after scaling
pattern-short = Arrangement of vertices and faces
segments-short = Cells in both directions [default: 64x32]
level-short = Subdivisions of an icosphere [default: 3]
jitter-short = Random displacement of vertices within the surface
noise-short = Random displacement of vertices along the normal
seed-short = Seed of the random numbers
uv-short = Write the parameters as texture coordinates
