//! How a material looks, as far as formats can tell it each other.

use std::fmt::Write as _;

/// What a material library says of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Look {
    pub name: String,
    /// The diffuse colour, `Kd`.
    pub diffuse: Option<[f32; 3]>,
    /// The exponent of the highlight, `Ns`.
    pub shininess: Option<f32>,
    /// 1 is opaque: `d`, or 1 − `Tr`.
    pub opacity: Option<f32>,
    /// How many textures it names.
    pub textures: usize,
}

impl Look {
    /// The members of a glTF material behind its name, each with a comma in front.
    ///
    /// The diffuse colour is the base colour of a dielectric, number for number. A highlight of exponent n belongs to
    /// a surface of α = √(2/(n + 2)) (Walter et al., "Microfacet models for refraction", 2007, eq. 30 with
    /// n ≈ 2/α² − 2), and glTF's roughness is √α.
    pub fn gltf_members(&self) -> String {
        let unit = |value: f32| value.clamp(0.0, 1.0);
        let mut json = String::new();
        if self.diffuse.is_none() && self.shininess.is_none() && self.opacity.is_none() {
            return json;
        }
        json.push_str(",\"pbrMetallicRoughness\":{");
        if self.diffuse.is_some() || self.opacity.is_some() {
            let [r, g, b] = self.diffuse.unwrap_or([1.0; 3]).map(unit);
            let _ = write!(json, "\"baseColorFactor\":[{r},{g},{b},{}],", unit(self.opacity.unwrap_or(1.0)));
        }
        json.push_str("\"metallicFactor\":0");
        if let Some(exponent) = self.shininess {
            let alpha = (2.0 / (f64::from(exponent.max(0.0)) + 2.0)).sqrt();
            let _ = write!(json, ",\"roughnessFactor\":{}", alpha.sqrt() as f32);
        }
        json.push('}');
        if self.opacity.is_some_and(|opacity| opacity < 1.0) {
            json.push_str(",\"alphaMode\":\"BLEND\"");
        }
        json
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_look_is_told_in_the_terms_of_gltf() {
        let mut look = Look { name: "x".into(), textures: 1, ..Look::default() };
        assert_eq!(look.gltf_members(), "");
        // An exponent of 30 means α = 1/4 and a roughness of 1/2.
        look.shininess = Some(30.0);
        look.diffuse = Some([0.5, 0.0, 2.0]);
        assert_eq!(
            look.gltf_members(),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0,1,1],\"metallicFactor\":0,\"roughnessFactor\":0.5}"
        );
        let glass = Look { opacity: Some(0.25), ..Look::default() };
        assert_eq!(
            glass.gltf_members(),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,0.25],\"metallicFactor\":0},\"alphaMode\":\"BLEND\""
        );
        let dull = Look { shininess: Some(0.0), ..Look::default() };
        assert!(dull.gltf_members().contains("\"roughnessFactor\":1}"));
    }
}
