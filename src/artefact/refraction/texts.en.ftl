title = Water looks three quarters as deep only from above
claim = A point in water seems to be at 1/n of its depth, and a glass ball has the focal length nR/(2(n − 1)).
source-1 = Lectures: ray tracing (“imagens com refrações”), exercise 1.6.34
source-2 = Ray tracing: T. Whitted, An improved illumination model for shaded display, Communications of the ACM 23(6), 1980
formula-1 = {"\\sin θ = n \\sin θ′, \\quad \\frac{d′}{d} = \\frac{\\tan θ′}{\\tan θ}"}
formula-1-says = Snell's law, and the apparent depth d′ of a point at the depth d, seen at the angle θ from the vertical
formula-2 = {"f(h) = \\frac{h}{\\sin\\left(2(\\arcsin\\frac{h}{R} − \\arcsin\\frac{h}{n R})\\right)}"}
formula-2-says =
    distance from the centre of a ball of radius R at which a ray that enters at the height h crosses the axis; for small
    h it is nR/(2(n − 1))
shown-by = Use larger pictures (--size) to show it.
depth-measure = water (n = { $water }): apparent depth over depth, { $view }° from the vertical
depth-by = tan θ′/tan θ; tolerance: positions on the bottom are colours in single precision
focus-measure = glass ball (n = { $glass }): focal length of the ray at { $height } R
focus-by = h/sin(2(arcsin(h/R) − arcsin(h/(nR)))); tolerance: positions on two screens are colours in single precision
paraxial-measure = glass ball: focal length in the limit of rays near the axis
paraxial-by = nR/(2(n − 1)); tolerance: the share (h/R)² for the height of the measured ray, and rounding
stick-effect = bottom of the water: displacement from Snell's law in the picture
stick-cure = refracted rays
power-effect = glass ball: difference of the reciprocal focal length from Snell's law
power-cure = refracted rays
why-power = a change of the focal length by less than a hundredth
holds-only-if =
    rays are close to the vertical or to the axis. At { $angle }° from the vertical, the water seems to have { $share } of its
    depth. Rays at 0.7 R meet the axis nearer to the ball than those close to the axis: this is spherical aberration.
stick-straight-title = stick, without refraction
stick-straight-caption = A stick in coloured water with the index 1, seen { $angle }° from the vertical. Light goes straight on.
stick-straight-seen = The stick is straight, and the water has its full depth.
stick-title = stick in water
stick-caption = The same stick and water with the index { $water }, traced.
stick-seen = The stick has a kink at the surface, and the bottom of the water seems higher.
ball-straight-title = ball, without refraction
ball-straight-caption = A ball with the index 1 in front of oblique stripes.
ball-straight-seen = The ball is invisible.
ball-title = glass ball
ball-caption = The same ball with the index { $glass }, traced.
ball-seen = The stripes in the ball are inverted, and compressed near its outline.
depth-by-angle-title = Apparent depth of water
depth-by-angle-caption =
    Apparent depth over depth, against the angle from the vertical. It starts at 1/n and falls to 0 for grazing views.
depth-by-angle-x = angle from the vertical, degrees
depth-by-angle-y = apparent depth over depth
focus-by-height-title = Focal length of a glass ball
focus-by-height-caption =
    Distance from the centre at which a ray crosses the axis, against its height. It starts at nR/(2(n − 1)) and falls
    with the height.
focus-by-height-x = height of the ray, radii
focus-by-height-y = focal length, radii
measured-curve = measured
law-curve = Snell's law
note-1 =
    A local model has no rays that go on, so it cannot draw refraction. Ray tracing follows each ray through the surface
    by Snell's law and divides its light by Fresnel's equations. It measures positions here: the colour of a screen is
    the position on it.
