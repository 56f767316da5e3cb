//! What a plan leaves unchanged, requests without an answer, and budgets.

use super::random_scenes::RandomScene;
use super::{change, only, planned, scene};
use crease::plan::{Axis, End, Minimise, PlanOptions, Progress, plan};
use crease::raster::LoadOptions;
use std::path::Path;

const SCENE: &str = "# Two balls.\n[settings]\nsize = [80, 60]\n[camera]\neye = [0, 0, 8]\ntarget = [0, 0, 0]\n\
     [[light.point]]\nposition = [20, 30, 40]\n[[light.directional]]\ntowards = [0, 0, -1]\ncolour = 0.001\n\
     [[object]]\nname = \"left\"\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [14, 8] }\n\
     transform = [{ translate = [-1, 0, 0] }]\n\
     [[object]]\nname = \"right\"\nsurface = { sphere = { radius = 1 } } # to the right\ntessellation = { segments = [14, 8] }\n\
     transform = [{ translate = [1, 0, 0] }]\n";

fn error(text: &str, options: &PlanOptions) -> String {
    match plan(text, Path::new(""), &LoadOptions::default(), options, &|_| ()) {
        Ok(plan) => panic!("a plan:\n{}", plan.text),
        Err(error) => error.to_string(),
    }
}

#[test]
fn plans_are_the_same_with_any_number_of_threads() {
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let random = RandomScene::new(7);
            let (open, _) = random.open_axes(7, 300);
            [
                planned(SCENE, &only(&[Axis::Shading, Axis::Lights], 2.0)),
                planned(&random.text(), &only(&open, 2.0)),
            ]
        })
    };
    let (one, two) = (of(1), of(2));
    assert_eq!(one, two);
    assert_eq!(one[0].text, two[0].text);
}

#[test]
fn traced_pictures_have_no_plan() {
    let traced = SCENE.replace("size = [80, 60]", "size = [80, 60]\nshading = \"traced\"");
    let message = error(&traced, &only(&[Axis::Shading], 2.0));
    assert!(message.contains("no cheaper model") && message.contains("phong"), "{message}");
}

#[test]
fn marked_objects_and_lights_stay() {
    let options = only(&[Axis::Interpolation, Axis::Lights], 9.0);
    let free = planned(SCENE, &options);
    let changed = |plan: &crease::plan::Plan, what: &str| plan.decisions.iter().any(|it| it.what == what);
    for what in ["left", "right", "light 1"] {
        assert!(changed(&free, what), "{what}: {:?}", free.decisions);
    }
    let marked = SCENE
        .replace("colour = 0.001\n", "colour = 0.001\nplan = \"keep\"\n")
        .replace("name = \"left\"\n", "name = \"left\"\nplan = \"keep\"\n");
    let plan = planned(&marked, &options);
    assert!(
        !changed(&plan, "left") && !changed(&plan, "light 1") && changed(&plan, "right"),
        "{:?}",
        plan.decisions
    );
    let (before, after) = (scene(&marked), scene(&plan.text));
    assert_eq!(before.objects[0].settings, after.objects[0].settings);
    assert_eq!(before.lights.unwrap()[1], after.lights.unwrap()[1]);
    // The text keeps its comments, and the marks can be used again.
    assert!(plan.text.contains("# Two balls.") && plan.text.contains("# to the right"), "{}", plan.text);
    assert!(scene(&plan.text).objects[0].is_kept);
    assert_eq!(scene(&plan.text).kept_lights, [1], "{}", plan.text);
}

#[test]
fn axes_that_are_kept_do_not_change() {
    let nothing = planned(SCENE, &only(&[], 100.0));
    assert!(nothing.decisions.is_empty() && nothing.is_cheapest);
    assert_eq!((nothing.declared, nothing.combinations), (nothing.planned, 1.0));
    for axis in [Axis::Interpolation, Axis::Storage, Axis::Reflection, Axis::Lights] {
        // Storage saves bytes and no work.
        let minimise = if axis == Axis::Storage { Minimise::Bytes } else { Minimise::Work };
        let plan = planned(SCENE, &PlanOptions { minimise, ..only(&[axis], 60.0) });
        assert!(change(&plan, axis).is_some(), "{axis:?}");
        assert!(
            plan.decisions.iter().all(|decision| decision.axis == axis),
            "{axis:?}: {:?}",
            plan.decisions
        );
    }
}

#[test]
fn a_plan_without_changes_is_the_scene() {
    let plan = planned(SCENE, &only(&[], 2.0));
    let (before, after) = (scene(SCENE), scene(&plan.text));
    assert_eq!((before.objects, before.lights, before.camera), (after.objects, after.lights, after.camera));
    assert_eq!((before.meshes, before.settings), (after.meshes, after.settings));
    // A change of which no pixel shows anything is possible at tolerance 0.
    let exact = planned(SCENE, &only(&[Axis::Shading, Axis::Lights], 0.0));
    assert_eq!(exact.worst.steps, 0.0);
}

