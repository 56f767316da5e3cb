title = The shading terminator
claim =
    Where interpolated normals still face the light and the facet itself does not, shading and geometry disagree. If
    facets shade themselves, the border of light runs along their edges, and whole facets pop when the light moves.
source-1 = Paper: M. J.-Y. Chiang, Y. K. Li, B. Burley, Taming the shadow terminator, SIGGRAPH 2019 Talks
source-2 = Lectures: 1.5.2.2, 1.6.13 (errors of vertex normals that Phong's shading keeps)
formula-1 = {"N·L > 0 ≥ N_g·L"}
formula-1-says = the pixels concerned: N interpolated, N_g that of the facet
formula-2 = {"G = −g^3 + g^2 + g, \\quad g = \\frac{N_g·L}{(N·L) (N_g·N)}"}
formula-2-says =
    Chiang, Li and Burley's factor for 0 ≤ g < 1, 0 below and 1 from 1 on: light goes out gradually as the facet turns
    away
formula-3 = {"ΔI = \\sin(Δ/2)"}
formula-3-says = how much a facet of the angle Δ lights up at once without it, at its bright edge
shown-by = light from the side (--light 80), on no more than 16 segments, would show it.
shadow-effect = mean error of light against the sphere itself, on the pixels concerned
shadow-cure = no shadow of their own
cost-effect = most light that the softening takes from a pixel
cost-cure = finer facets
pop-cure = Chiang, Li and Burley's softening term
pop-hard-by = the formula at every pixel's centre in double precision; edges snap to 1/256 pixel
prism-share-measure = prism: share of pixels concerned
prism-share-by =
    the two cosines at every pixel's centre in double precision; pixels with an edge or a change of sign within 1/256
    pixel
sphere-share-measure = sphere: share of pixels concerned
sphere-shadow-measure = sphere: most light that facets' own shadow takes from a pixel
holds-only-if =
    facets shade themselves, as they do where shadows are cast. Without shadows, as in the lectures, light on facets
    that face away is no fault that is seen. The softening term takes away the popping, not the corners of the border,
    and darkens facets that are lit askew: both go with finer meshes, as their facets' size.
hard-title = facets shade themselves
hard-caption = Smooth normals, but light ends where facets turn away.
hard-seen = The border is a saw of triangles.
smooth-title = no shadow of their own
smooth-caption = Interpolated normals alone decide, as in the lectures.
smooth-seen = Smooth, with light on facets that face away.
concerned-title = pixels concerned
concerned-caption = Yellow where the interpolated normal faces the light and the facet does not.
film-hard-title = the light turns: it pops
film-hard-caption = A prism from picture to picture, downwards: the light turns by { $step }° each time.
film-hard-seen =
    The facet left of the middle has light in the upper four and is black in the lower four: it goes out at once.
film-soft-title = softened: it fades
film-soft-caption = The same with the softening term.
film-soft-seen = That facet gets darker from picture to picture, and nothing pops.
soft-title = softened, as coarse
soft-caption = What the softening term costs.
soft-seen =
    Facets that are about to turn away are dim already, and show even in the light. A still picture is none the better
    for it.
soft-fine-title = softened, finer
soft-fine-caption = { $finest } segments and the softening term.
note-1 =
    The factor is continuous: it is 0 where the facet's own cosine N_g·L is, and 1 where that is at least (N·L) (N_g·N).
    It needs nothing but the two normals.
note-2 =
    There are three lights. The sphere's comes from { $light }° to the side of the viewer and 25° up, so that its border
    crosses facets askew. The one in which pixels of the prism are counted comes from { $light }° too, but level:
    where the prism's border is out of sight it concerns none. That of the films is level and turns about the angle at
    which the facet left of the middle turns away.
smooth-curve = interpolated normal alone
soft-curve = softened
popping-title = One facet as the light turns
popping-caption =
    Luminance at the bright edge of one facet against the angle of the light: where the facet turns away it goes out at
    once; softened, it fades.
popping-x = angle of the light in degrees
popping-y = luminance
hard-curve = { hard-title }
pop-soft-by = { pop-hard-by }
pop-effect = prism: largest change on a facet when the light turns by { $turn }°
pop-hard-measure = prism, light turned by { $turn }°: largest change on a facet, hard
pop-soft-measure = prism, light turned by { $turn }°: largest change on a facet, softened
fine-sphere-share-measure = sphere with { $finest } segments: share of pixels concerned
soft-fine-seen = Facets are hardly larger than pixels, and the border is smooth.
