title = Affine interpolation is wrong under perspective
claim =
    Linear interpolation in the picture is wrong under perspective: equal steps on the screen are not equal steps on the
    surface.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47
source-2 = J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992
formula-1 = {"s(t) = \\frac{t}{t + ρ (1 − t)}"}
formula-1-says =
    position s on the surface that is visible at the position t in the picture, both from 0 to 1; ρ = z_far/z_near
formula-2 = {"\\max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"}
formula-2-says = largest error of affine interpolation; it exceeds ½ step of 255 if ρ > 1.0079 for colours from 0 to 1
shown-by = Use a deeper wall to show it.
affine-by = (√ρ − 1)/(√ρ + 1); tolerance: the nearest pixel of 4096, and single precision
scanline-measure = scanline, ρ = 4
perspective-measure = perspective-correct, ρ = 4
perspective-by = 0, because a/w and 1/w are linear in the picture
pieces-measure = affine, { $segments } × { $segments } squares
pieces-by = error of the nearest square, which has the largest depth ratio, 1 + (ρ − 1)/n, divided by n
pieces-up-measure = affine, { $pieces } × { $pieces } squares: vertical position
pieces-up-by = at most the horizontal error, which occurs on the diagonal of a square; pixels lie next to the diagonal
affine-effect = largest error of the horizontal position
affine-cure = perspective-correct interpolation
holds-only-if =
    the corners of a triangle have different depths in a perspective projection. In a parallel projection, or on a face
    parallel to the screen, both methods are equal. An error below half a step of 255 is not visible; for colours from 0
    to 1 this means depths within 0.8 %.
note-1 =
    The board is not an image texture. Two numbers, the horizontal and the vertical position, are interpolated between
    the four corners of one face, and determine the colour of each square. Colours and normals have the same error.
note-2 =
    In a subdivided wall, each square is smaller and has a smaller depth ratio. The error falls with the square of their
    number along a side. Division by depth removes it.
affine-title = affine
affine-caption = A wall that extends away from the viewer to the right, to four times the depth.
affine-seen =
    Interpolated in the picture, the squares of the board have a kink at the diagonal and do not become narrower with
    distance.
perspective-title = perspective-correct
perspective-caption = The same face with perspective-correct interpolation.
perspective-seen = The squares of the board become smaller with distance.
pieces-title = affine, subdivided
pieces-caption = Affine interpolation on a wall divided into { $segments } × { $segments } squares.
pieces-seen = The error of each square is too small to be visible.
error-title = affine error
error-caption =
    Distance of the affine from the true position, horizontally or vertically, whichever is larger. Yellow is { $full }
    of the wall.
error-pieces-title = subdivided error
error-pieces-caption = The subdivided wall on the same scale: at most { $pieces-error }.
largest-error-title = Largest error against the depth ratio
largest-error-caption =
    Measured errors lie on the curve (√ρ − 1)/(√ρ + 1): a third of the length at ρ = 4, half at ρ = 9.
largest-error-x = depth ratio
largest-error-y = largest |t − s|
measured-curve = measured
law-curve = closed form
place-title = Surface position against picture position
place-caption = Affine interpolation follows the straight line; the correct positions lie on the curves.
place-x = t in the picture
place-y = s on the surface
affine-measure = affine, ρ = { $ratio }
scanline-by = { affine-by }
place-curve = depth ratio { $ratio }
