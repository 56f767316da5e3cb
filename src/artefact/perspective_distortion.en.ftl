title = Perspective distortion
claim =
    Interpolating evenly on the picture is wrong under perspective: equal steps on the screen are not equal steps on the
    surface.
source-1 = Lectures: 1.5.2.3, 1.6.15, 1.6.47
source-2 = J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992
formula-1 = {"s(t) = \\frac{t}{t + ρ (1 − t)}"}
formula-1-says =
    the place s on the surface that is seen at the place t of the picture, both from 0 to 1; ρ = z_far/z_near
formula-2 = {"\\max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"}
formula-2-says = the largest error of even interpolation; ½ step of 255 as soon as ρ > 1.0079 for colours from 0 to 1
shown-by = a deeper wall would show it.
affine-by = (√ρ − 1)/(√ρ + 1); the nearest pixel of 4096, and single precision
scanline-measure = scanline, ρ = 4
perspective-measure = perspective-correct, ρ = 4
perspective-by = a/w and 1/w are linear on the picture
pieces-measure = affine, { $segments } × { $segments } pieces
pieces-by = the nearest piece has the largest depth ratio, 1 + (ρ − 1)/n; its error over n
pieces-up-measure = affine, { $pieces } × { $pieces } pieces: place up
pieces-up-by = as much as across, on the diagonal of a piece; pixels lie next to it
affine-effect = largest error of the place across
affine-cure = perspective-correct interpolation
holds-only-if =
    the depths of a triangle's corners differ under a central projection. In a parallel projection, or facing the
    viewer, both ways are the same; and an error below half a step of 255 is not seen: depths within 0.8 % for colours
    from 0 to 1.
note-1 =
    The board is not an image pasted on: two numbers are interpolated between the four corners of one face, the places
    across and up, and a square's colour is read off them. Whatever is interpolated, colours and normals too, goes wrong
    alike.
note-2 =
    Cut into more pieces both ways, each is smaller and has a smaller depth ratio: the error falls with the square of
    their number along a side. Dividing by depth makes it vanish.
affine-title = affine
affine-caption = A wall that runs away to the right, to four times the depth.
affine-seen =
    Interpolated on the picture, squares bend at the diagonal and are as wide far away as near.
perspective-title = perspective-correct
perspective-caption = The same face interpolated in the scene.
perspective-seen = Squares become smaller with their distance.
pieces-title = affine, in pieces
pieces-caption = Affine again, but the wall is cut into { $segments } × { $segments } pieces.
pieces-seen = Each errs so little that nothing of it is seen.
error-title = error of the affine one
error-caption =
    How far the affine place is from the true one, across or up, whichever is more: yellow is { $full } of the wall.
error-pieces-title = error in pieces
error-pieces-caption = The same scale for the wall in pieces: { $pieces-error } at most.
largest-error-title = Largest error against the depth ratio
largest-error-caption = Measured errors lie on the curve (√ρ − 1)/(√ρ + 1): a third of the length at ρ = 4, half at 9.
largest-error-x = depth ratio ρ
largest-error-y = largest |t − s|
measured-curve = measured
law-curve = closed form
place-title = Place on the surface against place on the picture
place-caption = Even interpolation takes the straight line; what ought to be seen lies on the curves.
place-x = t on the picture
place-y = s on the surface
affine-measure = affine, ρ = { $ratio }
scanline-by = { affine-by }
place-curve = ρ = { $ratio }
