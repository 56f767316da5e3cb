//! What a drawing reads: which options can change it, and why others cannot.

use super::args::{RenderArgs, Variant};
use crease::num::LinearRgb;
use crease::raster::{Cull, FlatSample, RenderSettings, SceneFile, SceneObject, SceneShape, Shading, Show};
use crease::report::Overlay;

/// One object in the picture, or in one of its panels: what decides which options are read.
pub struct Case<'a> {
    args: &'a RenderArgs,
    settings: RenderSettings,
    background: LinearRgb,
    object: &'a SceneObject,
}

/// What must hold for an option to be read, and what is said where it holds nowhere.
struct Condition {
    holds: fn(&Case) -> bool,
    lacks: &'static str,
}

/// An option, whether it is typed, and the conditions under which it is read: all of them, for one object at least.
pub struct Reader {
    pub name: &'static str,
    is_typed: fn(&RenderArgs) -> bool,
    conditions: &'static [Condition],
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
    holds: |case| !is_solid(case.object),
    lacks: "analytic surfaces without a tessellation have neither faces nor corners",
};
const SPREAD: Condition = Condition {
    holds: |case| case.probes() || !shows_no_values(case.settings.show),
    lacks: "what --show shows is not interpolated",
};

/// What light on a material reads.
const LIGHT: &[Condition] = &[SHADED, LIT, UNGIVEN];

const TERMINATOR: &[Condition] = &[
    SHADED,
    LIT,
    UNGIVEN,
    Condition { holds: |case| case.settings.shading == Shading::Phong, lacks: "only Phong shading heeds it" },
    FACES,
];

const FLAT_SAMPLE: &[Condition] = &[
    SHADED,
    Condition { holds: |case| case.settings.shading == Shading::Flat, lacks: "there is no flat shading" },
    UNGIVEN,
    FACES,
];

pub const INTERPOLATION: Reader = Reader {
    name: "--interpolation",
    is_typed: |args| args.shading.interpolation.is_some(),
    conditions: &[
        FACES,
        SPREAD,
        Condition {
            holds: |case| case.probes() || case.interpolates(),
            lacks: "only Gouraud and Phong shading interpolate",
        },
    ],
};

/// What normals of corners are read for. Lines along them, and probes, tell them whatever else is drawn.
const NORMALS: &[Condition] = &[
    Condition { holds: FACES.holds, lacks: "there are no meshes, whose normals would change" },
    Condition { holds: |case| case.tells_normals() || (SPREAD.holds)(case), lacks: SPREAD.lacks },
    Condition {
        holds: |case| {
            let settings = &case.settings;
            let is_mean = settings.shading == Shading::Flat
                && settings.show == Show::Shaded
                && settings.flat_sample == FlatSample::VertexMean;
            case.tells_normals() || case.interpolates() || is_mean
        },
        lacks: "only Gouraud and Phong shading take the normals of corners",
    },
    Condition {
        holds: |case| case.tells_normals() || case.settings.show != Show::Shaded || !case.object.given,
        lacks: UNGIVEN.lacks,
    },
];

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
];

const TONE: &[Condition] = &[Condition {
    holds: |case| {
        let is_shaded = (SHADED.holds)(case) && (LIT.holds)(case);
        let is_wire = case.settings.shading == Shading::Wireframe;
        is_shaded || case.background.largest() > 1.0 || is_wire && case.settings.wire.colour.largest() > 1.0
    },
    lacks: "no colour is over 1 without light",
}];

const LINES: &[Condition] = &[Condition {
    holds: |case| case.settings.shading == Shading::Wireframe || !case.args.shading.overlay.is_empty(),
    lacks: "there are no lines without --shading wireframe or --overlay",
}];