/// A plan of a plan has nothing more to save, if the tolerance leaves no room for it.
#[test]
fn plans_are_scenes_that_can_be_planned() {
    let options = only(&[Axis::Shading, Axis::Storage, Axis::Lights], 2.0);
    let first = planned(SCENE, &options);
    let second = planned(&first.text, &PlanOptions { tolerance: 1e-6, ..options });
    assert_eq!(second.declared, first.planned);
}

#[test]
fn impossible_limits_are_errors() {
    for tolerance in [f64::NAN, -1.0, f64::INFINITY] {
        let message = error(SCENE, &PlanOptions { tolerance, ..PlanOptions::default() });
        assert!(message.contains("tolerance"), "{tolerance}: {message}");
    }
    for outline in [f64::NAN, -0.5] {
        let message = error(SCENE, &PlanOptions { outline, ..PlanOptions::default() });
        assert!(message.contains("outline"), "{outline}: {message}");
    }
    let message = error(SCENE, &PlanOptions { tolerance: 256.0, ..PlanOptions::default() });
    assert!(message.contains("from 0 to 255"), "{message}");
    let flip = PlanOptions { tolerance: 2.0, metric: crease::plan::Metric::Flip, ..PlanOptions::default() };
    assert!(error(SCENE, &flip).contains("from 0 to 1"));
    for share in [f64::NAN, -0.1, 1.5] {
        let message = error(SCENE, &PlanOptions { share, ..PlanOptions::default() });
        assert!(message.contains("share"), "{share}: {message}");
    }
}

#[test]
fn scenes_that_show_nothing_are_errors() {
    let options = PlanOptions::default();
    assert!(!error("[settings]\nsize = [8, 8]\n", &options).is_empty());
    assert!(!error("[[object]]\nsurface = 3\n", &options).is_empty());
    assert!(!error("not a scene", &options).is_empty());
    let away = SCENE.replace("target = [0, 0, 0]", "target = [0, 0, 20]");
    assert!(error(&away, &options).contains("no view shows any object"), "{}", error(&away, &options));
}

/// From inside a ball all faces are seen from behind: they are covered, dark, and can be drawn with any model.
#[test]
fn a_view_inside_an_object_has_a_plan() {
    let inside = SCENE
        .replace("eye = [0, 0, 8]", "eye = [-1, 0, 0]")
        .replace("target = [0, 0, 0]", "target = [-2, 0, 0]");
    let plan = planned(&inside, &only(&[Axis::Shading, Axis::Lights], 2.0));
    assert!(plan.is_cheapest && plan.worst.steps <= 2.0);
    assert_eq!(super::steps(&scene(&inside), &scene(&plan.text)), plan.worst.steps);
}

#[test]
fn a_spent_budget_gives_a_plan_that_is_not_proven() {
    let options =
        only(&[Axis::Shading, Axis::Storage, Axis::Interpolation, Axis::Reflection, Axis::Lights], 0.2);
    let whole = planned(SCENE, &options);
    assert!(whole.is_cheapest);
    let mut unproven = 0;
    for share in [0.0, 0.1, 0.5, 0.9] {
        let budget = (share * whole.drawn as f64) as u64;
        let plan = planned(SCENE, &PlanOptions { budget, ..options.clone() });
        let cost = plan.planned.work;
        assert!(plan.proven <= whole.planned.work, "{budget}: {} and {}", plan.proven, whole.planned.work);
        assert!(whole.planned.work <= cost && cost <= plan.declared.work);
        assert_eq!(plan.is_cheapest, plan.proven == cost);
        assert!(plan.worst.steps <= 0.2);
        unproven += usize::from(!plan.is_cheapest);
    }
    assert!(unproven > 0);
}

/// A search that ends early has a verified plan that is cheaper than the scene, and states how far it may be from the cheapest.
#[test]
fn a_spent_budget_gives_the_best_plan_so_far() {
    let options = only(&[Axis::Shading, Axis::Interpolation, Axis::Reflection, Axis::Lights], 2.0);
    let whole = planned(SCENE, &options);
    assert!(whole.gap == 0.0 && whole.planned.work < whole.declared.work);
    let budget = whole.drawn * 3 / 4;
    let plan = planned(SCENE, &PlanOptions { budget, ..options.clone() });
    assert_eq!(plan.end, End::Budget { pixels: budget });
    assert!(plan.planned.work < plan.declared.work, "{:?}", plan.decisions);
    assert_eq!(super::steps(&scene(SCENE), &scene(&plan.text)), plan.worst.steps);
    assert!(plan.worst.steps <= 2.0);
    let gap = 1.0 - plan.proven as f64 / plan.planned.work as f64;
    assert_eq!(plan.gap, gap);
    assert!(whole.planned.work as f64 >= (1.0 - gap) * plan.planned.work as f64 - 1.0);
    // The same again.
    assert_eq!(planned(SCENE, &PlanOptions { budget, ..options }), plan);
}

