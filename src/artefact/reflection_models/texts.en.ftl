title = Phong's highlight and Blinn's
claim =
    Blinn's half-vector gives about the highlight of Phong's mirrored ray, but with a different exponent, for the angle
    at the half-vector is half of that at the mirrored ray.
source-1 = Lectures: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23
source-2 = Ting 2008: “Phong modificado” (modified Phong)
source-3 = Paper: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994
formula-1 = {"(V·R)^n = \\cos(φ)^n ≈ \\cos(φ/2)^{4n} = (N·H)^{4n}"}
formula-1-says = in the plane of L and V, φ the angle from the mirrored ray to the viewer
formula-2 = {"\\frac{w_\\mathrm{across}}{w_\\mathrm{along}} ≈ \\frac{1}{\\cos(β/2)}"}
formula-2-says =
    how much Phong's highlight on a sphere is stretched at right angles to the plane of L and V, β the angle between
    them; Blinn's is round
formula-3 = {"I_\\mathrm{behind} = k_s \\sin(β/2)^n"}
formula-3-says = Blinn's highlight at the border of light, N·L = 0: without a guard it goes on behind
formula-4 = {"I_\\mathrm{behind} = k_s (−\\cos(β))^n"}
formula-4-says = the same of Phong's, where the light is behind at all, β > 90°
shown-by = a highlight of some pixels (exponents from 1 to 100, or a larger picture) would show it.
same-exponent-by = the largest over φ, by a scan of 10 001 angles; half a pixel
highlight-below-pixel = the highlight is hardly wider than a pixel
width-phong-measure = light at 120°: Phong's highlight, width across over width along
width-phong-by = half-widths at half height in closed form; 2 for narrow highlights
width-blinn-measure = light at 120°: Blinn's highlight, width across over width along
width-blinn-by = round
exponent-effect = largest difference from Phong's highlight
exponent-cure = four times the exponent
width-effect = width across over width along, less 1, where both are measurable
why-width = a tenth of its width
same-exponent-measure = same n: largest difference
fourfold-exponent-measure = Blinn with 4n: largest difference
phong-title = Phong, exponent n
phong-caption = Phong's highlight on a sphere, light and viewer in front; n = { $exponent }.
blinn-same-n-title = Blinn, exponent n
blinn-same-n-caption = Blinn's with the same exponent.
blinn-4n-title = Blinn, exponent 4n
blinn-4n-caption = Blinn's with four times the exponent.
blinn-4n-seen = It is much closer to Phong's.
phong-grazing-title = Phong, light at 120°
phong-grazing-caption = Light from far round, n = { $exponent }.
phong-grazing-seen =
    Here it is Phong's highlight that errs: it is drawn out up and down, across the plane of light and view, as real
    rough surfaces do not show it.
blinn-grazing-title = Blinn 4n, light at 120°
blinn-grazing-caption = Blinn's under the same light, with 4n = { $blinn-exponent }.
blinn-grazing-seen = It is a circle on the sphere, cut where the sphere turns away from the light.
note-1 =
    The lectures (1.6.19) give both models one exponent, though with the same one Blinn's highlight is wider; Ting 2008
    gives Blinn's one of its own. The guard stops light from behind but leaves an edge, for neither model goes to 0
    where N·L does.
holds-only-if =
    Blinn's exponent is 4n and the light is near the direction of view. With the same n his highlight is twice as wide;
    at grazing light Phong's is stretched where Blinn's stays round. Both need a guard against light from behind.
fails =
    with so small an exponent no other one makes both alike: cos(φ)^n and cos(φ/2)^4n agree near φ = 0, and this
    highlight is as wide as the sphere.
highlights-title = Height of the highlight
highlights-x = φ in degrees
highlights-y = highlight
behind-effect = brightest pixel that faces away from the light
behind-phong-by = (R·V)^n at the centres of these pixels, at most (−cos(β))^n; single precision
behind-by = (N·H)^n at the centres of these pixels, at most sin(β/2)^n; single precision
behind-measure = Blinn, light at { $behind }°, no guard: brightest pixel that faces away from the light
behind-guarded-measure = Blinn, the same with the guard
behind-guarded-by = nothing from behind
behind-seen = Yet the highlight spreads over its dark side.
behind-guarded-caption = With the guard N·L > 0.
behind-guarded-seen = The highlight ends where the light does, at a hard edge.
highlight-too-wide = the highlight is as wide as the part of the sphere that is lit and seen
highlight-too-narrow = the highlight is narrower than three pixels
fourfold-exponent-by = { same-exponent-by }
width-cure = { blinn-grazing-title }
behind-cure = the guard N·L > 0
blinn-same-n-seen =
    It is wider: at half its height where the normal is { $blinn-angle }° off the viewer, Phong's at { $phong-angle }°.
highlights-caption =
    Against the angle from mirrored ray to viewer: { $is-cured ->
        [yes]
            Blinn's with the same exponent is wide, with four times the exponent its curve comes close to Phong's.
       *[no] with so small an exponent Blinn's curve leaves Phong's, with four times the exponent too.
    }
phong-curve = { phong-title }
blinn-same-n-curve = { blinn-same-n-title }
blinn-4n-curve = { blinn-4n-title }
behind-phong-measure = Phong, light at { $behind }°, no guard: brightest pixel that faces away from the light
behind-phong-guarded-measure = Phong, the same with the guard
behind-phong-guarded-by = { behind-guarded-by }
behind-title = Blinn, light behind, no guard
behind-guarded-title = Blinn, light behind, guard
behind-phong-title = Phong, light behind, no guard
behind-phong-guarded-title = Phong, light behind, guard
behind-caption = Blinn's highlight with n = { $exponent }, the light at { $behind }°, almost behind the sphere.
behind-phong-caption = Phong's highlight with n = { $exponent }, the light at { $behind }°, almost behind the sphere.
behind-phong-seen = { behind-seen }
behind-phong-guarded-caption = { behind-guarded-caption }
behind-phong-guarded-seen = { behind-guarded-seen }
