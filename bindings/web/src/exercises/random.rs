//! Random numbers in place of the printed ones: the same for the same seed, on every machine.

use crease::num::LinearRgb;
use crease::raster::SceneFile;
use crease::shade::{Light, Reflectance};

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number of tenths from `least` to `most`.
    fn tenths(&mut self, [least, most]: [u64; 2]) -> f64 {
        (least + self.next() % (most - least + 1)) as f64 / 10.0
    }

    /// Random tenths for the components that are not zero.
    fn colour(&mut self, colour: LinearRgb) -> LinearRgb {
        colour.to_array().map(|c| if c == 0.0 { 0.0 } else { self.tenths([1, 10]) }).into()
    }

    fn reflectance(&mut self, reflectance: Reflectance) -> Reflectance {
        match reflectance {
            Reflectance::Split { k: 0.0, .. } => reflectance,
            Reflectance::Split { colour, .. } => Reflectance::Split { k: self.tenths([1, 6]), colour },
            Reflectance::Merged(colour) => Reflectance::Merged(self.colour(colour)),
        }
    }
}

/// Changes materials, colours of lights and given colours; geometry stays.
pub(super) fn vary(file: &mut SceneFile, seed: u32) {
    let mut random = Random(u64::from(seed));
    for object in &mut file.objects {
        let material = &mut object.material;
        material.ambient = random.reflectance(material.ambient);
        material.diffuse = random.reflectance(material.diffuse);
        material.specular = random.reflectance(material.specular);
        material.exponent = 1.0 + (random.next() % 5) as f64;
    }
    for light in file.lights.iter_mut().flatten() {
        match light {
            Light::Ambient { colour }
            | Light::Directional { colour, .. }
            | Light::Point { colour, .. }
            | Light::Spot { colour, .. }
            | Light::Area { colour, .. } => *colour = random.colour(*colour),
        }
    }
    // Instances of one polygon have the same colours.
    let count = file.meshes.iter().filter_map(|mesh| mesh.colours.as_ref()).map(Vec::len).max().unwrap_or(0);
    let colours: Vec<LinearRgb> =
        (0..count).map(|_| [(); 3].map(|()| random.tenths([0, 10])).into()).collect();
    for own in file.meshes.iter_mut().filter_map(|mesh| mesh.colours.as_mut()) {
        own.iter_mut().zip(&colours).for_each(|(own, &colour)| *own = colour);
    }
}
