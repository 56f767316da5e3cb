half-step = half an 8-bit step
half-pixel = half a pixel
half-step-of-tilt = a tilt that changes diffuse light from the side by half an 8-bit step
caption = { $drawn } ({ $name }: { $value }).
nothing-to-cure = There is no artefact to cure here: { $without } without the cure
too-little = The cure does too little here: { $without } without it
not-lit = Nothing is lit here
no-artefact = No artefact is measured here
