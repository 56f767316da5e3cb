title = Interpolated shading leaves outlines polygonal
claim =
    Interpolated shading makes faces look curved, but the silhouette stays a visible polygon. Interpolated normals do
    not move vertices.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47 (figure 56)
source-2 = Cure for meshes without a formula: A. Vlachos et al., Curved PN triangles, I3D 2001
formula-1 = {"e = R (1 − \\cos(π/n))"}
formula-1-says = distance from the middle of a side of the regular n-gon to its circle; R is the radius in pixels
formula-2 = {"\\frac{A}{A_0} = \\frac{n}{2π} \\sin(2π/n)"}
formula-2-says = area of the n-gon divided by the area of the circle
formula-3 = {"n_{1/2} = \\frac{π}{2 \\arcsin(1/(2 \\sqrt{R}))} ≈ π \\sqrt{R}"}
formula-3-says = number of segments n above which e is less than half a pixel
own-mesh = its outline, compared with that of --finer FILE or of its own curved triangles
shown-by = Use fewer segments, a larger picture or a coarser mesh to show it.
ball = sphere
mean-distance-measure = sphere: mean distance of the outlines
mean-distance-by =
    mean of e over the polygon and over the circle; tolerance: a third of an outline pixel for each outline
fewest-segments-measure =
    sphere: fewest segments whose outline error exceeds that of a very fine sphere by at most half a pixel
fewest-segments-by =
    π/(2 arcsin(1/(2√R))), found by bisection in pictures. Pixels alone give even a circle an outline error, so a very
    fine sphere is the baseline. Tolerance: the outline pixels, converted to segments
torus = torus
flat-shading-measure = flat shading compared with Phong shading: distance of the outlines
flat-shading-by = shading does not move edges
outline-effect = largest distance of the outline
why-half-pixel-of-outlines = half a pixel, plus the tolerance of the outlines
outline-cure = { $fine } segments
note-1 =
    The vertices have the normals of the exact sphere, so the shading inside the outline looks curved. The picture of
    the sphere still ends where its faces end. The eye notices the outline first.
note-2 =
    Near the outline, faces are seen at grazing angles and are only a few pixels wide. Each of them is a side of the
    polygon. Refine meshes first where they turn away from the viewer.
distance-by = R (1 − cos(π/n)); tolerance: a third of an outline pixel for each outline
area-by = n/(2π) sin(2π/n); tolerance: the outline's length times the tolerance of distances
error-by-segments-title = Outline error
error-by-segments-caption =
    Distance of the sphere's outline from the circle against the number of segments. The largest and the mean distance
    fall as 1/n², like their closed forms. For many segments, only the error of the outline pixels is left.
error-by-segments-x = segments n
error-by-segments-y = distance in pixels
largest-curve = largest
mean-curve = mean
largest-law-curve = largest, closed form
mean-law-curve = mean, closed form
ball-caption = Phong shading with the normals of the exact sphere: the inside looks smooth.
ball-seen = Its outline is a polygon.
ball-fine-caption =
    At least twice as many segments, enough for an error below { $left } px by the closed form. The measured error can
    be up to { $open } px larger, because outlines consist of pixels.
ball-fine-seen = The outline looks round.
ball-itself-title = exact sphere
ball-itself-caption = The sphere drawn from its equation, without faces.
torus-caption = A torus seen along its axis.
torus-seen = The outer and the inner outline are polygons.
torus-fine-caption = The torus with as many segments as the finer sphere.
torus-fine-seen = Both outlines look round.
control-mesh =
    Curved triangles keep the vertices of the mesh. The vertices of a control mesh of a subdivision surface do not lie
    on that surface. In that case, subdivide the mesh or move its vertices to the subdivision surface.
same-outlines =
    The two meshes have the same outline at this size. Use a larger picture (--size) or a finer mesh for --finer.
own-title = mesh
own-caption = The mesh with Phong shading.
own-seen = Its outline differs from the reference.
own-curved-title = curved triangles
own-curved-caption = The same mesh as curved triangles that follow from its normals.
own-curved-seen = Its outline is closer to the reference.
finer-caption = The reference for the outlines.
no-finer-mesh =
    Without a finer mesh, the reference is curved triangles, and their outline is the same. Specify a finer mesh with
    --finer FILE, or a larger picture (--size).
distance-measure = { $surface }, { $segments } segments: largest distance of the outline
distance-fine-measure = { $surface }, { $fine } segments: largest distance of the outline
distance-fine-by = { distance-by }
area-measure = { $surface }, { $segments } segments: area divided by the true area
ball-title = sphere, { $segments } segments
ball-fine-title = sphere, { $fine } segments
torus-title = torus, { $segments } segments
torus-fine-title = torus, { $fine } segments
own-effect = { outline-effect }
own-cure = curved triangles, each edge divided into { $cure-parts }
own-distance-measure = largest distance of the outline
own-mean-distance-measure = mean distance of the outline
own-area-measure = area divided by the area of the reference
curved-distance-measure = curved triangles: largest distance of the outline
curved-mean-distance-measure = curved triangles: mean distance of the outline
shorter-edges-measure = factor by which edges must be shortened for an error of half a pixel
holds =
    with any shading; only more faces help. The error falls as 1/n². For half a pixel, this sphere with a radius of
    { $radius } pixels needs { $enough } segments; a radius of 200 pixels needs 45. Measured errors can be up to
    { $open } px larger, because outlines consist of pixels.
no-finer-mesh-sharp-edges =
    Without a finer mesh, the reference is curved triangles. { $sharp-edges } edges stay sharp in them, because their
    dihedral angle exceeds { $crease }°. If these edges belong to a curved shape, smooth them with --crease 180. To
    compare with the true shape, use --finer FILE.
own-holds = the outline of this mesh differs by more than half a pixel here. { compared-with }
lacking-title =
    { $compared ->
        [ball] missing area
       *[other] between outlines
    }
lacking-caption =
    { $compared ->
        [ball]
            Yellow where the sphere covers the picture and the polygons do not. There is a crescent at each side of the
            polygon; it is thinner with more sides.
        [finer] Yellow where only the mesh or only the finer mesh covers the picture.
       *[itself] Yellow where only the mesh or only its curved triangles cover the picture.
    }
finer-title =
    { $compared ->
        [finer] finer mesh
       *[itself] reference shape
    }
compared-with =
    { $compared ->
        [finer] The reference is the finer mesh `{ $finer }`.
       *[itself]
            The reference is the mesh as curved triangles, with each edge divided into { $parts }. These are cubic
            Bézier triangles (curved PN triangles): at each vertex they are perpendicular to its normal, and along
            creases to the normals of both sides. The true shape may differ; specify it with --finer FILE.
    }
