title = A Blinn highlight needs four times the exponent of Phong
claim =
    Blinn's half-vector gives nearly the same highlight as Phong's reflected ray, but with a different exponent. The
    angle at the half-vector is half the angle at the reflected ray.
source-1 = Lectures: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23
source-2 = Ting 2008: “Phong modificado” (modified Phong)
source-3 = Paper: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994
formula-1 = {"(V·R)^n = \\cos(φ)^n ≈ \\cos(φ/2)^{4n} = (N·H)^{4n}"}
formula-1-says = in the plane of L and V; φ is the angle from the reflected ray to the viewer
formula-2 = {"\\frac{w_\\mathrm{across}}{w_\\mathrm{along}} ≈ \\frac{1}{\\cos(β/2)}"}
formula-2-says =
    stretch of the Phong highlight on a sphere perpendicular to the plane of L and V; β is the angle between them. The
    Blinn highlight is round
formula-3 = {"I_\\mathrm{behind} = k_s \\sin(β/2)^n"}
formula-3-says = Blinn highlight at the terminator, N·L = 0; without a guard it continues behind it
formula-4 = {"I_\\mathrm{behind} = k_s (−\\cos(β))^n"}
formula-4-says = Phong highlight at the terminator, if the light is behind, β > 90°
shown-by = Use a highlight of some pixels (exponents from 1 to 100, or a larger picture) to show it.
same-exponent-by = largest value over φ, by a scan of 10 001 angles; tolerance: half a pixel
highlight-below-pixel = not compared: the highlight is hardly wider than a pixel
width-phong-measure = light at 120°: Phong highlight, width across over width along
width-phong-by = closed form of the half-widths at half height; 2 for narrow highlights
width-blinn-measure = light at 120°: Blinn highlight, width across over width along
width-blinn-by = 1, because the highlight is round
exponent-effect = largest difference from the Phong highlight
exponent-cure = four times the exponent
width-effect = width across over width along, minus 1, if both are measurable
why-width = a tenth of its width
same-exponent-measure = Blinn with n: largest difference
fourfold-exponent-measure = Blinn with 4n: largest difference
phong-title = Phong, exponent n
phong-caption = Phong highlight on a sphere, with light and viewer in front; n = { $exponent }.
blinn-same-n-title = Blinn, exponent n
blinn-same-n-caption = Blinn highlight with the same exponent.
blinn-4n-title = Blinn, exponent 4n
blinn-4n-caption = Blinn highlight with four times the exponent.
blinn-4n-seen = It is much closer to the Phong highlight.
phong-grazing-title = Phong, light at 120°
phong-grazing-caption = Phong highlight with the light at 120°, n = { $exponent }.
phong-grazing-seen =
    Here the Phong highlight is wrong: it is stretched vertically, across the plane of light and view. Real rough
    surfaces do not show this.
blinn-grazing-title = Blinn 4n, light at 120°
blinn-grazing-caption = Blinn highlight in the same light, with 4n = { $blinn-exponent }.
blinn-grazing-seen = It is a circle on the sphere, cut off at the terminator.
note-1 =
    The lectures (1.6.19) use one exponent for both models, although the Blinn highlight is wider with the same
    exponent. Ting 2008 uses a separate exponent for Blinn. The guard removes light from behind but leaves an edge,
    because neither model is 0 where N·L is 0.
holds-only-if =
    the Blinn exponent is 4n and the light is near the view direction. With the same n the Blinn highlight is twice as
    wide. In grazing light the Phong highlight is stretched and the Blinn highlight stays round; both need a guard
    against light from behind.
fails =
    with an exponent this small, no other exponent makes both models equal. cos(φ)^n and cos(φ/2)^4n agree near φ = 0,
    and this highlight is as wide as the sphere.
highlights-title = Highlight by angle
highlights-x = angle from the reflected ray to the viewer, degrees
highlights-y = highlight
behind-effect = brightest pixel that faces away from the light
behind-phong-by = (R·V)^n at these pixel centres, at most (−cos(β))^n; tolerance: single precision
behind-by = (N·H)^n at these pixel centres, at most sin(β/2)^n; tolerance: single precision
behind-measure = Blinn, light at { $behind }°, no guard: brightest pixel that faces away from the light
behind-guarded-measure = Blinn, the same light with the guard: brightest pixel that faces away
behind-guarded-by = 0: no light from behind
behind-seen = The highlight spreads over the dark side.
behind-guarded-caption = The same light with the guard N·L > 0.
behind-guarded-seen = The highlight ends at the terminator, with a hard edge.
highlight-too-wide = not compared: the highlight is as wide as the lit and visible part of the sphere
highlight-too-narrow = not compared: the highlight is narrower than three pixels
fourfold-exponent-by = { same-exponent-by }
width-cure = { blinn-grazing-title }
behind-cure = the guard N·L > 0
blinn-same-n-seen =
    It is wider: it is at half height where the normal is { $blinn-angle }° from the viewer, the Phong highlight at
    { $phong-angle }°.
highlights-caption =
    Highlight against the angle between reflected ray and viewer. { $is-cured ->
        [yes] The Blinn curve is wide with the same exponent, and close to the Phong curve with four times the exponent.
       *[no]
            With an exponent this small, the Blinn curve differs from the Phong curve, also with four times the
            exponent.
    }
phong-curve = { phong-title }
blinn-same-n-curve = { blinn-same-n-title }
blinn-4n-curve = { blinn-4n-title }
behind-phong-measure = Phong, light at { $behind }°, no guard: brightest pixel that faces away from the light
behind-phong-guarded-measure = Phong, the same light with the guard: brightest pixel that faces away
behind-phong-guarded-by = { behind-guarded-by }
behind-title = Blinn, light behind, no guard
behind-guarded-title = Blinn, light behind, guard
behind-phong-title = Phong, light behind, no guard
behind-phong-guarded-title = Phong, light behind, guard
behind-caption = Blinn highlight with n = { $exponent }; the light is at { $behind }°, almost behind the sphere.
behind-phong-caption = Phong highlight with n = { $exponent }; the light is at { $behind }°, almost behind the sphere.
behind-phong-seen = { behind-seen }
behind-phong-guarded-caption = { behind-guarded-caption }
behind-phong-guarded-seen = { behind-guarded-seen }
