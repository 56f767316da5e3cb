half-step = half a step of 8 bits
half-pixel = half a pixel
half-step-of-tilt = half a step of 8 bits of diffuse light from the side
caption = { $drawn } ({ $name }: { $value }).
nothing-to-cure = There was nothing to cure here, { $without } without it
too-little = It does too little here, { $without } without it
not-lit = Nothing is lit here
no-artefact = Nothing of the artefact is measured here
