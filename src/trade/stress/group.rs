//! The groups of the catalogue.

use crate::trade::described::described;

described! {
    /// What is extreme about a case.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    Group {
        Magnitude = "magnitude": "coordinates from 1e-45 to 3e38, and mixed in one triangle",
        Offset = "offset": "triangles of size 1 far from the origin: arithmetic and storage separately",
        Needle = "needle": "faces much longer than high, and the sliver threshold",
        Degenerate = "degenerate": "exactly collinear and duplicate points",
        NonFinite = "non-finite": "positions that are infinite or not a number",
        Valence = "valence": "vertices of 3 to a million faces, and fans that nearly cancel",
        Fan = "fan": "opposite faces, folds, edges of three faces, tips of cones",
        Angle = "angle": "corners near 0 and 180 degrees",
        Crease = "crease": "dihedral angles exactly at the crease angle",
        Unit = "unit": "unit vectors of subnormal and of huge ones",
        Product = "product": "differences of nearly equal products",
        Highlight = "highlight": "powers of cosines up to a million, opposite and grazing light",
        Attenuation = "attenuation": "light very close to its source",
        Raster = "raster": "triangles far outside the picture, behind the camera, very large, or thinner than a pixel",
        Encoding = "encoding": "normals in few bits, at the poles and on the edges of the octahedron",
    }
}

impl Group {
    /// The reason why cases of the group have no `fast`.
    pub const fn without_fast(self) -> &'static str {
        match self {
            Group::NonFinite => "reading and checking positions is the same for both",
            Group::Angle | Group::Product => "fast uses the same function",
            Group::Unit => "normalised in f64 only",
            Group::Crease => "counted for the report from the same face normals",
            Group::Raster => "drawing has no fast variant",
            Group::Encoding => "encoding has no fast variant",
            Group::Fan => "quadrics are fitted in f64, whatever the precision of the mean",
            _ => "there is no fast variant",
        }
    }
}
