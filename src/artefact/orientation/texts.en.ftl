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
law-scanline-corners = the law of the scanline; corners snap to 256ths of pixels
measure-largest-distance-law = largest distance from the law, over 72 turns
measure-largest-change-centre = largest change of the centre's colour
measure-mean-change-centre = mean change of the centre's colour
measure-largest-change-triangles = largest change, in triangles
by-barycentric-coordinates-do = barycentric coordinates do not turn; corners snap to 256ths of pixels
moved = largest change of the centre's colour while it turns
cure = cut into triangles
holds-polygons-four-corners =
    for polygons of four corners and more, whose colours are not those of one plane. Triangles do not depend on how they
    are turned, but a polygon's colours then depend on how it is cut into them.
note-seen-front-all =
    Seen from in front all triangles are alike. Aslant their colours have to be mixed by 1/depth (perspective): mixed by
    distances in the picture they change with the turn, too, by less than scanlines' do.
note-algorithm-interpolates-down =
    The algorithm interpolates down the two edges that a scanline cuts, then across between them. Turn the polygon, and
    the scanline through its centre cuts other edges at other places.
note-animation-animate-shows =
    The animation (--animate) shows the turn; --interpolation affine or perspective shows it in triangles, where nothing
    changes but the place.
note-triangles-cure-three =
    Triangles cure that: three corners determine a plane of colours. The price is the choice of the diagonal: the
    diamond's centre has the mean of the corners that the diagonal joins.
polygon-edges-shorter = this polygon has edges shorter than a pixel, which scanlines may pass over
exercise-b-answer = exercise 1.6.25 b, answer C
mean-corners-diagonal = the mean of the corners that the diagonal joins
position = position 1
position-v2 = position 2
diagonal-triangles = diagonal 1–3 (triangles)
diagonal-triangles-v2 = diagonal 2–4 (triangles)
oblique-change-quarter = aslant, change by a quarter turn: scanline
line-corner-mixed = the line from corner 3 to 1, then that from 2 to 4, mixed by distances in the picture
oblique-change-quarter-turn = aslant, change by a quarter turn: triangles
s-d-corners = s/2d of what corners 1 and 3 differ by: the edge between them runs into depth in one position only
oblique-change-quarter-turn-triangles = aslant, change by a quarter turn: triangles by perspective
colours-mixed-depth = colours that are mixed by 1/depth are of the place on the polygon
law-scanline-every = the law of the scanline at every pixel, 0 in triangles; corners snap to 256ths of pixels
moved-largest-change-pixel = largest change of a pixel's colour by a quarter turn, turned back
same-colours-however = The same colours however it is turned.
also-same-however = Also the same however it is turned, but not the same as the other.
halves-title = scanline: 0° above, 90° below
halves-caption-above-diamond-stands =
    Above, the diamond as it stands; below, drawn turned by 90° and turned back. Corner 1 is at the right, 2 above, 3 at
    the left (the brightest), 4 below (olive).
halves-caption-above-polygon-stands = Above, the polygon as it stands; below, drawn turned by 90° and turned back.
halves-caption-colours-own-would = Were the colours its own, there would be no seam.
halves-triangles-title = triangles: 0° above, 90° below
halves-triangles-caption-same-triangles = The same in triangles.
halves-triangles-caption-no-seam = There is no seam.
position-1-title = scanline, 0°
position-1-caption-position-scanline-through = Position 1: the scanline through the centre runs from corner 3 to corner 1.
position-1-caption-stands-every-pixel = As it stands: every pixel lies between the two edges that its scanline meets first.
position-1-caption-turned-other-colours = Turned it has other colours.
turned-45-title = scanline, 45°
turned-45-caption-eighth-turn-scanline =
    An eighth of a turn: the scanline cuts two edges in their middles, and the centre is the mean of all corners.
turned-45-caption-eighth-turn-scanlines = An eighth of a turn: scanlines meet the edges elsewhere.
turned-45-caption-colours-change-turn = Colours change with the turn.
position-2-title = scanline, 90°
position-2-caption-position-scanline-runs = Position 2: the scanline runs from corner 2 to corner 4.
position-2-caption-quarter-turn-scanlines = A quarter turn: scanlines meet other edges.
position-2-caption-same-polygon-other = The same polygon has other colours.
difference-title = difference, 90° turned back
difference-caption-position-turned-back =
    Position 2 turned back, less position 1: dark is none, yellow 0.4 of the full range in a component.
difference-caption-drawn-turned-turned =
    Drawn turned and turned back, less as it stands: dark is none, yellow 0.4 of the full range in a component.
diagonal-13-title = triangles, diagonal 1–3
diagonal-13-caption-triangles-cut-way = triangles, cut one way
diagonal-13-caption-cut-corner-corner =
    Cut from corner 1 to corner 3: what scanlines draw in position 1, whose middle one is this diagonal.
diagonal-13-caption-cut-way = Cut one way.
diagonal-24-title = triangles, diagonal 2–4
diagonal-24-caption-triangles-same-cut = triangles, the same cut
diagonal-24-caption-triangles-cut-another = triangles, cut another way
diagonal-24-caption-cut-corner-corner = Cut from corner 2 to corner 4: what scanlines draw in position 2.
diagonal-24-caption-no-other-cut = No other cut lies inside this polygon: the same once more.
diagonal-24-caption-cut-another-way = Cut another way.
diagonals-title = difference of the diagonals
diagonals-caption-difference-cuts = difference of the cuts
diagonals-caption-diagonal-less-other =
    One diagonal less the other: what the cut decides, which is what the turn decides under scanlines. Yellow is 0.4 of
    the full range in a component.
diagonals-caption-cut-less-other = One cut less the other: what the cut decides. Yellow is 0.4 of the full range in a component.
r-scanline = R, scanline
g-scanline = G, scanline
b-scanline = B, scanline
g-triangles = G, triangles
r-law = R, the law
g-law = G, the law
b-law = B, the law
chart-title = Colour of the centre over a whole turn
chart-caption =
    Under the scanline algorithm the centre's colour changes by up to { $bad } over a turn, as the law says; in
    triangles by up to { $cured }.
axis-turned-degrees = turned by, degrees
axis-linear-component = linear component
