//! The list of exercises: scene, pixel, and the digits that the lectures print.

/// An exercise about the colour of a point.
pub(super) struct Exercise {
    /// Its name in links.
    pub id: &'static str,
    /// The scene file in `data/scenes/lectures`, without its ending.
    pub scene: &'static str,
    pub text: &'static str,
    pub pixel: [u32; 2],
    pub change: Change,
    /// Printed decimals.
    pub decimals: u32,
}

/// The difference from the scene as its file has it.
#[derive(Clone, Copy)]
pub(super) enum Change {
    None,
    /// Blinn's highlight.
    Blinn,
    /// One colour for each face: the mean of its corners.
    Flat,
}

impl Exercise {
    /// The command that prints the same numbers.
    pub(super) fn command(&self) -> String {
        let option = match self.change {
            Change::None => "",
            Change::Blinn => " --reflection blinn",
            Change::Flat => " --shading flat",
        };
        let [x, y] = self.pixel;
        format!("crease render data/scenes/lectures/{}.toml --probe {x},{y}{option}", self.scene)
    }
}

macro_rules! exercises {
    ($($id:literal: $scene:literal, [$x:literal, $y:literal], $change:ident, $decimals:literal;)*) => {
        pub(super) static EXERCISES: &[Exercise] = &[$(Exercise {
            id: $id,
            scene: $scene,
            text: include_str!(concat!("../../../../data/scenes/lectures/", $scene, ".toml")),
            pixel: [$x, $y],
            change: Change::$change,
            decimals: $decimals,
        }),*];
    };
}

exercises! {
    "example-1": "example-01", [320, 240], None, 4;
    "example-1-blinn": "example-01", [320, 240], Blinn, 4;
    "example-2": "example-02", [320, 240], None, 4;
    "example-2-blinn": "example-02", [320, 240], Blinn, 4;
    "example-3": "example-03", [320, 240], None, 4;
    "example-3-blinn": "example-03", [320, 240], Blinn, 4;
    "1-6-16-matte": "exercise-1-6-16", [200, 240], None, 2;
    "1-6-16": "exercise-1-6-16", [440, 240], None, 2;
    "1-6-17": "exercise-1-6-17", [440, 240], None, 2;
    "1-6-18": "exercise-1-6-18", [440, 240], None, 2;
    "1-6-19": "exercise-1-6-19", [320, 240], None, 4;
    "1-6-19-blinn": "exercise-1-6-19", [320, 240], Blinn, 4;
    "1-6-23": "exercise-1-6-23", [320, 240], None, 3;
    "1-6-24": "exercise-1-6-24", [320, 240], None, 3;
    "1-6-25-a": "exercise-1-6-25", [170, 240], Flat, 3;
    "1-6-25-b1": "exercise-1-6-25", [170, 240], None, 3;
    "1-6-25-b2": "exercise-1-6-25", [470, 240], None, 3;
    "1-6-29": "exercise-1-6-29", [320, 240], None, 3;
    "1-6-31": "exercise-1-6-31", [320, 240], None, 4;
}
