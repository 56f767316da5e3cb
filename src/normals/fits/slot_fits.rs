//! Fits in place of means, for all slots of a mesh.

use crate::normals::fits::choice::{Choice, choose};
use crate::normals::fits::fitted_normals::{FitFailures, fitted_normals};
use crate::normals::fits::jet::{JET, JetFallbacks};
use crate::normals::fits::progress::FitCount;
use crate::normals::fits::quadric::QUADRIC;
use crate::normals::fits::rings::{FitRequest, Rings};
use crate::normals::recipe::Weight;
use crate::normals::sums::request::Sums;
use glam::DVec3;

/// Where fits failed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Fits {
    pub(crate) quadric: FitFailures,
    pub(crate) jet: JetFallbacks,
    pub(crate) choice: Option<Choice>,
}

/// Replaces means by the normals of fits where there is one.
pub(crate) fn fit_slots(
    request: FitRequest,
    mut weight: Weight,
    more_rings: usize,
    sums: &mut Sums,
    count: &FitCount<'_>,
) -> Fits {
    // What is left of a cancelling sum is no frame to fit in.
    for (unit, _) in sums.unit.iter_mut().zip(&sums.state).filter(|(_, state)| !state.has_normal()) {
        *unit = DVec3::ZERO;
    }
    let rings = Rings::new(request, sums.unit.len());
    let mut fits = Fits::default();
    if weight == Weight::Best {
        let choice = choose(&rings, &sums.unit, more_rings);
        weight = choice.weight;
        fits.choice = Some(choice);
    }
    let groups: Vec<u32> = (0..sums.unit.len() as u32).collect();
    let done = |groups| count.add(groups);
    let fitted = match weight {
        Weight::Jet => {
            let (normals, [degree_3, degree_2]) =
                fitted_normals(&rings, JET, more_rings, &sums.unit, &groups, &done);
            fits.jet = JetFallbacks { degree_3, degree_2 };
            normals
        }
        Weight::Quadric => {
            let (normals, [failures]) =
                fitted_normals(&rings, [QUADRIC], more_rings, &sums.unit, &groups, &done);
            fits.quadric = failures;
            normals
        }
        _ => Vec::new(),
    };
    let fitted = sums.unit.iter_mut().zip(fitted).filter(|(_, fit)| *fit != DVec3::ZERO);
    fitted.for_each(|(unit, fit)| *unit = fit);
    fits
}
