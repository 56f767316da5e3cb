//! The reference, the plan and their difference in one picture.

use super::decisions::{cost, difference, text};
use super::page::PlanPage;
use crate::plan::{Evidence, Plan};
use crate::report::error::Result;
use crate::report::panel::{Panel, panels};
use crate::report::picture::Picture;

/// The three pictures of a plan next to each other, with their costs and the largest difference.
///
/// # Errors
/// Pictures that are too large together.
pub fn plan_sheet(plan: &Plan, evidence: &Evidence, about: &PlanPage) -> Result<Picture> {
    let shown = &evidence.planned;
    let of = |key: &str, cost_of: u64| {
        let cost = cost(cost_of, about.minimise).into();
        text(key, &[("cost", cost)], about.language)
    };
    let worst = [
        ("difference", difference(plan.worst.by(about.metric), about.metric)),
        ("factor", shown.amplification.into()),
    ];
    let captions = [
        of("sheet-reference", plan.declared.of(about.minimise)),
        of("sheet-plan", plan.planned.of(about.minimise)),
        text("sheet-difference", &worst, about.language),
    ];
    let pictures = [&shown.reference, &shown.other, &shown.difference];
    let list = captions.into_iter().zip(pictures);
    panels(
        &list
            .map(|(caption, image)| Panel { caption, picture: Picture::from(image.clone()) })
            .collect::<Vec<_>>(),
    )
}
