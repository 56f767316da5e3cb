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

/// The name and a description of each group, in the order of [`Group::ALL`].
const DESCRIPTIONS: [(&str, &str); 15] = [
    ("magnitude", "coordinates from 1e-45 to 3e38, and mixed in one triangle"),
    ("offset", "triangles of size 1 far from the origin: arithmetic and storage apart"),
    ("needle", "faces much longer than high, and the sliver threshold"),
    ("degenerate", "exactly collinear and duplicate points"),
    ("non-finite", "positions that are infinite or not a number"),
    ("valence", "vertices of 3 to a million faces, and fans that nearly cancel"),
    ("fan", "opposite faces, folds, edges of three faces, tips of cones"),
    ("angle", "corners near 0 and 180 degrees"),
    ("crease", "dihedral angles exactly at the crease angle"),
    ("unit", "unit vectors of subnormal and of huge ones"),
    ("product", "differences of nearly equal products"),
    ("highlight", "powers of cosines up to a million, opposite and grazing light"),
    ("attenuation", "light very close to its source"),
    ("raster", "triangles 1e30 off the picture, behind the eye, of a million pixels, thinner than one"),
    ("encoding", "normals in few bits, at the poles and on the edges of the octahedron"),
];

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
        DESCRIPTIONS[self as usize].0
    }

    /// A description in one line.
    pub const fn about(self) -> &'static str {
        DESCRIPTIONS[self as usize].1
    }

    /// The reason why cases of the group have no `fast`.
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
}
