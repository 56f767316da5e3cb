nothing-cure-here = There was nothing to cure here, { $without } without it.
does-too-little = It does too little here, { $without } without it.
nothing-lit-here = Nothing is lit here.
nothing-artefact-measured = Nothing of the artefact is measured here.
