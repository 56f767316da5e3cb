title = The choice of diagonal changes the colours
claim = Linear interpolation gives different results for different triangulations of the same polygon.
source-1 =
    Ting 2008: “resultados distintos para diferentes triangulações” (different results for different triangulations)
source-2 = Lectures: exercise 1.6.25 (the diamond)
formula-1 = {"c_{13} = \\frac{c_1 + c_3}{2}, \\quad c_{24} = \\frac{c_2 + c_4}{2}"}
formula-1-says =
    colour in the middle of the diamond with the diagonal from corner 1 (right) to 3 (left), or from 2 (top) to 4
    (bottom)
formula-2 = {"c = \\frac{c_1 + c_2 + c_3 + c_4}{4}"}
formula-2-says = colour in the middle with an extra vertex there that has the mean colour
formula-3 = {"|ΔI| = O(h^2)"}
formula-3-says =
    on a smooth surface, the two diagonals of a square with side h differ in the middle by h²/2 times the mixed second
    derivative, and less elsewhere
shown-by =
    Use fewer squares (--segments) and light from the side to show it on the waves. The diamond shows it in any light.
diamond-by = mean of these corners; tolerance: half a pixel diagonal
diamond-change-measure = diamond: largest difference in the middle
waves-gouraud-measure = waves, Gouraud: difference between the diagonals (rms)
waves-phong-measure = waves, Phong: difference between the diagonals (rms)
waves-effect = light on the waves: error against the exact surface (rms)
diamond-effect = colour in the middle: difference from the mean of all corners
holds =
    whenever the corner values do not lie in one plane. The colours of triangles do not change when the polygon rotates,
    but the chosen diagonal is visible. On smooth surfaces the difference falls with the square of the facet size.
waves-rising-title = waves, diagonals across
waves-rising-caption =
    Oblique waves with Gouraud shading. The diagonal of each square runs across the waves, from lower left to upper
    right.
waves-rising-seen = The stripes break up into beads.
waves-falling-title = waves, diagonals along
waves-falling-caption = The same vertices and normals; the diagonals run along the waves.
waves-falling-seen = The stripes are straight, but less smooth than those of the exact waves.
waves-difference-title = difference
waves-difference-caption = Difference between the two pictures: violet is 0, yellow is { $full } or more.
waves-fine-title = waves, finer
waves-fine-caption = Diagonals across the waves, with four times as many squares along a side.
waves-fine-seen = The diagonals are hardly visible.
waves-themselves-title = exact waves
waves-themselves-caption = The surface with its exact normal at every pixel.
diamond-1-3-title = diamond, diagonal 1–3
diamond-1-3-caption = The diagonal joins the right and the left corner.
diamond-1-3-seen = There is a horizontal light band.
diamond-2-4-title = diamond, diagonal 2–4
diamond-2-4-caption = The diagonal joins the upper and the lower corner.
diamond-2-4-seen = There is a vertical dark olive band, and the colour in the middle is different.
diamond-fan-title = diamond, vertex in the middle
diamond-fan-caption = Four triangles around a vertex that has the mean colour of the corners.
diamond-fan-seen = No diagonal is preferred.
note-1 =
    Each triangle uses three of the four corners, so only the two ends of the diagonal determine the colours along it.
    The scanline algorithm on the whole polygon prefers no diagonal, but depends on the rotation of the polygon (see the
    experiment `orientation`). The effect is measured against the exact surface, because both triangulations have
    errors. At least one of the two errors is at least half the difference between the two triangulations.
order-measure = waves: order of the difference in h
order-of-black-slopes =
    not compared with O(h²): slopes that face away from the light are black, and luminance has a kink at their borders
order-below-precision = not compared with O(h²): the difference of the finest squares is close to single precision
order-below-pixels = not compared with O(h²): the finest squares are smaller than two pixels
order-of-coarse-squares = not compared with O(h²): there are too few squares per wave
order-by = O(h²); tolerance: facets of a twelfth of a wave are not yet small
difference-by-cells-title = Difference between both diagonals
difference-by-cells-caption =
    Difference on the waves against the number of squares along a side. With many squares it falls as one over the
    square of their number.
difference-by-cells-x = squares along a side
difference-by-cells-y = rms difference
measured-curve = measured
law-curve = h², h = 1/number
waves-cure = { $finer } times as many squares along a side
diamond-cure = a vertex in the middle
diamond-measure = { $cut }: { $colour } in the middle
red = red
green = green
blue = blue
waves-rising-measure = waves, diagonals across: error of light against the exact surface (rms)
waves-falling-measure = waves, diagonals along: error of light against the exact surface (rms)
waves-fine-measure = waves, diagonals across, finer: error of light against the exact surface (rms)
