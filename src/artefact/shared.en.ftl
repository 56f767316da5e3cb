half-step = half an 8-bit step
half-pixel = half a pixel
half-step-of-tilt = a tilt that changes diffuse light from the side by half an 8-bit step
caption = { $drawn } ({ $name }: { $value }).
nothing-to-cure = There was nothing to cure here, { $without } without it
too-little = It does too little here, { $without } without it
not-lit = Nothing is lit here
no-artefact = Nothing of the artefact is measured here
