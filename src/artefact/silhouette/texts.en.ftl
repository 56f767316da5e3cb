title = Polygonal silhouettes
claim = Interpolated shading makes faces look round, but silhouettes stay markedly polygonal: normals do not move vertices.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47 (figure 56)
source-2 = For the cure of meshes without a formula: A. Vlachos et al., Curved PN triangles, I3D 2001
formula-1 = {"e = R (1 − \\cos(π/n))"}
formula-1-says = how far the middles of the sides of an n-gon lie within its circle of R pixels
formula-2 = {"\\frac{A}{A_0} = \\frac{n}{2π} \\sin(2π/n)"}
formula-2-says = its area over the circle's
formula-3 = {"n_{1/2} = \\frac{π}{2 \\arcsin(1/(2 \\sqrt{R}))} ≈ π \\sqrt{R}"}
formula-3-says = the n from which e is below half a pixel
own-mesh = its outline against that of --finer FILE, or of itself in curved triangles
shown-by = fewer segments, a larger picture or a coarser mesh would show it.
ball = ball
measure-ball-mean-distance = ball: mean distance of the outlines
by-mean-e-over = the mean of e over the polygon and over the circle; a third of the outlines' own pixels from either
measure-ball-fewest-segments =
    ball: fewest segments whose outline is off by at most half a pixel more than that of a very fine ball
by-arcsin-r-found =
    π/(2 arcsin(1/(2√R))), found by halving in pictures, whose own pixels keep even a circle's outline from being right;
    what distances leave open beside that, in segments
torus = torus
measure-flat-shading-against = flat shading against Phong's: distance of the outlines
by-shading-does-not = shading does not move edges
moved = largest distance of the outline
why-half-pixel-outlines = half a pixel, and what outlines of pixels leave open
cure = { $fine } segments
note-vertices-ball-own =
    The vertices have the ball's own normals, so light runs over the faces as over a ball. But the picture ends where
    the faces end, and the eye looks at outlines first.
note-near-outline-faces =
    Near the outline faces are seen from the side: they are few pixels wide there, and every one of them is a side of
    the polygon. So meshes are best refined where they turn away from the viewer.
by-r-cos-n = R (1 − cos(π/n)); a third of the outlines' own pixels from either
by-n-sin-n = n/(2π) sin(2π/n); the outline's length times what distances leave open
chart-title = Error of the outline
chart-caption =
    How far the outline of the ball is from the circle against the number of segments: both the largest and the mean
    distance fall as 1/n², as the closed forms say, until the outlines' own pixels are all that is left.
axis-segments-n = segments n
axis-distance-pixels = distance in pixels
largest = largest
mean = mean
largest-closed-form = largest, closed form
mean-closed-form = mean, closed form
ball-title = Phong's shading with the ball's own normals: within, all is round.
ball-caption-outline-polygon = Its outline is a polygon.
lacking-title = what is lacking
lacking-caption-yellow-ball-covers =
    Yellow where the ball covers the picture and the polygons do not: a sickle over every side, the thinner the more
    sides there are.
ball-fine-title =
    At least twice as many segments as before, and enough for an error below { $left } px by the closed form; what is
    measured may be up to { $open } px more, as outlines are made of pixels.
ball-fine-caption-outline-round-eye = The outline is round to the eye.
ball-itself-title = the ball itself
ball-itself-caption-ball-equation-without = The ball by its equation, without faces.
torus-title = A torus along its axis.
torus-caption-outside-inside-outline = Outside as inside the outline is a polygon.
torus-fine-title = The torus with as many segments as the finer ball.
torus-fine-caption-round-eye = It is round to the eye.
curved-triangles-leave =
    Curved triangles leave the mesh's vertices where they are. If this is the control mesh of a subdivision surface,
    they do not lie on that surface, so that no curve through them is its outline: what helps is to subdivide it, or to
    move its vertices to where the subdivision brings them.
holds-outline-mesh-off = the outline of this mesh is off by more than half a pixel here.
absent-meshes-same-outline =
    the two meshes have the same outline at this size: a larger picture (--size) or a finer mesh for --finer would show
    more.
own-title = the mesh
own-caption-mesh-phong-shading = The mesh as it is, with Phong's shading.
own-caption-outline-off = Its outline is off.
lacking-title-between-outlines = between the outlines
lacking-caption-yellow-only-covers = Yellow where only one of the two covers the picture, the mesh or the finer one.
lacking-caption-yellow-only-covers-picture =
    Yellow where only one of the two covers the picture, the mesh or its own curved triangles.
own-curved-title = curved triangles
own-curved-caption-same-mesh-curved = The same mesh in curved triangles that its normals determine.
own-curved-caption-outline-comes-closer = Its outline comes closer.
finer-title = the finer mesh
finer-caption-held-against = what it is held against
finer-caption-outlines-held-against = What the outlines are held against.
no-finer-mesh =
    no finer mesh was given, and in curved triangles the outline is the same: give one with --finer FILE, or a larger
    picture (--size).
held-against-finer = It is held against the finer mesh `{ $finer }`.
no-finer-mesh-given =
    No finer mesh was given, so it is held against itself in curved triangles, every edge cut into { $parts }: Bézier
    triangles of third order that leave its vertices at right angles to its normals (curved PN triangles), and along
    creases at right angles to the normals of both sides. What it stands for may be another shape; --finer FILE gives
    that.
