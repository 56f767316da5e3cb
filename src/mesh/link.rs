//! What a half-edge meets, and its packed form.

/// What a half-edge meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// The opposite half-edge of the one other face at this edge, by vertex index.
    Twin(u32),
    /// As [`Link::Twin`], but found by coincident positions: both edges are boundary by index.
    Welded(u32),
    /// The only other half-edge here has the same direction: one of the two faces is reversed.
    Inconsistent(u32),
    /// No other face.
    Boundary,
    /// More than two faces.
    NonManifold,
    /// Boundary by index, and several coincident edges could be joined to it: none is.
    Ambiguous,
    /// The two ends are one vertex, or the face has fewer than three distinct vertices: no edge at all.
    Collapsed,
}

/// Two bits of kind above 30 bits of partner: half-edges and their links are read far more often than anything
/// else of a mesh, so they stay within four bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PackedLink(pub(super) u32);

const PARTNER_BITS: u32 = 30;
const PARTNER_MASK: u32 = (1 << PARTNER_BITS) - 1;

/// Most corners a mesh may have: what [`PackedLink`] can count.
pub(crate) const MAX_CORNERS: usize = 1 << PARTNER_BITS;

impl PackedLink {
    pub(super) const BOUNDARY: Self = Self(3 << PARTNER_BITS);
    pub(super) const NON_MANIFOLD: Self = Self(3 << PARTNER_BITS | 1);

    pub(super) fn new(link: Link) -> Self {
        Self(match link {
            Link::Twin(half_edge) => half_edge,
            Link::Welded(half_edge) => 1 << PARTNER_BITS | half_edge,
            Link::Inconsistent(half_edge) => 2 << PARTNER_BITS | half_edge,
            Link::Boundary => 3 << PARTNER_BITS,
            Link::NonManifold => 3 << PARTNER_BITS | 1,
            Link::Ambiguous => 3 << PARTNER_BITS | 2,
            Link::Collapsed => 3 << PARTNER_BITS | 3,
        })
    }

    #[inline]
    pub(super) fn unpack(self) -> Link {
        let partner = self.0 & PARTNER_MASK;
        match (self.0 >> PARTNER_BITS, partner) {
            (0, _) => Link::Twin(partner),
            (1, _) => Link::Welded(partner),
            (2, _) => Link::Inconsistent(partner),
            (_, 0) => Link::Boundary,
            (_, 1) => Link::NonManifold,
            (_, 2) => Link::Ambiguous,
            _ => Link::Collapsed,
        }
    }

    /// The half-edge across, where the surface continues.
    #[inline]
    pub(super) fn across(self) -> Option<u32> {
        (self.0 < 2 << PARTNER_BITS).then_some(self.0 & PARTNER_MASK)
    }
}
