title = Scanline interpolation depends on the orientation
claim =
    Interpolation along scanlines depends on the orientation of a polygon. The centre of the diamond of exercise 1.6.25
    has the colour (0.1, 0.5, 0.5) in one position and (0.2, 0.3, 0.1) after a rotation by 90°.
source-1 = Lectures: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25
source-2 = Ting 2008: “different results for different triangulations”
formula-1 = {"c(θ) = \\frac{|\\cos(θ)| (c_1 + c_3)/2 + |\\sin(θ)| (c_2 + c_4)/2}{|\\cos(θ)| + |\\sin(θ)|}"}
formula-1-says =
    colour at the centre of the diamond rotated by θ; c₁ to c₄ are the colours of its corners, counter-clockwise from
    the right, and θ = 0 is position 1
own-mesh = its first face with four corners or more, with vertex colours if there are any
shown-by = To show it, use a polygon with four corners or more whose colours do not lie in one plane.
law-by = the scanline formula; tolerance: corners snap to 1/256 pixel
law-measure = largest difference from the formula over 72 rotations
largest-change-measure = largest change of the colour at the centre
mean-change-measure = mean change of the colour at the centre
triangles-change-measure = triangles: largest change of the colour at the centre
triangles-change-by = 0, because barycentric coordinates do not change; tolerance: corners snap to 1/256 pixel
centre-effect = largest change of the colour at the centre over a full rotation
centre-cure = triangulation
holds =
    for polygons with four corners or more whose colours do not lie in one plane. Triangles do not depend on their
    orientation, but the colours of a polygon then depend on its triangulation.
note-1 =
    In a frontal view, no triangle depends on its orientation. In an oblique view, their colours need
    perspective-correct interpolation (1/depth). With affine interpolation they change with rotation too, by less than
    scanline interpolation.
note-2 =
    The algorithm interpolates along the two edges that a scanline crosses, then between them. If the polygon rotates,
    the scanline through its centre crosses other edges at other points.
note-3 =
    The animation (--animate) shows the rotation. With --interpolation affine or perspective it shows triangles; then
    the colours do not change.
note-4 =
    Triangles cure this, because three corners determine a plane of colours. The result then depends on the diagonal:
    the centre of the diamond has the mean of the two corners that the diagonal joins.
short-edges = not compared: this polygon has edges shorter than a pixel, which scanlines can miss
exercise-by = exercise 1.6.25 b, answer C
diagonal-by = mean of the corners that the diagonal joins
position-1 = position 1
position-2 = position 2
diagonal-13-cut = diagonal 1–3 (triangles)
diagonal-24-cut = diagonal 2–4 (triangles)
oblique-scanline-measure = oblique view, change by a rotation of 90°: scanline
oblique-scanline-by = the line from corner 3 to 1, then the line from 2 to 4, interpolated by distances in the picture
oblique-triangles-measure = oblique view, change by a rotation of 90°: triangles
oblique-triangles-by =
    s/2d of the difference between corners 1 and 3, because the edge between them changes depth in one position only
oblique-perspective-measure = oblique view, change by a rotation of 90°: triangles, perspective-correct
oblique-perspective-by = 0, because interpolation by 1/depth follows the polygon
back-scanline-by = the scanline formula at every pixel, 0 in triangles; tolerance: corners snap to 1/256 pixel
seam-effect = largest change of a pixel's colour after a rotation by 90° and back
diagonal-13-seen = The colours are the same in any orientation.
halves-title = scanline: 0° top, 90° bottom
halves-seen = The two halves do not match at the seam.
halves-triangles-title = triangles: 0° top, 90° bottom
halves-triangles-caption = The same comparison in triangles.
halves-triangles-seen = There is no seam.
position-1-title = scanline, 0°
position-1-seen = After a rotation it has other colours.
turned-title = scanline, { $turn }°
turned-seen = The colours change with the rotation.
position-2-title = scanline, 90°
position-2-seen = The same polygon has other colours.
difference-title = difference, 90° and back
difference-caption =
    Difference between the unrotated polygon and the polygon drawn at 90° and rotated back. Dark is 0, yellow is
    { $full } of the full range in a component.
diagonals-title =
    { $shape ->
        [diamond] difference of the diagonals
       *[polygon] triangulation difference
    }
diagonals-caption = Difference between the two triangulations. Yellow is { $full } of the full range in a component.
r-scanline-curve = R, scanline
g-scanline-curve = G, scanline
b-scanline-curve = B, scanline
g-triangles-curve = G, triangles
r-law-curve = R, formula
g-law-curve = G, formula
b-law-curve = B, formula
centre-title = Colour at the centre over a rotation
centre-caption =
    With the scanline algorithm, the colour at the centre changes by up to { $bad } over a full rotation, like the
    formula. In triangles it changes by up to { $cured }.
centre-x = rotation, degrees
centre-y = linear component
turned-scanline-measure = scanline: change of the colour at the centre by a rotation of { $turn }°
turned-triangles-measure = triangles: change of the colour at the centre by a rotation of { $turn }°
turned-scanline-by = { law-by }
turned-triangles-by = { triangles-change-by }
largest-change-by = { law-by }
mean-change-by = { law-by }
seam-cure = { centre-cure }
back-scanline-measure = scanline: change after a rotation by 90° and back (rms)
back-triangles-measure = triangles: change after a rotation by 90° and back (rms)
back-perspective-measure = triangles, perspective-correct: change after a rotation by 90° and back (rms)
back-triangles-by = { back-scanline-by }
back-perspective-by = { back-scanline-by }
exercise-measure = { $case }: { $component } at the centre
diagonal-measure = { exercise-measure }
diagonal-24-seen = { diagonal-13-seen }
halves-caption =
    Top: the unrotated polygon. Bottom: the polygon drawn at 90° and rotated back.{ $shape ->
        [diamond] {" "}Corner 1 is on the right, 2 at the top, 3 on the left (the brightest), 4 at the bottom (olive).
       *[polygon] {""}
    }
position-1-caption =
    { $shape ->
        [diamond] Position 1: the scanline through the centre runs from corner 3 to corner 1.
       *[polygon] No rotation: every pixel is interpolated between the two edges that its scanline meets first.
    }
turned-caption =
    { $shape ->
        [diamond] Rotated by { $turn }°: the scanline through the centre meets other edges, at other points.
       *[polygon] Rotated by { $turn }°: scanlines cross the edges at other points.
    }
position-2-caption =
    { $shape ->
        [diamond] Position 2: the scanline through the centre runs from corner 2 to corner 4.
       *[polygon] Rotated by 90°: scanlines cross other edges.
    }
diagonal-13-title =
    { $shape ->
        [diamond] triangles, diagonal 1–3
       *[polygon] first triangulation
    }
diagonal-13-caption =
    { $shape ->
        [diamond]
            Diagonal from corner 1 to corner 3: the result of scanlines in position 1, whose middle scanline is this
            diagonal.
       *[polygon] The polygon divided into triangles.
    }
diagonal-24-title =
    { $shape ->
        [diamond] triangles, diagonal 2–4
       *[polygon]
            { $cuts ->
                [one] same triangulation
               *[two] second triangulation
            }
    }
diagonal-24-caption =
    { $shape ->
        [diamond] Diagonal from corner 2 to corner 4: the result of scanlines in position 2.
       *[polygon]
            { $cuts ->
                [one] No other triangulation lies inside this polygon, so this is the same one.
               *[two] Another triangulation of the same polygon.
            }
    }
