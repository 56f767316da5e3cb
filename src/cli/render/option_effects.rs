//! What a drawing reads: which options can change it, and why others cannot.

use super::args::{ReflectionChoice, RenderArgs};
use super::case::Case;
use crease::num::LinearRgb;
use crease::raster::{Cull, FlatSample, Interpolation, Projection, Shading, Show};
use crease::shade::{Attenuation, Cone, Light};

/// What must hold for an option to be read, and what is said where it holds nowhere.
pub struct Condition {
    pub holds: fn(&Case) -> bool,
    lacks: &'static str,
}

/// An option, whether it is typed, and the conditions under which it is read: all of them, for one object at least.
pub struct Reader {
    pub name: &'static str,
    is_typed: fn(&RenderArgs) -> bool,
    conditions: &'static [&'static [Condition]],
}

const SHADED: Condition = Condition {
    holds: |case| case.settings.show == Show::Shaded,
    lacks: "--show shows something in place of light",
};
const LIT: Condition =
    Condition { holds: |case| case.settings.shading != Shading::Wireframe, lacks: "a wireframe is not lit" };
const UNGIVEN: Condition =
    Condition { holds: |case| !case.object.given, lacks: "the colours of vertices are shown unlit" };
const FACES: Condition = Condition {
    holds: |case| !case.is_solid(),
    lacks: "analytic surfaces without a tessellation have neither faces nor corners",
};
const SPREAD: Condition = Condition {
    holds: |case| case.probes() || !case.shows_no_values(),
    lacks: "what --show shows is not interpolated",
};
const PHONG: Condition =
    Condition { holds: |case| case.settings.shading == Shading::Phong, lacks: "only Phong shading heeds it" };

/// Where there is light, some of it depends on the place or the normal.
const LAMPS: Condition = Condition {
    holds: |case| case.probes() || !case.is_lit() || case.has_light(|light| is_returned(case, light)),
    lacks: "nothing returns any light but ambient light; --light and the kd and ks of --material bring more",
};
const HIGHLIGHT: Condition = Condition {
    holds: |case| case.has_light(|light| !is_ambient(light) && case.shines(light)),
    lacks: "there is no highlight; it takes a --light and a --material whose ks is over 0",
};

/// What light on a material reads.
pub const LIGHT: &[Condition] = &[SHADED, LIT, UNGIVEN];

const INTERPOLATION_CONDITIONS: &[Condition] = &[
    FACES,
    SPREAD,
    Condition {
        holds: |case| case.probes() || case.interpolates(),
        lacks: "only Gouraud and Phong shading interpolate",
    },
    LAMPS,
    Condition {
        holds: |case| {
            let is_perspective = matches!(case.camera.projection, Projection::Perspective(_));
            case.probes() || is_perspective || case.interpolations().contains(&Interpolation::Scanline)
        },
        lacks: "affine and perspective are the same under a parallel projection",
    },
];

pub const INTERPOLATION: Reader = Reader {
    name: "--interpolation",
    is_typed: |args| args.shading.interpolation.is_some(),
    conditions: &[INTERPOLATION_CONDITIONS],
};

/// What normals of corners are read for. Lines along them, and probes, tell them whatever else is drawn.
const NORMALS: &[Condition] = &[
    Condition { holds: FACES.holds, lacks: "there are no meshes, whose normals would change" },
    Condition { holds: |case| case.reports_normals() || (SPREAD.holds)(case), lacks: SPREAD.lacks },
    Condition {
        holds: |case| {
            let settings = &case.settings;
            let is_mean = settings.shading == Shading::Flat
                && settings.show == Show::Shaded
                && settings.flat_sample == FlatSample::VertexMean;
            case.reports_normals() || case.interpolates() || is_mean
        },
        lacks: "only Gouraud and Phong shading take the normals of corners",
    },
    Condition {
        holds: |case| case.reports_normals() || case.settings.show != Show::Shaded || !case.object.given,
        lacks: UNGIVEN.lacks,
    },
    Condition { holds: |case| case.reports_normals() || (LAMPS.holds)(case), lacks: LAMPS.lacks },
];

