title = Polygonal silhouettes
claim =
    Interpolated shading makes faces look round, but silhouettes stay markedly polygonal: normals do not move vertices.
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
mean-distance-measure = ball: mean distance of the outlines
mean-distance-by = the mean of e over the polygon and over the circle; a third of the outlines' own pixels from either
fewest-segments-measure =
    ball: fewest segments whose outline is off by at most half a pixel more than that of a very fine ball
fewest-segments-by =
    π/(2 arcsin(1/(2√R))), found by halving in pictures, whose own pixels keep even a circle's outline from being right;
    what distances leave open in addition, in segments
torus = torus
flat-shading-measure = flat shading against Phong's: distance of the outlines
flat-shading-by = shading does not move edges
outline-effect = largest distance of the outline
why-half-pixel-of-outlines = half a pixel, and what outlines of pixels leave open
outline-cure = { $fine } segments
note-1 =
    The vertices have the ball's own normals, so light runs over the faces as over a ball. But the picture ends where
    the faces end, and the eye looks at outlines first.
note-2 =
    Near the outline faces are seen from the side: they are few pixels wide there, and every one of them is a side of
    the polygon. So meshes are best refined where they turn away from the viewer.
distance-by = R (1 − cos(π/n)); a third of the outlines' own pixels from either
area-by = n/(2π) sin(2π/n); the outline's length times what distances leave open
error-by-segments-title = Error of the outline
error-by-segments-caption =
    How far the outline of the ball is from the circle against the number of segments: both the largest and the mean
    distance fall as 1/n², as the closed forms say, until the outlines' own pixels are all that is left.
error-by-segments-x = segments n
error-by-segments-y = distance in pixels
largest-curve = largest
mean-curve = mean
largest-law-curve = largest, closed form
mean-law-curve = mean, closed form
ball-caption = Phong's shading with the ball's own normals: within, all is round.
ball-seen = Its outline is a polygon.
ball-fine-caption =
    At least twice as many segments as before, and enough for an error below { $left } px by the closed form; what is
    measured may be up to { $open } px more, as outlines are made of pixels.
ball-fine-seen = The outline is round to the eye.
ball-itself-title = the ball itself
ball-itself-caption = The ball by its equation, without faces.
torus-caption = A torus along its axis.
torus-seen = Outside as inside the outline is a polygon.
torus-fine-caption = The torus with as many segments as the finer ball.
torus-fine-seen = It is round to the eye.
control-mesh =
    Curved triangles leave the mesh's vertices where they are. If this is the control mesh of a subdivision surface,
    they do not lie on that surface, so that no curve through them is its outline: what helps is to subdivide it, or to
    move its vertices to where the subdivision brings them.
same-outlines =
    the two meshes have the same outline at this size: a larger picture (--size) or a finer mesh for --finer would show
    more.
own-title = the mesh
own-caption = The mesh as it is, with Phong's shading.
own-seen = Its outline is off.
own-curved-title = curved triangles
own-curved-caption = The same mesh in curved triangles that its normals determine.
own-curved-seen = Its outline comes closer.
finer-caption = What the outlines are held against.
no-finer-mesh =
    no finer mesh was given, and in curved triangles the outline is the same: give one with --finer FILE, or a larger
    picture (--size).
distance-measure = { $surface }, { $segments } segments: largest distance of the outline
distance-fine-measure = { $surface }, { $fine } segments: largest distance of the outline
distance-fine-by = { distance-by }
area-measure = { $surface }, { $segments } segments: area over the true one
ball-title = ball, { $segments } segments
ball-fine-title = ball, { $fine } segments
torus-title = torus, { $segments } segments
torus-fine-title = torus, { $fine } segments
own-effect = { outline-effect }
own-cure = curved triangles, every edge cut into { $cure-parts }
own-distance-measure = largest distance of the outline
own-mean-distance-measure = mean distance of the outline
own-area-measure = area over that of the shape it is compared with
curved-distance-measure = curved triangles: largest distance of the outline
curved-mean-distance-measure = curved triangles: mean distance of the outline
shorter-edges-measure = edges would have to be so many times shorter for half a pixel
holds =
    whatever the shading; only more faces help. The error falls as 1/n². For half a pixel this ball of a radius of {
    $radius } pixels needs { $enough } segments, one of 200 pixels 45; outlines in pictures are made of pixels, so that
    up to { $open } px more are measured.
no-finer-mesh-sharp-edges =
    no finer mesh was given, and { $sharp-edges } edges stay sharp in the curved triangles that this one is compared
    with, because their angle exceeds { $crease }°. If they represent a round shape, --crease 180 smooths them; --finer
    FILE gives the true shape.
own-holds = the outline of this mesh is off by more than half a pixel here. { compared-with }
lacking-title =
    { $compared ->
        [ball] what is lacking
       *[other] between the outlines
    }
lacking-caption =
    { $compared ->
        [ball]
            Yellow where the ball covers the picture and the polygons do not: a sickle over every side, the thinner the
            more sides there are.
        [finer] Yellow where only one of the two covers the picture, the mesh or the finer one.
       *[itself] Yellow where only one of the two covers the picture, the mesh or its own curved triangles.
    }
finer-title =
    { $compared ->
        [finer] the finer mesh
       *[itself] the shape it is compared with
    }
compared-with =
    { $compared ->
        [finer] It is compared with the finer mesh `{ $finer }`.
       *[itself]
            No finer mesh was given, so it is compared with itself in curved triangles, every edge cut into { $parts }:
            Bézier triangles of third order that leave its vertices at right angles to its normals (curved PN
            triangles), and along creases at right angles to the normals of both sides. It may represent another shape;
            --finer FILE gives that.
    }
