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
largest-over-scan = the largest over φ, by a scan of 10 001 angles; half a pixel
untested-highlight-hardly-wider = the highlight is hardly wider than a pixel
light-phong-highlight = light at 120°: Phong's highlight, width across over width along
half-widths-half = half-widths at half height in closed form; 2 for narrow highlights
light-blinn-highlight = light at 120°: Blinn's highlight, width across over width along
round = round
moved = largest difference from Phong's highlight
cure = four times the exponent
moved-width-across-over = width across over width along, less 1
moved-width-across-over-width = width across over width along, less 1, where both can be told
why-tenth-width = a tenth of its width
measure-same-n-largest = same n: largest difference
measure-blinn-n-largest = Blinn with 4n: largest difference
phong-title = Phong, exponent n
phong-caption-phong-highlight-sphere = Phong's highlight on a sphere, light and viewer in front; n = { $exponent }.
blinn-same-n-title = Blinn, exponent n
blinn-same-n-caption-blinn-same-exponent = Blinn's with the same exponent.
blinn-4n-title = Blinn, exponent 4n
blinn-4n-caption-blinn-four-times = Blinn's with four times the exponent.
blinn-4n-caption-much-closer-phong = It is much closer to Phong's.
phong-grazing-title = Phong, light at 120°
phong-grazing-caption-light-far-round = Light from far round, n = { $exponent }.
phong-grazing-caption-here-phong-highlight =
    Here it is Phong's highlight that errs: it is drawn out up and down, across the plane of light and view, as real
    rough surfaces do not show it.
blinn-grazing-title = Blinn 4n, light at 120°
blinn-grazing-caption-blinn-under-same = Blinn's under the same light, with 4n = { $blinn-exponent }.
blinn-grazing-caption-circle-sphere-cut = It is a circle on the sphere, cut where the sphere turns away from the light.
note-lectures-give-both =
    The lectures (1.6.19) give both models one exponent, though with the same one Blinn's highlight is wider; Ting 2008
    gives Blinn's one of its own. The guard stops light from behind but leaves an edge, for neither model goes to 0
    where N·L does.
holds-only-if-blinn-exponent-n =
    Blinn's exponent is 4n and the light is near the direction of view. With the same n his highlight is twice as wide;
    at grazing light Phong's is stretched where Blinn's stays round. Both need a guard against light from behind.
fails-small-exponent-no =
    with so small an exponent no other one makes both alike: cos(φ)^n and cos(φ/2)^4n agree near φ = 0, and this
    highlight is as wide as the sphere.
chart-title = Height of the highlight
chart-caption =
    Against the angle from mirrored ray to viewer: Blinn's with the same exponent is wide, with four times the exponent
    its curve comes close to Phong's.
chart-caption-against-angle-mirrored =
    Against the angle from mirrored ray to viewer: with so small an exponent Blinn's curve leaves Phong's, with four
    times the exponent too.
axis-degrees = φ in degrees
axis-highlight = highlight
moved-brightest-pixel-faces = brightest pixel that faces away from the light
r-v-n = (R·V)^n at the centres of these pixels, at most (−cos(β))^n; single precision
n-h-n = (N·H)^n at the centres of these pixels, at most sin(β/2)^n; single precision
name-light-no = { $name }, light at 150°, no guard: brightest pixel that faces away from the light
name-same-guard = { $name }, the same with the guard
by-nothing-behind = nothing from behind
highlight-n-exponent = 's highlight with n = { $exponent }, the light at { $value }°, almost behind the sphere.
shot-yet-highlight-spreads = Yet the highlight spreads over its dark side.
shot-guard-n-l = With the guard N·L > 0.
shot-highlight-ends-light = The highlight ends where the light does, at a hard edge.
untested-highlight-wide-part = the highlight is as wide as the part of the sphere that is lit and seen
untested-highlight-narrower-three = the highlight is narrower than three pixels
straight-lines-between = straight lines between pixel centres