const FLAT: Condition =
    Condition { holds: |case| case.settings.shading == Shading::Flat, lacks: "there is no flat shading" };

/// Normals are turned to the side that is seen, for light and where they are shown.
const SIDES: &[Condition] = &[
    Condition {
        holds: |case| matches!(case.settings.show, Show::Shaded | Show::Normals),
        lacks: "--show shows neither light nor normals",
    },
    Condition { holds: |case| case.settings.show == Show::Normals || (LIT.holds)(case), lacks: LIT.lacks },
    Condition {
        holds: |case| case.settings.show == Show::Normals || (UNGIVEN.holds)(case),
        lacks: UNGIVEN.lacks,
    },
    Condition {
        holds: |case| case.settings.cull != Cull::Back,
        lacks: "faces seen from behind are left out",
    },
    LAMPS,
];

const TONE: Condition = Condition {
    holds: |case| {
        let is_shaded = (SHADED.holds)(case) && (LIT.holds)(case);
        let is_wire = case.settings.shading == Shading::Wireframe;
        is_shaded || case.background.largest() > 1.0 || is_wire && case.settings.wire.colour.largest() > 1.0
    },
    lacks: "no colour is over 1 without light",
};

const LINES: Condition = Condition {
    holds: |case| case.settings.shading == Shading::Wireframe || !case.args.shading.overlay.is_empty(),
    lacks: "there are no lines without --shading wireframe or --overlay",
};

const RETURNED: Condition = Condition {
    holds: |case| case.probes() || !(is_black(case.material().diffuse) && is_black(case.material().specular)),
    lacks: "both kd and ks of --material are 0",
};
const AMBIENT: Condition = Condition {
    holds: |case| case.probes() || !is_black(case.material().ambient),
    lacks: "ka of --material is 0",
};
const SOME_LIGHT: Condition = Condition {
    holds: |case| case.probes() || case.has_light(|light| light.colour() != LinearRgb::BLACK),
    lacks: "all light is black",
};

/// Every option that some drawings do not read, but for [`GUARDS`].
const OPTIONS: &[Reader] = &[
    reader("--weight", |args| args.normals.weight.is_some(), &[NORMALS]),
    reader("--crease", |args| args.normals.crease.is_some(), &[NORMALS]),
    reader("--when", |args| args.normals.when.is_some(), &[NORMALS]),
    reader(
        "--flat-sample",
        |args| args.shading.flat_sample.is_some(),
        &[&[SHADED, FLAT, UNGIVEN, FACES, LAMPS]],
    ),
    INTERPOLATION,
    reader("--hidden-lines", |args| args.shading.hidden_lines.is_some(), &[&[LINES, FACES]]),
    reader("--light", |args| !args.scene.light.is_empty(), &[LIGHT, &[RETURNED]]),
    reader("--ambient", |args| args.scene.ambient.is_some(), &[LIGHT, &[AMBIENT]]),
    reader("--material", |args| args.scene.material.is_some(), &[LIGHT, &[SOME_LIGHT]]),
    reader(
        "--reflection",
        |args| args.shading.reflection.is_some(),
        &[&[
            SHADED,
            LIT,
            Condition {
                holds: |case| {
                    let is_given = case.args.shading.reflection == Some(ReflectionChoice::Given);
                    is_given || case.was_given || (HIGHLIGHT.holds)(case)
                },
                lacks: HIGHLIGHT.lacks,
            },
        ]],
    ),
    reader("--exponent", |args| args.shading.exponent.is_some(), &[LIGHT, &[HIGHLIGHT]]),
    reader(
        "--literal",
        |args| args.colour.literal,
        &[
            LIGHT,
            &[Condition {
                holds: |case| GUARDS.iter().any(|guard| guard.applies(case)),
                lacks: "there is nothing to guard",
            }],
        ],
    ),
    reader("--terminator", |args| args.colour.terminator.is_some(), &[LIGHT, &[PHONG, FACES, LAMPS]]),
    reader("--two-sided", |args| args.shading.two_sided, &[SIDES]),
    reader("--tone", |args| args.colour.tone.is_some(), &[&[TONE]]),
];

