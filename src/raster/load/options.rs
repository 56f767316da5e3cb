//! How scenes are read.

use crate::io::ReadOptions;
use crate::normals::{NormalRecipe, When};

/// How scenes are read.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// What determines the normals of meshes.
    pub recipe: NormalRecipe,
    /// Which stored normals are replaced. What is drawn is what [`pipeline::revise`](crate::pipeline::revise) with the
    /// same recipe would write. `None` leaves it to what scenes say; where they say nothing, those of mesh files are always
    /// replaced, and those that a scene gives its own polygons and surfaces are kept.
    pub when: Option<When>,
    /// What readers may do and how much they may take.
    pub read: ReadOptions,
    /// Whether pictures are seen from elsewhere, so that a camera of a mesh file that makes no sense is left out with a
    /// note and is no error.
    pub from_elsewhere: bool,
}
