//! The groups of the catalogue.

/// What is extreme about a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Group {
    /// Coordinates from 1e-45 to 3e38, and mixed.
    Magnitude,
    /// Far from the origin: what storage loses and what arithmetic loses.
    Offset,
    /// Faces much longer than high.
    Needle,
    /// Exactly collinear and duplicate points.
    Degenerate,
    /// NaN and infinity.
    NonFinite,
    /// Vertices of 3 to a million faces, and fans that nearly cancel.
    Valence,
    /// Opposite faces, folds, edges of three faces, tips of cones.
    Fan,
    /// Angles near 0 and π.
    Angle,
    /// Dihedral angles at the crease angle.
    Crease,
    /// Unit vectors of tiny and huge ones.
    Unit,
    /// Differences of nearly equal products.
    Product,
    /// Powers of cosines, opposite and grazing light.
    Highlight,
    /// Light close to its source.
    Attenuation,
    /// Triangles that are hard to draw.
    Raster,
    /// Normals in few bits, at poles and edges of the octahedron.
    Encoding,
}

impl Group {
    /// All groups, in the order of the catalogue.
    pub const ALL: [Group; 15] = [
        Group::Magnitude,
        Group::Offset,
        Group::Needle,
        Group::Degenerate,
        Group::NonFinite,
        Group::Valence,
        Group::Fan,
        Group::Angle,
        Group::Crease,
        Group::Unit,
        Group::Product,
        Group::Highlight,
        Group::Attenuation,
        Group::Raster,
        Group::Encoding,
    ];

    /// The name used on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Group::Magnitude => "magnitude",
            Group::Offset => "offset",
            Group::Needle => "needle",
            Group::Degenerate => "degenerate",
            Group::NonFinite => "non-finite",
            Group::Valence => "valence",
            Group::Fan => "fan",
            Group::Angle => "angle",
            Group::Crease => "crease",
            Group::Unit => "unit",
            Group::Product => "product",
            Group::Highlight => "highlight",
            Group::Attenuation => "attenuation",
            Group::Raster => "raster",
            Group::Encoding => "encoding",
        }
    }

    /// Why there is no `fast` beside the cases of the group that have none.
    pub const fn without_fast(self) -> &'static str {
        match self {
            Group::NonFinite => "reading and checking positions is the same for both",
            Group::Angle | Group::Product => {
                "single precision has no way of its own to them: fast uses them as a whole"
            }
            Group::Unit => "made unit in f64 only",
            Group::Crease => "counted for the report from the same face normals",
            Group::Raster => "pictures are drawn one way",
            Group::Encoding => "codes are made one way",
            Group::Fan => "quadrics are fitted in f64, whatever the precision of the mean",
            _ => "computed one way",
        }
    }

    /// What it is about, in a line.
    pub const fn about(self) -> &'static str {
        match self {
            Group::Magnitude => "coordinates from 1e-45 to 3e38, and mixed in one triangle",
            Group::Offset => "triangles of size 1 far from the origin: arithmetic and storage apart",
            Group::Needle => "faces much longer than high, and the sliver threshold",
            Group::Degenerate => "exactly collinear and duplicate points",
            Group::NonFinite => "positions that are infinite or not a number",
            Group::Valence => "vertices of 3 to a million faces, and fans that nearly cancel",
            Group::Fan => "opposite faces, folds, edges of three faces, tips of cones",
            Group::Angle => "corners near 0 and 180 degrees",
            Group::Crease => "dihedral angles exactly at the crease angle",
            Group::Unit => "unit vectors of subnormal and of huge ones",
            Group::Product => "differences of nearly equal products",
            Group::Highlight => "powers of cosines up to a million, opposite and grazing light",
            Group::Attenuation => "light very close to its source",
            Group::Raster => {
                "triangles 1e30 off the picture, behind the eye, of a million pixels, thinner than one"
            }
            Group::Encoding => "normals in few bits, at the poles and on the edges of the octahedron",
        }
    }
}