/// Each guard.
const GUARDS: &[Reader] = &[
    reader("--guard highlight", |args| args.colour.switches("highlight"), &[LIGHT, &[HIGHLIGHT]]),
    reader(
        "--guard diffuse",
        |args| args.colour.switches("diffuse"),
        &[
            LIGHT,
            &[Condition {
                holds: |case| {
                    case.has_light(|light| !is_ambient(light) && !is_area(light) && case.scatters(light))
                },
                lacks: "there is no N·L to guard: kd is 0, or all light is ambient or of areas",
            }],
        ],
    ),
    reader(
        "--guard spot",
        |args| args.colour.switches("spot"),
        &[
            LIGHT,
            &[
                Condition {
                    holds: |case| case.has_light(|light| cone(light).is_some() && is_returned(case, light)),
                    lacks: "there is no spot",
                },
                Condition {
                    // Half a turn is none; what cuts off does so at a right angle or before.
                    holds: |case| {
                        case.has_light(|light| cone(light).is_some_and(|cone| cone.cut_off.0 > 2.0))
                    },
                    lacks: "a spot with a cut-off shines on nothing behind it anyway",
                },
            ],
        ],
    ),
    reader(
        "--guard renormalise",
        |args| args.colour.switches("renormalise"),
        &[LIGHT, &[PHONG, FACES, LAMPS]],
    ),
    reader(
        "--guard underflow",
        |args| args.colour.switches("underflow"),
        &[
            LIGHT,
            &[
                HIGHLIGHT,
                Condition {
                    holds: |case| case.probes() || case.has_light(may_be_vast),
                    lacks: "no light is so bright that 1e-38 of it could be seen",
                },
            ],
        ],
    ),
];

const fn reader(
    name: &'static str,
    is_typed: fn(&RenderArgs) -> bool,
    conditions: &'static [&'static [Condition]],
) -> Reader {
    Reader { name, is_typed, conditions }
}

/// Every option that some drawings do not read.
pub fn readers() -> impl Iterator<Item = &'static Reader> {
    OPTIONS.iter().chain(GUARDS)
}

impl Reader {
    /// Why the option changes nothing, if it is typed for nothing.
    pub fn unread(&self, args: &RenderArgs, cases: &[Case]) -> Option<&'static str> {
        if (self.is_typed)(args) { self.lack(cases) } else { None }
    }

    /// Why the option changes nothing: the first condition that no case is left to meet.
    pub fn lack(&self, cases: &[Case]) -> Option<&'static str> {
        let mut left: Vec<&Case> = cases.iter().collect();
        let unmet = self.conditions.iter().copied().flatten().find(|condition| {
            left.retain(|case| (condition.holds)(case));
            left.is_empty()
        });
        unmet.map(|condition| condition.lacks)
    }

    /// Whether it is read in a case.
    fn applies(&self, case: &Case) -> bool {
        self.conditions.iter().copied().flatten().all(|condition| (condition.holds)(case))
    }
}

/// Whether anything comes back of a light that is not the same everywhere.
fn is_returned(case: &Case, light: &Light) -> bool {
    !is_ambient(light) && (case.scatters(light) || case.shines(light))
}

fn is_ambient(light: &Light) -> bool {
    matches!(light, Light::Ambient { .. })
}

fn is_area(light: &Light) -> bool {
    matches!(light, Light::Area { .. })
}

/// Where a spot shines.
fn cone(light: &Light) -> Option<&Cone> {
    match light {
        Light::Spot { cone, .. } => Some(cone),
        _ => None,
    }
}

/// Whether a light is so bright, or becomes so near to it, that it could be seen of it what is below all normal numbers.
fn may_be_vast(light: &Light) -> bool {
    let (Light::Point { attenuation, .. } | Light::Spot { attenuation, .. }) = light else {
        return light.colour().largest() > VAST;
    };
    *attenuation != Attenuation::None || light.colour().largest() > VAST
}

/// Far below 1e38, for materials may return more than they get.
const VAST: f64 = 1e20;

fn is_black(reflectance: crease::shade::Reflectance) -> bool {
    reflectance.merged() == LinearRgb::BLACK
}
