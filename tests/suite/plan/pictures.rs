//! Pictures of plans, compared with those of their scenes by code that shares nothing with `plan`.

use super::random_scenes::RandomScene;
use super::{differences, drawn, only, planned, scene, scene_in};
use crease::plan::{PlanOptions, plan, scene_text, with_size};
use crease::raster::{LoadOptions, SceneFile};
use std::fs;
use std::path::{Path, PathBuf};

/// The largest difference of two scenes, which is to be the one that the plan states.
fn check(declared: &SceneFile, planned: &SceneFile, tolerance: f64, stated: f64, name: &str) {
    let (truth, other) = (drawn(declared), drawn(planned));
    let steps = differences(&truth, &other, &declared.settings).into_iter().fold(0.0, f64::max);
    assert!(steps <= tolerance, "{name}: {steps} steps, tolerance {tolerance}");
    assert!(
        (steps - stated).abs() <= 1e-3 + 1e-3 * stated,
        "{name}: {steps} steps, the plan states {stated}"
    );
    assert_eq!(truth.size, other.size);
}

fn compare(seeds: std::ops::Range<u64>, most: usize) {
    let mut bounded = 0;
    for seed in seeds {
        let it = RandomScene::new(seed);
        let (open, _) = it.open_axes(seed, most);
        let tolerance = [0.3, 1.0, 2.0, 5.0, 15.0][seed as usize % 5];
        let plan = planned(&it.text(), &PlanOptions { outline: 1.0, ..only(&open, tolerance) });
        check(&scene(&it.text()), &scene(&plan.text), tolerance, plan.worst.steps, &format!("seed {seed}"));
        for decision in &plan.decisions {
            let is_within = decision.bound.is_none_or(|bound| decision.measured <= bound);
            assert!(is_within, "seed {seed}: {decision:?}");
            bounded += usize::from(decision.bound.is_some());
        }
        // A plan reports the changes that it makes, and no others.
        assert_eq!(
            plan.decisions.is_empty(),
            plan.planned == plan.declared,
            "seed {seed}: {:?}",
            plan.decisions
        );
        if plan.decisions.is_empty() {
            assert_eq!(plan.worst.steps, 0.0, "seed {seed}");
        }
    }
    assert!(bounded > 100, "{bounded} changes have a bound");
}

#[test]
fn plans_of_random_scenes_are_within_the_tolerance() {
    compare(100..200, 600);
}

/// The long version of the test above.
#[test]
#[ignore = "takes minutes"]
fn plans_of_a_thousand_random_scenes_are_within_the_tolerance() {
    compare(2000..3000, 5000);
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(self::files(&path));
        } else if path.extension().is_some_and(|ending| ending == "toml" || ending == "gltf") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// All scenes of `data/scenes` at a small size, with a budget that ends some searches early.
#[test]
fn plans_of_all_scene_files_are_within_the_tolerance() {
    let options = PlanOptions { budget: 400 * 40 * 30, ..PlanOptions::default() };
    let (mut count, mut changed) = (0, 0);
    for path in files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes")) {
        let (name, folder) = (path.display().to_string(), path.parent().unwrap());
        let text = with_size(&scene_text(&path, &LoadOptions::default()).unwrap(), [40, 30]).unwrap();
        let declared = scene_in(&text, folder);
        if text.contains("shading = \"traced\"") {
            let refused = plan(&text, folder, &LoadOptions::default(), &options, &|_| ()).err();
            assert!(refused.is_some_and(|error| error.to_string().contains("traced")), "{name}");
            continue;
        }
        let plan = plan(&text, folder, &LoadOptions::default(), &options, &|_| ())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        check(&declared, &scene_in(&plan.text, folder), options.tolerance, plan.worst.steps, &name);
        count += 1;
        changed += usize::from(!plan.decisions.is_empty());
    }
    println!("{changed} of {count} scenes have a cheaper model");
    assert!(count > 15 && changed > 5, "{changed} of {count}");
}

/// Without a camera the picture is framed around the objects. Coarser cells must not move it.
#[test]
fn coarser_cells_do_not_move_a_camera_that_the_scene_leaves_open() {
    let text = "[settings]\nsize = [48, 48]\n[[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [33, 17] }\n\
         material = { specular = 0 }\n";
    let plan = planned(text, &PlanOptions { tolerance: 20.0, outline: 6.0, ..PlanOptions::default() });
    let cells = super::change(&plan, crease::plan::Axis::Tessellation);
    assert!(cells.is_some(), "{:?}", plan.decisions);
    check(&scene(text), &scene(&plan.text), 20.0, plan.worst.steps, "a sphere");
    let eye = |text: &str| scene(text).scene().camera.eye;
    assert_eq!(eye(text), eye(&plan.text));
}
