//! What a material needs tangents for, and the texture coordinates whose directions they have.

use super::json::{Json, Value};
use super::records::{Primitive, Records};

/// A property of a material that is evaluated in tangent space. The official validator asks for tangents for the same ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TangentUse {
    NormalTexture,
    Anisotropy,
    ClearcoatNormalTexture,
}

impl TangentUse {
    /// In the order in which their textures determine the coordinates of tangents.
    const ALL: [Self; 3] = [Self::NormalTexture, Self::Anisotropy, Self::ClearcoatNormalTexture];

    pub fn words(self) -> &'static str {
        match self {
            Self::NormalTexture => "its normal texture",
            Self::Anisotropy => "its anisotropy",
            Self::ClearcoatNormalTexture => "the normal texture of its clear coat",
        }
    }

    /// Whether a material has this property, and the reference to its texture.
    fn find(self, json: &Json, material: Value) -> Option<Option<Value>> {
        let extension = |name: &str| json.member(json.member(material, "extensions")?, name);
        match self {
            Self::NormalTexture => json.member(material, "normalTexture").map(Some),
            Self::Anisotropy => {
                let anisotropy = extension("KHR_materials_anisotropy")?;
                Some(json.member(anisotropy, "anisotropyTexture"))
            }
            Self::ClearcoatNormalTexture => {
                let coat = extension("KHR_materials_clearcoat")?;
                json.member(coat, "clearcoatNormalTexture").map(Some)
            }
        }
    }
}

/// The properties of a material that need tangents. Many primitives may have one material, which is searched once.
pub struct MaterialUses {
    pub name: String,
    /// One entry for each of [`TangentUse::ALL`].
    found: [Option<Option<Value>>; 3],
}

impl MaterialUses {
    /// Those of all materials of a document.
    pub fn all(records: &Records) -> Vec<Self> {
        let of_material = |(number, &material): (usize, &Value)| {
            let name = records.fields(material).name().unwrap_or_default();
            Self {
                name: if name.is_empty() {
                    format!("material {number}")
                } else {
                    format!("material {name:?}")
                },
                found: TangentUse::ALL.map(|it| it.find(&records.json, material)),
            }
        };
        records.materials.iter().enumerate().map(of_material).collect()
    }
}

/// A set of texture coordinates, and the linear part of their transform (`KHR_texture_transform`): a translation turns no
/// tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    pub set: u64,
    scale: [f64; 2],
    /// Sine and cosine of the rotation.
    rotation: (f64, f64),
}

impl Default for Coordinates {
    fn default() -> Self {
        Self { set: 0, scale: [1.0; 2], rotation: (0.0, 1.0) }
    }
}

impl Coordinates {
    /// The coordinates that a reference to a texture uses.
    fn of_texture(json: &Json, texture: Value) -> Self {
        let transform = json
            .member(texture, "extensions")
            .and_then(|extensions| json.member(extensions, "KHR_texture_transform"));
        let set = |object: Value| json.integer_member(object, "texCoord");
        let number = |value: Value| json.number(value).filter(|number| number.is_finite());
        let rotation = transform.and_then(|transform| number(json.member(transform, "rotation")?));
        let rotation = rotation.unwrap_or(0.0);
        let mut scales = transform.into_iter().flat_map(|transform| json.items(transform, "scale"));
        let mut scale = || scales.next().and_then(number).unwrap_or(1.0);
        Self {
            set: transform.and_then(set).or_else(|| set(texture)).unwrap_or(0),
            scale: [scale(), scale()],
            rotation: (libm::sin(rotation), libm::cos(rotation)),
        }
    }

    /// The directions of transformed coordinates: scaled, then rotated counter-clockwise as seen with v upwards. glTF counts v
    /// downwards. Values that are not finite become 0.
    pub fn transform(&self, uv: [f32; 2]) -> [f32; 2] {
        let (sin, cos) = self.rotation;
        let [u, v] = [0, 1].map(|axis| self.scale[axis] * f64::from(uv[axis]));
        let finite = |x: f64| if (x as f32).is_finite() { x as f32 } else { 0.0 };
        [finite(cos * u + sin * v), finite(cos * v - sin * u)]
    }
}

/// What the material of a primitive needs tangents for, and its variants (`KHR_materials_variants`) do.
pub struct TangentSpace {
    pub uses: Vec<TangentUse>,
    /// Whether some material has no normal texture from which viewers would take the coordinates of missing tangents.
    pub is_required: bool,
    pub coordinates: Coordinates,
}

impl TangentSpace {
    /// `materials` are [those of the document](MaterialUses::all).
    pub fn new(records: &Records, materials: &[MaterialUses], primitive: &Primitive) -> Self {
        let mut space = Self { uses: Vec::new(), is_required: false, coordinates: Coordinates::default() };
        let mut texture = None;
        for found in numbers(records, primitive).filter_map(|number| Some(materials.get(number)?.found)) {
            space.is_required |= found[0].is_none() && found[1..].iter().any(Option::is_some);
            for (it, reference) in TangentUse::ALL.into_iter().zip(found) {
                let Some(reference) = reference else { continue };
                texture = texture.or(reference);
                if !space.uses.contains(&it) {
                    space.uses.push(it);
                }
            }
        }
        if let Some(texture) = texture {
            space.coordinates = Coordinates::of_texture(&records.json, texture);
        }
        space
    }
}

/// The numbers of a primitive's materials: its own, then those of its variants.
fn numbers(records: &Records, primitive: &Primitive) -> impl Iterator<Item = usize> {
    let json = &records.json;
    let variants = records.fields(primitive.object).extension("KHR_materials_variants");
    let mappings = variants.into_iter().flat_map(|variants| json.items(variants, "mappings"));
    let others = mappings.filter_map(|mapping| json.integer_member(mapping, "material"));
    primitive.material.into_iter().chain(others.filter_map(|number| usize::try_from(number).ok()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the extension's specification: the lower left quadrant of the image, rotated clockwise by 90°.
    #[test]
    fn a_transform_is_that_of_the_specification() {
        let text = r#"{"index": 0, "texCoord": 3, "extensions": {"KHR_texture_transform":
            {"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5], "texCoord": 2}}}"#;
        let json = Json::parse(text.as_bytes().to_vec(), 0, 16).unwrap();
        let coordinates = Coordinates::of_texture(&json, json.root());
        assert_eq!(coordinates.set, 2);
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let [x, y] = coordinates.transform([u, v]);
            let wanted = [0.5 * v, 1.0 - 0.5 * u];
            assert!((x - wanted[0]).abs() + (y + 1.0 - wanted[1]).abs() < 1e-6, "{u} {v}: {x} {y}");
        }
        assert_eq!(coordinates.transform([f32::NAN, 1.0]), [0.0; 2]);
    }
}
