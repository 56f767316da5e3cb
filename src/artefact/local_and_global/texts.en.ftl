title = Ambient light does not make Phong's model global
claim = Phong's model is global, because its ambient term includes the light from the rest of the scene.
source-1 = Lectures: exercises 1.6.20, 1.6.34 and 1.6.39 (which deny it)
source-2 = Ray tracing: T. Whitted, An improved illumination model for shaded display, Communications of the ACM 23(6), 1980
formula-1 = {"I = k_a I_a + k_d I_d (N·L)"}
formula-1-says = the local model: the same sum in the light and in the shadow of another object
formula-2 = {"I = k_a I_a + V k_d I_d (N·L) + k_r I_r + k_t I_t"}
formula-2-says =
    Whitted's model: V is 0 if an object hides the lamp and 1 if not; I_r and I_t are the light along the reflected and the
    refracted ray
shown-by = Use larger pictures (--size) to show it.
shadow-local-measure = floor in the shadow of the ball, local model
shadow-local-by = k_a I_a + k_d I_d (N·L), as on the lit floor; tolerance: single precision
shadow-traced-measure = floor in the shadow of the ball, traced
shadow-traced-by = k_a I_a; tolerance: single precision
shadow-dark-measure = floor in the shadow of the ball, traced without ambient light
shadow-dark-by = 0: only ambient light reaches it; tolerance: single precision
mirror-local-measure = mirror in front of the lit floor, local model
mirror-local-by = 0: the mirror has no colour of its own; tolerance: single precision
mirror-traced-measure = mirror in front of the lit floor, traced
mirror-traced-by = k_r times the light of the floor; tolerance: single precision
share-shadow-measure = squared differences in the shadow, on the floor
share-mirror-measure = squared differences in the mirror
share-glass-measure = squared differences in the glass ball
share-elsewhere-measure = squared differences elsewhere
share-elsewhere-by = 0: without shadow, mirror and glass, both models are the same; tolerance: rounding
ball-measure = opaque ball: largest difference
ball-by = 0: nothing hides the lamp from it; tolerance: half an 8-bit step
global-effect = difference from the traced picture with 24 reflections and refractions (rms)
global-cure = traced rays, 8 reflections and refractions
ambient-effect = difference from the traced picture with ambient light (rms)
ambient-cure = ambient light
fails =
    ambient light is one constant, added everywhere. It keeps surfaces visible that the lamp does not reach, but it has
    no shadows, no mirror images and no refraction. All differences are located there.
local-title = Phong's local model
local-caption = A ball, a mirror and a glass ball under a distant lamp and ambient light of { $ambient }, with Phong's local model.
local-seen = There is no shadow, and the mirror and the glass are black.
traced-title = traced
traced-caption = The same scene, traced with shadows, reflection and refraction.
traced-seen = The balls have shadows, the mirror shows the scene, and the glass ball shows it inverted.
difference-title = difference
difference-caption = Difference between the local and the traced picture: violet is 0, yellow is { $full } or more.
dark-title = traced, no ambient light
dark-caption = The scene traced without ambient light.
dark-seen = Surfaces that the lamp does not reach are black.
lit-title = traced, ambient light
lit-caption = The scene traced with ambient light of { $ambient }.
lit-seen = Shadows keep the ambient light.
note-1 =
    Exercise 1.6.20 asks whether the ambient term makes the model global. It does not: a global model computes the light
    from the rest of the scene, and the ambient term estimates it as one constant.
note-2 =
    Exercise 1.6.39 asks whether an object without direct light can be visible. In a local model only ambient light makes
    it visible. In a global model, light from other surfaces does.
note-3 =
    Whitted's ray tracing is global for mirrored and refracted light only. It follows no light between diffuse surfaces,
    so it still needs ambient light. Transparent objects have full shadows, without caustics.