/// The progress ends at 1, with the cost of the plan.
#[test]
fn progress_ends_with_the_plan() {
    let steps = std::cell::RefCell::new(Vec::new());
    let options = only(&[Axis::Interpolation, Axis::Lights], 9.0);
    let note = |step: Progress| steps.borrow_mut().push(step);
    let plan = plan(SCENE, Path::new(""), &LoadOptions::default(), &options, &note).unwrap();
    let steps = steps.into_inner();
    let best = plan.planned.work as f64 / plan.declared.work as f64;
    assert_eq!(steps.last(), Some(&Progress { share: 1.0, best }));
    assert!(steps.iter().all(|step| (0.0..=1.0).contains(&step.share) && step.best >= best));
    assert!(best < 1.0 && steps.iter().any(|step| step.best == 1.0));
}

/// Views around the scene: the worst of others is reported, and they are within the tolerance.
#[test]
fn views_around_a_scene_hold_out_others() {
    let plan = planned(SCENE, &PlanOptions { views: Some(3), ..only(&[Axis::Shading, Axis::Storage], 2.0) });
    assert_eq!(plan.views, 3 + plan.repairs);
    assert!(plan.held_out.is_none_or(|worst| worst.steps <= 2.0), "{:?}", plan.held_out);
    assert!(plan.held_out.is_some() || plan.repairs == 3);
}

/// Light from behind, as seen in the view that the plan is found with. With a budget that ends the search, the plan is still cheaper than the
/// scene, and within the tolerance in all views.
#[test]
fn a_plan_that_other_views_refuse_is_replaced_within_the_budget() {
    let text = "[settings]\nsize = [48, 48]\n[camera]\neye = [0, 0, 12]\ntarget = [1.5, 0, 0]\nangle = 30\n[[light.directional]]\n\
         towards = [-0.8660254, -0.5, 0]\n[[light.point]]\nposition = [9, 9, 3]\ncolour = 0.4\n[[light.point]]\n\
         position = [9, 3, -4]\ncolour = 0.2\n[[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [24, 12] }\n\
         material = { colour = 1, diffuse = 0.3, specular = 0.7, exponent = 40 }\n[[object]]\n\
         surface = { sphere = { radius = 1 } }\ntransform = [{ translate = [3, 0, 0] }]\ntessellation = { segments = [24, 12] }\n";
    let options = PlanOptions {
        views: Some(1),
        ..only(&[Axis::Shading, Axis::Interpolation, Axis::Reflection, Axis::Lights], 4.0)
    };
    let whole = planned(text, &options);
    assert!(whole.repairs > 0 && whole.is_cheapest, "{} repairs", whole.repairs);
    for share in [0.5, 0.9] {
        let budget = (share * whole.drawn as f64) as u64;
        let plan = planned(text, &PlanOptions { budget, ..options.clone() });
        assert_eq!(plan.end, End::Budget { pixels: budget });
        assert!(plan.planned.work < plan.declared.work, "{share}: {:?}", plan.decisions);
        assert!(plan.held_out.is_none_or(|worst| worst.steps <= 4.0) && plan.worst.steps <= 4.0);
    }
}

/// All views of the reference are kept in memory.
#[test]
fn more_pictures_than_memory_holds_are_an_error() {
    let text = "[settings]\nsize = [4096, 4096]\n[[object]]\nsurface = { sphere = { radius = 1 } }\n";
    let options = PlanOptions { views: Some(3), ..PlanOptions::default() };
    let error = plan(text, Path::new(""), &LoadOptions::default(), &options, &|_| ()).unwrap_err();
    assert!(error.to_string().starts_with("6 pictures of 16777216 pixels are too many"), "{error}");
}

/// A vertex that no face uses does not hide that another has several normals.
#[test]
fn unused_vertices_do_not_hide_creases() {
    let text = "[settings]\nsize = [16, 16]\n[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\nheight = 1\n[[light.directional]]\n\
         towards = [0, 0, 1]\n[[object]]\nweight = \"angle\"\nmaterial = { specular = 0 }\npolygons = { vertices = [[-2, -2, 0], \
         [2, -2, 0], [2, 2, 0], [-2, 2, 0], [-2, 2, -2], [2, 2, -2], [9, 9, 9], [9, 9, 9], [9, 9, 9]], \
         faces = [[0, 1, 2, 3], [3, 2, 5, 4]] }\n";
    let options = PlanOptions { minimise: Minimise::Vertices, ..only(&[Axis::Creases], 255.0) };
    let plan = planned(text, &options);
    assert_eq!((plan.declared.vertices, plan.planned.vertices), (8, 6));
}