/// Every option that some drawings do not read.
pub const READERS: &[Reader] = &[
    Reader { name: "--weight", is_typed: |args| args.normals.weight.is_some(), conditions: NORMALS },
    Reader { name: "--crease", is_typed: |args| args.normals.crease.is_some(), conditions: NORMALS },
    Reader { name: "--when", is_typed: |args| args.normals.when.is_some(), conditions: NORMALS },
    Reader {
        name: "--flat-sample",
        is_typed: |args| args.shading.flat_sample.is_some(),
        conditions: FLAT_SAMPLE,
    },
    INTERPOLATION,
    Reader {
        name: "--hidden-lines",
        is_typed: |args| args.shading.hidden_lines.is_some(),
        conditions: LINES,
    },
    Reader { name: "--light", is_typed: |args| !args.scene.light.is_empty(), conditions: LIGHT },
    Reader { name: "--ambient", is_typed: |args| args.scene.ambient.is_some(), conditions: LIGHT },
    Reader { name: "--material", is_typed: |args| args.scene.material.is_some(), conditions: LIGHT },
    Reader {
        name: "--reflection",
        is_typed: |args| args.shading.reflection.is_some(),
        conditions: &[SHADED, LIT],
    },
    Reader { name: "--exponent", is_typed: |args| args.shading.exponent.is_some(), conditions: LIGHT },
    Reader { name: "--guard", is_typed: |args| !args.colour.guard.is_empty(), conditions: LIGHT },
    Reader { name: "--literal", is_typed: |args| args.colour.literal, conditions: LIGHT },
    Reader {
        name: "--terminator",
        is_typed: |args| args.colour.terminator.is_some(),
        conditions: TERMINATOR,
    },
    Reader { name: "--two-sided", is_typed: |args| args.shading.two_sided, conditions: SIDES },
    Reader { name: "--tone", is_typed: |args| args.colour.tone.is_some(), conditions: TONE },
];

impl Reader {
    /// Why the option changes nothing, if it is typed for nothing.
    pub fn unread(&self, args: &RenderArgs, cases: &[Case]) -> Option<&'static str> {
        if (self.is_typed)(args) { self.lack(cases) } else { None }
    }

    /// Why the option changes nothing: the first condition that no case is left to meet.
    pub fn lack(&self, cases: &[Case]) -> Option<&'static str> {
        let mut left: Vec<&Case> = cases.iter().collect();
        let unmet = self.conditions.iter().find(|condition| {
            left.retain(|case| (condition.holds)(case));
            left.is_empty()
        });
        unmet.map(|condition| condition.lacks)
    }
}

impl<'a> Case<'a> {
    /// The objects of a scene, in each panel if there are several.
    pub fn all(args: &'a RenderArgs, file: &'a SceneFile) -> Vec<Self> {
        let panels = match &args.output.compare[..] {
            [] => vec![file.settings],
            variants => variants.iter().map(|variant: &Variant| variant.settings(&file.settings)).collect(),
        };
        let case = |(settings, object)| Self { args, settings, background: file.background, object };
        let of_panel = |settings| file.objects.iter().map(move |object| (settings, object));
        panels.into_iter().flat_map(of_panel).map(case).collect()
    }

    /// The object that it is of.
    pub fn object(&self) -> &'a SceneObject {
        self.object
    }

    /// Where its colours are computed.
    pub fn shading(&self) -> Shading {
        self.settings.shading
    }

    /// Whether light falls on it.
    pub fn is_lit(&self) -> bool {
        LIGHT.iter().all(|condition| (condition.holds)(self))
    }

    fn probes(&self) -> bool {
        self.args.output.probe.is_some()
    }

    /// Whether values of corners are spread over faces.
    fn interpolates(&self) -> bool {
        match self.settings.shading {
            Shading::Gouraud | Shading::Phong => true,
            // What is shown in place of light are normals, which a wireframe interpolates as well.
            Shading::Wireframe => self.settings.show != Show::Shaded,
            Shading::Flat | Shading::Exact => false,
        }
    }

    /// Whether normals of corners are told, or drawn as lines.
    fn tells_normals(&self) -> bool {
        let draws = |overlay: &Overlay| matches!(overlay, Overlay::VertexNormals | Overlay::Creases);
        self.probes() || self.args.shading.overlay.iter().any(draws)
    }
}

/// Whether what is shown is nothing that corners carry.
pub fn shows_no_values(show: Show) -> bool {
    matches!(show, Show::Facing | Show::Depth | Show::FaceId)
}

/// Whether an object is drawn by casting rays, whatever the shading.
pub fn is_solid(object: &SceneObject) -> bool {
    matches!(object.shape, SceneShape::Surface(_))
}
