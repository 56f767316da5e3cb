//! Mesh **normals**: compute them, split them where a surface should stay sharp, and write them into the file, with
//! everything else unchanged.
//!
//! # A tour
//! [`io`] reads a file into a [`mesh::Mesh`]. [`normals::compute`] applies a [`normals::NormalRecipe`] and returns a
//! [`normals::NormalField`]: one unit normal per vertex and smooth group, and one index a corner.
//!
//! ```
//! use crease::io::{Format, ReadOptions, read_bytes};
//! use crease::normals::{NormalRecipe, Weight, compute};
//!
//! let roof = b"v 0 0 0\nv 4 0 0\nv 4 1 1\nv 0 1 1\nv 4 2 0\nv 0 2 0\nf 1 2 3 4\nf 4 3 5 6\n";
//! let loaded = read_bytes(roof.to_vec(), Some(Format::Obj), None, &ReadOptions::default())?;
//! let recipe = NormalRecipe { weight: Weight::Max, ..NormalRecipe::default() };
//! let field = compute(&loaded.parts[0].mesh, &recipe);
//! // The ridge is a right angle, over the default crease angle of 40°: its two vertices have two normals each.
//! assert_eq!((field.summary.edges.crease, field.summary.splits), (1, 2));
//! # Ok::<(), crease::io::ReadError>(())
//! ```
//!
//! [`pipeline`] goes from file to file in one call. Code with its own arrays needs no mesh:
//! [`normals::face_normals`](fn@normals::face_normals), [`normals::vertex_normals`] and [`normals::corner_normals`]
//! work on `&[[f32; 3]]` and `&[[u32; 3]]` with the same kernels.
//!
//! # Conventions
//! - Right-handed space, y up, counter-clockwise front faces; screen y down with pixel centres at +0.5.
//! - Radians inside, degrees at the command line and in reports.
//! - Colour is linear until a named transfer step.
//! - A *corner* is one vertex of one face; *half-edge* `c` leaves corner `c` for the next corner of its face.
//! - No absolute epsilon: scaling a mesh by a power of two changes no bit of a faithful normal.
//! - The same input gives the same bytes at any number of threads and with any CPU's instruction set.
//!
#![doc = include_str!("../docs/architecture.md")]
//!
//! # Sources
//! - H. Gouraud, *Continuous shading of curved surfaces*, IEEE Trans. Computers C-20(6), 1971: the uniform mean.
//! - G. Thürmer, C. A. Wüthrich, *Computing vertex normals from polygonal facets*, JGT 3(1):43–46, 1998: angles.
//! - N. Max, *Weights for computing vertex normals from facet normals*, JGT 4(2):1–6, 1999.
//! - S. Jin, R. R. Lewis, D. West, *A comparison of algorithms for vertex normal computation*, Visual Computer
//!   21:71–82, 2005.
//! - M. Cornea, J. Harrison, P. T. P. Tang, *Scientific computing on Itanium-based systems*, 2002, and
//!   C.-P. Jeannerod, N. Louvet, J.-M. Muller, *Further analysis of Kahan's algorithm for the accurate computation
//!   of 2×2 determinants*, Math. Comp. 82:2245–2264, 2013: differences of products.
//! - C. Yuksel, *High-performance polynomial root finding for graphics*, Proc. ACM Comput. Graph. Interact. Tech. 5(3),
//!   2022; A. H. Barr, *Superquadrics and angle-preserving transformations*, IEEE CG&A 1(1), 1981; F. Crow, *The
//!   origins of the teapot*, IEEE CG&A 7(1), 1987: surfaces whose normals are known.
//! - T. J. Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18, 1971, and
//!   J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, DCG 18,
//!   1997: exact sums and products.
//! - Bui Tuong Phong, *Illumination for computer generated pictures*, CACM 18(6):311–317, 1975, and J. F. Blinn, *Models
//!   of light reflection for computer synthesized pictures*, SIGGRAPH 1977: highlights; as lectured by D. A. Medeiros
//!   Filho, *Iluminação e sombreamento*, 2017, whose formulas and exercises [`shade`] lists.
//! - D. R. Baum, H. E. Rushmeier, J. M. Winget, *Improving radiosity solutions through the use of analytically determined
//!   form-factors*, SIGGRAPH 1989: light from polygons.
//! - I. E. Sutherland, G. W. Hodgman, *Reentrant polygon clipping*, CACM 17(1):32–42, 1974, and Y.-D. Liang,
//!   B. A. Barsky, *A new concept and method for line clipping*, ACM TOG 3(1):1–22, 1984.
//! - J. Pineda, *A parallel algorithm for polygon rasterization*, SIGGRAPH 1988, and M. Olano, T. Greer, *Triangle scan
//!   conversion using 2D homogeneous coordinates*, Graphics Hardware 1997: edge functions.
//! - M. J.-Y. Chiang, Y. K. Li, B. Burley, *Taming the shadow terminator*, SIGGRAPH 2019 Talks: light on faces that turn away.
//! - S. A. Wallis, M. A. Georgeson, *Mach bands and multiscale models of spatial vision*, Journal of Vision 12(13):18, 2012:
//!   what [`metric`] does not claim.
//! - F. A. A. Kingdom, *Mach bands explained by response normalization*, Frontiers in Human Neuroscience 8:843, 2014: where
//!   bands are seen, and where not.

pub mod artefact;
pub mod io;
pub mod mesh;
pub mod metric;
pub mod normals;
pub mod num;
pub mod pipeline;
pub mod plan;
pub mod quality;
pub mod raster;
#[cfg(feature = "report")]
pub mod report;
pub mod shade;
pub mod surface;
pub mod text;
pub mod trade;
