//! The requests of the laboratory in a browser, answered natively. The answers stay in `target/tmp/laboratory`, where the browser's
//! test compares them with its own.

use crease_web::{Answer, write_answers};
use std::path::Path;

#[test]
fn every_request_of_the_laboratory_has_an_answer() {
    let requests = Path::new(env!("CARGO_MANIFEST_DIR")).join("bindings/web/tests/requests.json");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("laboratory");
    let (mut answers, mut buffers) = (0, 0);
    let check = |name: &str, answer: &Answer, _| {
        let json: serde_json::Value = serde_json::from_str(&answer.json).unwrap();
        assert!(json.get("error").is_none(), "{name}: {json}");
        answers += 1;
        buffers += answer.buffers.len();
    };
    write_answers(&requests, &folder, check).unwrap();
    assert!(answers >= 68 && buffers >= 210, "{answers} answers, {buffers} buffers");
}
