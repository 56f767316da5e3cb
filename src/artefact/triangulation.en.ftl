title = Different diagonals
claim = Linear interpolation gives different results for different triangulations of the same polygon.
source-1 =
    Ting 2008: “resultados distintos para diferentes triangulações” (different results for different triangulations)
source-2 = Lectures: exercise 1.6.25, whose diamond is used
formula-1 = {"c_{13} = \\frac{c_1 + c_3}{2}, \\quad c_{24} = \\frac{c_2 + c_4}{2}"}
formula-1-says =
    the colour in the middle of the diamond, cut from corner 1 (right) to 3 (left) or from 2 (above) to 4 (below)
formula-2 = {"c = \\frac{c_1 + c_2 + c_3 + c_4}{4}"}
formula-2-says = with a vertex of the mean colour in the middle, whichever way it is cut
formula-3 = {"|ΔI| = O(h^2)"}
formula-3-says =
    on a smooth surface the two diagonals of a square of side h differ in the middle by h²/2 times the mixed second
    derivative, and less elsewhere
shown-by =
    fewer squares (--segments), and light from the side, would show it on the waves; the diamond shows it in any light.
diamond-by = the mean of these corners; half a pixel's diagonal
diamond-change-measure = diamond: largest difference of the middle
waves-gouraud-measure = waves, Gouraud: difference of the diagonals (rms)
waves-phong-measure = waves, Phong: difference of the diagonals (rms)
waves-effect = light on the waves, off that of the surface itself (rms)
diamond-effect = colour of the middle, off the mean of all corners
holds =
    wherever the corners' values do not lie in one plane. The colours of triangles do not change as the polygon is
    turned, but how it is cut shows; on smooth surfaces the difference falls as the square of the facets' size.
waves-rising-title = waves, cut across
waves-rising-caption =
    Slanting waves with Gouraud's shading; each square is cut across them, from the lower left to the upper right.
waves-rising-seen = They fall into beads.
waves-falling-title = waves, cut along
waves-falling-caption =
    The same vertices and normals; only the diagonals run the other way, along the waves.
waves-falling-seen = The stripes are straight, but not as soft as those of the waves themselves.
waves-difference-title = difference
waves-difference-caption = How much both differ, from violet for 0 to yellow for { $full } and more.
waves-fine-title = waves, finer
waves-fine-caption = Cut across as the first, with four times the squares along a side.
waves-fine-seen = The cut is hardly seen any more.
waves-themselves-title = the waves themselves
waves-themselves-caption = The surface with its own normal at every pixel.
diamond-1-3-title = diamond, cut 1–3
diamond-1-3-caption = Cut from the right to the left corner.
diamond-1-3-seen = A light band runs across.
diamond-2-4-title = diamond, cut 2–4
diamond-2-4-caption = Cut from the upper to the lower corner.
diamond-2-4-seen = A dark olive band runs upright, and the middle has another colour.
diamond-fan-title = diamond, vertex in the middle
diamond-fan-caption = Four triangles about a vertex with the mean of the corners.
diamond-fan-seen = No diagonal is preferred.
note-1 =
    Each of the two triangles knows nothing of the fourth corner: along the diagonal only its two ends count. The
    scanline algorithm on the whole polygon prefers no diagonal, but depends on how the polygon is turned (see the
    experiment on orientation). The number that moved is how far light on the triangles is off that of the surface
    itself, for both cuts err: at least one of them by half of what they differ by.
order-measure = waves: order of the difference in h
order-of-black-slopes =
    not held against O(h²): slopes turned away from the light are black, and light has a kink at their borders
order-below-precision = not held against O(h²): the finest squares differ by little more than single precision
order-below-pixels = not held against O(h²): the finest squares are smaller than two pixels
order-of-coarse-squares = not held against O(h²): so few squares to a wave are not small
order-by = O(h²); facets of a twelfth of a wave are not small yet
difference-by-cells-title = Difference of both diagonals
difference-by-cells-caption =
    The difference on the waves against the number of squares along a side: the more there are, the more nearly it falls
    as one over their square.
difference-by-cells-x = squares along a side
difference-by-cells-y = rms difference
measured-curve = measured
law-curve = as h², h = 1/number
waves-cure = { $finer } times as many squares along a side
diamond-cure = a vertex in the middle
diamond-measure = { $cut }: { $colour } in the middle
red = red
green = green
blue = blue
waves-rising-measure = waves, cut across: light off that of the surface itself (rms)
waves-falling-measure = waves, cut along: light off that of the surface itself (rms)
waves-fine-measure = waves, cut across, finer: light off that of the surface itself (rms)
