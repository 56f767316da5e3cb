//! What `crease trade --json` tells.
//!
//! # The JSON schema, `crease-trade/1`
//! One object on one line.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-trade/1"`; the program's version |
//! | `status`, `error` | as in `crease-normals/1` |
//! | `input` | the mesh that was given, if any |
//! | `output` | the page, if one was asked for |
//! | `surfaces` | without an input: [`Trade`](crease::trade::Trade), whose members are described there |
//! | `mesh` | with one: [`OwnMesh`](crease::trade::OwnMesh) |
//! | `advice` | sentences |
//! | `seconds` | how long it took |
//!
//! Angles are in degrees. Nanoseconds (`…_ns`, `ns…`), `milliseconds`, `ratio` and `seconds` differ from run to run, and so may
//! the sentences that name them; nothing else does.

use super::super::report::Head;
use super::args::TradeArgs;
use crease::trade::{OwnMesh, Trade, advice};
use serde::{Serialize, Serializer};

#[derive(Debug, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub input: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub measured: Option<Measured>,
    pub seconds: f64,
}

/// What was measured.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Measured {
    Surfaces(#[serde(serialize_with = "surfaces")] Box<Trade>),
    Own(#[serde(serialize_with = "own")] Box<OwnMesh>),
}

impl Report {
    pub fn new(args: &TradeArgs) -> Self {
        Self {
            head: Head::new("crease-trade/1"),
            input: args.input.as_ref().map(|path| path.to_string_lossy().into_owned()),
            output: None,
            measured: None,
            seconds: 0.0,
        }
    }
}

#[derive(Serialize)]
struct SurfacesMembers<'a> {
    surfaces: &'a Trade,
    advice: Vec<String>,
}

#[derive(Serialize)]
struct OwnMembers<'a> {
    mesh: &'a OwnMesh,
    advice: &'a [String],
}

fn surfaces<S: Serializer>(trade: &Trade, serializer: S) -> Result<S::Ok, S::Error> {
    SurfacesMembers { surfaces: trade, advice: advice(trade) }.serialize(serializer)
}

fn own<S: Serializer>(own: &OwnMesh, serializer: S) -> Result<S::Ok, S::Error> {
    OwnMembers { mesh: own, advice: &own.reasons }.serialize(serializer)
}
