title = Self-shadowing facets make the terminator jagged
claim =
    Shading and geometry disagree where the interpolated normal faces the light but the facet does not. If facets shadow
    themselves, the terminator follows their edges, and whole facets pop when the light moves.
source-1 = Paper: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks
source-2 = Lectures: 1.5.2.2, 1.6.13 (errors of vertex normals, which Phong shading keeps)
formula-1 = {"N·L > 0 ≥ N_g·L"}
formula-1-says = condition for an affected pixel: N is the interpolated normal, N_g the normal of the facet
formula-2 = {"G = −g^3 + g^2 + g, \\quad g = \\frac{N_g·L}{(N·L) (N_g·N)}"}
formula-2-says =
    factor by Chiang, Li and Burley for 0 ≤ g < 1; it is 0 below and 1 above. The light fades as the facet turns away
formula-3 = {"ΔI = \\sin(Δ/2)"}
formula-3-says = sudden change of luminance without this factor, at the bright edge of a facet with the angle Δ
shown-by = Use light from the side (--light 80) and at most 16 segments to show it.
shadow-effect = mean error of light on affected pixels, compared with the exact sphere
shadow-cure = no self-shadowing
cost-effect = largest reduction of light by the softening term at a pixel
cost-cure = finer facets
pop-cure = softening term by Chiang, Li and Burley
pop-hard-by = the formula at every pixel centre in double precision; tolerance: edges snap to 1/256 pixel
prism-share-measure = prism: share of affected pixels
prism-share-by =
    both cosines at every pixel centre in double precision; tolerance: pixels with an edge or a change of sign within
    1/256 pixel
sphere-share-measure = sphere: share of affected pixels
sphere-shadow-measure = sphere: most light that self-shadowing removes from a pixel
holds-only-if =
    facets shadow themselves, as they do when shadows are cast. Without shadows, as in the lectures, light on facets
    that face away is not a visible error. The softening term removes the popping, but not the corners of the
    terminator, and darkens obliquely lit facets; both errors fall with the facet size.
hard-title = self-shadowing facets
hard-caption = Smooth normals, but facets that face away from the light are dark.
hard-seen = The terminator is a jagged line along the edges of triangles.
smooth-title = no self-shadowing
smooth-caption = Only the interpolated normals determine the light, as in the lectures.
smooth-seen = The terminator is smooth; facets that face away are lit too.
concerned-title = affected pixels
concerned-caption = Yellow where the interpolated normal faces the light and the facet does not.
film-hard-title = light rotates: facet pops
film-hard-caption =
    A prism in successive pictures, from top to bottom. The light rotates by { $step }° between two of them.
film-hard-seen =
    The facet left of the middle is lit in the upper four pictures and black in the lower four: it turns dark at once.
film-soft-title = softened: facet fades
film-soft-caption = The same pictures with the softening term.
film-soft-seen = The facet becomes darker from picture to picture, without a sudden change.
soft-title = softened, same mesh
soft-caption = The cost of the softening term.
soft-seen =
    Obliquely lit facets are too dark, so facets are visible in the lit part too. A still picture does not benefit from
    the term.
soft-fine-title = softened, finer
soft-fine-caption = The sphere with { $finest } segments and the softening term.
note-1 =
    The factor is continuous. It is 0 where the cosine of the facet, N_g·L, is 0. It is 1 where that cosine is at least
    (N·L) (N_g·N). It depends only on the two normals and the light.
note-2 =
    There are three lights. The light of the sphere is { $light }° to the side of the viewer and 25° above, so the
    terminator crosses facets obliquely. The light for counting pixels of the prism is also at { $light }°, but
    horizontal; if the terminator of the prism is not visible, no pixel is affected. The light of the films is
    horizontal and rotates to both sides of the angle at which the facet left of the middle turns away.
smooth-curve = only interpolated normal
soft-curve = softened
popping-title = One facet as the light rotates
popping-caption =
    Luminance at the bright edge of one facet against the angle of the light. Where the facet turns away, luminance
    drops at once; with the softening term, it fades.
popping-x = angle of the light in degrees
popping-y = luminance
hard-curve = { hard-title }
pop-soft-by = { pop-hard-by }
pop-effect = prism: largest change on a facet when the light rotates by { $turn }°
pop-hard-measure = prism, light rotated by { $turn }°: largest change on a facet, self-shadowing
pop-soft-measure = prism, light rotated by { $turn }°: largest change on a facet, softened
fine-sphere-share-measure = sphere with { $finest } segments: share of affected pixels
soft-fine-seen = Facets are hardly larger than pixels, and the terminator is smooth.
