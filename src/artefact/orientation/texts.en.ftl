title = Dependence on orientation
claim =
    Interpolation along scanlines depends on how a polygon is turned: the centre of the diamond of exercise 1.6.25 has
    the colour (0.1, 0.5, 0.5) in one position and (0.2, 0.3, 0.1) a quarter turn later.
source-1 = Lectures: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25
source-2 = Ting 2008: “different results for different triangulations”
formula-1 = {"c(θ) = \\frac{|\\cos(θ)| (c_1 + c_3)/2 + |\\sin(θ)| (c_2 + c_4)/2}{|\\cos(θ)| + |\\sin(θ)|}"}
formula-1-says =
    the colour at the centre of the diamond turned by θ; c₁ to c₄ are the colours of its corners, counter-clockwise from
    the right one, and θ = 0 is position 1
own-mesh = its first face of four corners or more, with the colours of its vertices if it has them
shown-by = a polygon of four corners or more, whose colours do not lie in one plane over it, would show it.
law-by = the law of the scanline; corners snap to 256ths of pixels
law-measure = largest distance from the law, over 72 turns
largest-change-measure = largest change of the centre's colour
mean-change-measure = mean change of the centre's colour
triangles-change-measure = largest change, in triangles
triangles-change-by = barycentric coordinates do not turn; corners snap to 256ths of pixels
centre-effect = largest change of the centre's colour while it turns
centre-cure = cut into triangles
holds =
    for polygons of four corners and more, whose colours are not those of one plane. Triangles do not depend on how they
    are turned, but a polygon's colours then depend on how it is cut into them.
note-1 =
    Seen from in front all triangles are alike. Aslant their colours have to be mixed by 1/depth (perspective): mixed by
    distances in the picture they change with the turn, too, by less than scanlines' do.
note-2 =
    The algorithm interpolates down the two edges that a scanline cuts, then across between them. Turn the polygon, and
    the scanline through its centre cuts other edges at other places.
note-3 =
    The animation (--animate) shows the turn; --interpolation affine or perspective shows it in triangles, where nothing
    changes but the place.
note-4 =
    Triangles cure that: three corners determine a plane of colours. The price is the choice of the diagonal: the
    diamond's centre has the mean of the corners that the diagonal joins.
short-edges = this polygon has edges shorter than a pixel, which scanlines may pass over
exercise-by = exercise 1.6.25 b, answer C
diagonal-by = the mean of the corners that the diagonal joins
position-1 = position 1
position-2 = position 2
diagonal-13-cut = diagonal 1–3 (triangles)
diagonal-24-cut = diagonal 2–4 (triangles)
oblique-scanline-measure = aslant, change by a quarter turn: scanline
oblique-scanline-by = the line from corner 3 to 1, then that from 2 to 4, mixed by distances in the picture
oblique-triangles-measure = aslant, change by a quarter turn: triangles
oblique-triangles-by =
    s/2d of what corners 1 and 3 differ by: the edge between them runs into depth in one position only
oblique-perspective-measure = aslant, change by a quarter turn: triangles by perspective
oblique-perspective-by = colours that are mixed by 1/depth are of the place on the polygon
back-scanline-by = the law of the scanline at every pixel, 0 in triangles; corners snap to 256ths of pixels
seam-effect = largest change of a pixel's colour by a quarter turn, turned back
diagonal-13-seen = The same colours however it is turned.
halves-title = scanline: 0° above, 90° below
halves-seen = Were the colours its own, there would be no seam.
halves-triangles-title = triangles: 0° above, 90° below
halves-triangles-caption = The same in triangles.
halves-triangles-seen = There is no seam.
position-1-title = scanline, 0°
position-1-seen = Turned it has other colours.
turned-45-title = scanline, 45°
turned-45-seen = Colours change with the turn.
position-2-title = scanline, 90°
position-2-seen = The same polygon has other colours.
difference-title = difference, 90° turned back
difference-caption =
    Drawn turned and turned back, less as it stands: dark is none, yellow { $full } of the full range in a component.
diagonals-title =
    { $shape ->
        [diamond] difference of the diagonals
       *[polygon] difference of the cuts
    }
diagonals-caption = One cut less the other: what the cut decides. Yellow is { $full } of the full range in a component.
r-scanline-curve = R, scanline
g-scanline-curve = G, scanline
b-scanline-curve = B, scanline
g-triangles-curve = G, triangles
r-law-curve = R, the law
g-law-curve = G, the law
b-law-curve = B, the law
centre-title = Colour of the centre over a whole turn
centre-caption =
    Under the scanline algorithm the centre's colour changes by up to { $bad } over a turn, as the law says; in
    triangles by up to { $cured }.
centre-x = turned by, degrees
centre-y = linear component
largest-change-by = { law-by }
mean-change-by = { law-by }
seam-cure = { centre-cure }
back-scanline-measure = scanline: a quarter turn, turned back (rms)
back-triangles-measure = triangles: a quarter turn, turned back (rms)
back-perspective-measure = triangles by perspective: a quarter turn, turned back (rms)
back-triangles-by = { back-scanline-by }
back-perspective-by = { back-scanline-by }
exercise-measure = { $case }: { $component } at the centre
diagonal-measure = { exercise-measure }
diagonal-24-seen = { diagonal-13-seen }
halves-caption =
    Above, the polygon as it stands; below, drawn turned by 90° and turned back.{ $shape ->
        [diamond] {" "}Corner 1 is at the right, 2 above, 3 at the left (the brightest), 4 below (olive).
       *[polygon] {""}
    }
position-1-caption =
    { $shape ->
        [diamond] Position 1: the scanline through the centre runs from corner 3 to corner 1.
       *[polygon] As it stands: every pixel lies between the two edges that its scanline meets first.
    }
turned-45-caption =
    { $shape ->
        [diamond]
            An eighth of a turn: the scanline cuts two edges in their middles, and the centre is the mean of all
            corners.
       *[polygon] An eighth of a turn: scanlines meet the edges elsewhere.
    }
position-2-caption =
    { $shape ->
        [diamond] Position 2: the scanline runs from corner 2 to corner 4.
       *[polygon] A quarter turn: scanlines meet other edges.
    }
diagonal-13-title =
    { $shape ->
        [diamond] triangles, diagonal 1–3
       *[polygon] triangles, cut one way
    }
diagonal-13-caption =
    { $shape ->
        [diamond] Cut from corner 1 to corner 3: what scanlines draw in position 1, whose middle one is this diagonal.
       *[polygon] Cut one way.
    }
diagonal-24-title =
    { $shape ->
        [diamond] triangles, diagonal 2–4
       *[polygon]
            { $cuts ->
                [one] triangles, the same cut
               *[two] triangles, cut another way
            }
    }
diagonal-24-caption =
    { $shape ->
        [diamond] Cut from corner 2 to corner 4: what scanlines draw in position 2.
       *[polygon]
            { $cuts ->
                [one] No other cut lies inside this polygon: the same once more.
               *[two] Cut another way.
            }
    }
