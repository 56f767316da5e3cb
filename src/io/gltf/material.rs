//! Materials of other formats in the terms of glTF.

use crate::io::{FileMaterial, FileReflection};
use std::fmt::Write as _;

/// The members of a glTF material behind its name, each with a comma in front.
///
/// The diffuse colour is the base colour of a dielectric, number for number. A highlight of exponent n belongs to
/// a surface of α = √(2/(n + 2)) (Walter et al., "Microfacet models for refraction", 2007, eq. 30 with
/// n ≈ 2/α² − 2), and glTF's roughness is √α.
pub fn members(material: &FileMaterial) -> String {
    let unit = |value: f64| value.clamp(0.0, 1.0);
    let (base, metallic, roughness) = match material.reflection {
        FileReflection::Phong { diffuse, exponent, .. } => {
            (diffuse, 0.0, exponent.map(|n| (2.0 / (n.max(0.0) + 2.0)).sqrt().sqrt()))
        }
        FileReflection::MetallicRoughness { base_colour, metallic, roughness, .. } => {
            (Some(base_colour), metallic, Some(roughness))
        }
    };
    let mut json = String::new();
    if base.is_none() && roughness.is_none() && material.opacity.is_none() {
        return json;
    }
    json.push_str(",\"pbrMetallicRoughness\":{");
    if base.is_some() || material.opacity.is_some() {
        let [r, g, b] = base.unwrap_or([1.0; 3]).map(unit);
        let opacity = unit(material.opacity.unwrap_or(1.0));
        let _ = write!(json, "\"baseColorFactor\":[{r},{g},{b},{opacity}],");
    }
    let _ = write!(json, "\"metallicFactor\":{metallic}");
    if let Some(roughness) = roughness {
        let _ = write!(json, ",\"roughnessFactor\":{}", roughness as f32);
    }
    json.push('}');
    if material.opacity.is_some_and(|opacity| opacity < 1.0) {
        json.push_str(",\"alphaMode\":\"BLEND\"");
    }
    json
}

#[cfg(test)]
mod tests {
    use super::*;

    fn members_of(diffuse: Option<[f64; 3]>, exponent: Option<f64>, opacity: Option<f64>) -> String {
        let reflection = FileReflection::Phong { ambient: None, diffuse, specular: None, exponent };
        members(&FileMaterial { name: "x".into(), reflection, opacity, textures: 1 })
    }

    #[test]
    fn a_material_is_reported_in_the_terms_of_gltf() {
        assert_eq!(members_of(None, None, None), "");
        // An exponent of 30 means α = 1/4 and a roughness of 1/2.
        assert_eq!(
            members_of(Some([0.5, 0.0, 2.0]), Some(30.0), None),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0,1,1],\"metallicFactor\":0,\"roughnessFactor\":0.5}"
        );
        assert_eq!(
            members_of(None, None, Some(0.25)),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,0.25],\"metallicFactor\":0},\"alphaMode\":\"BLEND\""
        );
        assert!(members_of(None, Some(0.0), None).contains("\"roughnessFactor\":1}"));
        let reflection = FileReflection::MetallicRoughness {
            base_colour: [0.1, 0.2, 0.3],
            metallic: 1.0,
            roughness: 0.5,
            unlit: false,
        };
        let gold = FileMaterial { name: "gold".into(), reflection, opacity: None, textures: 0 };
        assert_eq!(
            members(&gold),
            ",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.2,0.3,1],\"metallicFactor\":1,\"roughnessFactor\":0.5}"
        );
    }
}
