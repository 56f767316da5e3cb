//! Changes to a JSON text that leave every other byte alone.

use super::json::{Json, Value, quoted};
use std::collections::BTreeMap;
use std::ops::Range;

/// Changes to the members of an object: a new text, or `None` to remove the member.
pub type Changes = Vec<(String, Option<String>)>;

/// Changes to objects and top-level lists of a text. New members and elements are indented like the one before them.
pub struct Splices<'a> {
    json: &'a Json,
    objects: BTreeMap<Value, Changes>,
    lists: BTreeMap<&'static str, Vec<String>>,
    /// The elements to keep of top-level lists.
    kept: BTreeMap<&'static str, Vec<bool>>,
}

impl<'a> Splices<'a> {
    pub fn new(json: &'a Json) -> Self {
        Self { json, objects: BTreeMap::new(), lists: BTreeMap::new(), kept: BTreeMap::new() }
    }

    pub fn set(&mut self, object: Value, name: &str, text: impl ToString) {
        self.change(object, vec![(name.to_owned(), Some(text.to_string()))]);
    }

    pub fn remove(&mut self, object: Value, name: &str) {
        self.change(object, vec![(name.to_owned(), None)]);
    }

    pub fn change(&mut self, object: Value, changes: Changes) {
        let old = self.objects.entry(object).or_default();
        for (name, text) in changes {
            match old.iter_mut().find(|(other, _)| *other == name) {
                Some((_, old)) => *old = text,
                None => old.push((name, text)),
            }
        }
    }

    /// Adds an element to a top-level list, which is made if the document does not have it.
    pub fn push(&mut self, list: &'static str, text: String) {
        self.lists.entry(list).or_default().push(text);
    }

    /// Removes the other elements of a top-level list, and the list with the last of them. Nothing may be added to it.
    pub fn keep(&mut self, list: &'static str, kept: Vec<bool>) {
        self.kept.insert(list, kept);
    }

    /// Lists an extension as one that the document uses and requires.
    pub fn require(&mut self, extension: &str) {
        let json = self.json;
        for list in ["extensionsUsed", "extensionsRequired"] {
            let mut names = json.items(json.root(), list).filter_map(|name| json.string(name));
            if !names.any(|name| name == extension) {
                self.push(list, quoted(extension));
            }
        }
    }

    pub fn is_empty(&self) -> bool {
        self.objects.is_empty() && self.lists.is_empty() && self.kept.is_empty()
    }

    pub fn apply(mut self) -> String {
        let json = self.json;
        let mut splices: Vec<(Range<usize>, String)> = Vec::new();
        for (name, elements) in std::mem::take(&mut self.lists) {
            match json.member(json.root(), name) {
                Some(array) => splices.push(array_splice(json, array, &elements)),
                None => self.set(json.root(), name, format!("[{}]", elements.join(","))),
            }
        }
        for (name, kept) in std::mem::take(&mut self.kept) {
            match json.member(json.root(), name) {
                Some(array) if kept.contains(&true) => splices.extend(removals(json, array, &kept)),
                _ => self.remove(json.root(), name),
            }
        }
        for (&object, changes) in &self.objects {
            object_splices(json, object, changes, &mut splices);
        }
        spliced(json.text(), 0..json.text().len(), splices)
    }
}

pub fn changed_object(json: &Json, object: Value, changes: &Changes) -> String {
    let mut splices = Vec::new();
    object_splices(json, object, changes, &mut splices);
    spliced(json.text(), json.span(object), splices)
}

fn spliced(text: &str, range: Range<usize>, mut splices: Vec<(Range<usize>, String)>) -> String {
    splices.sort_by_key(|(span, _)| (span.start, span.end));
    let mut out =
        String::with_capacity(range.len() + splices.iter().map(|(_, text)| text.len()).sum::<usize>());
    let mut at = range.start;
    for (span, replacement) in splices {
        out.push_str(&text[at..span.start]);
        out.push_str(&replacement);
        at = span.end;
    }
    out.push_str(&text[at..range.end]);
    out
}

fn object_splices(json: &Json, object: Value, changes: &Changes, out: &mut Vec<(Range<usize>, String)>) {
    let members: Vec<(Range<usize>, Range<usize>)> =
        json.members(object).map(|(key, value)| (json.span(key), json.span(value))).collect();
    let names: Vec<_> = json.members(object).map(|(key, _)| json.string(key).unwrap_or_default()).collect();
    let change = |name: &str| changes.iter().find(|(changed, _)| changed == name);
    let mut kept = false;
    for (number, (key, value)) in members.iter().enumerate() {
        match change(&names[number]) {
            Some((_, None)) => {
                // A member leaves with the comma before it, or the one after it if none before it stays.
                let span = match (kept, members.get(number + 1)) {
                    (true, _) => members[number - 1].1.end..value.end,
                    (false, Some((next, _))) => key.start..next.start,
                    (false, None) => key.start..value.end,
                };
                out.push((span, String::new()));
            }
            Some((name, Some(text))) => {
                kept = true;
                // Of duplicates the last one counts.
                if !names[number + 1..].iter().any(|later| later == name) {
                    out.push((value.clone(), text.clone()));
                }
            }
            None => kept = true,
        }
    }
    let new = changes.iter().filter(|(name, _)| !names.iter().any(|old| old == name));
    let new = new.filter_map(|(name, text)| Some((name, text.as_ref()?)));
    let text = json.text();
    let (colon, blanks, at) = match members.last() {
        Some((key, value)) => (&text[key.end..value.start], blanks_before(text, key.start), value.end),
        None => (":", "", json.span(object).end - 1),
    };
    let mut insertion = String::new();
    for (name, text) in new {
        if kept {
            insertion.push(',');
            insertion.push_str(blanks);
        }
        insertion.push_str(&quoted(name));
        insertion.push_str(colon);
        insertion.push_str(text);
        kept = true;
    }
    if !insertion.is_empty() {
        out.push((at..at, insertion));
    }
}

fn array_splice(json: &Json, array: Value, elements: &[String]) -> (Range<usize>, String) {
    match json.elements(array).last().map(|value| json.span(value)) {
        Some(last) => {
            let separator = format!(",{}", blanks_before(json.text(), last.start));
            (last.end..last.end, separator.clone() + &elements.join(&separator))
        }
        None => {
            let at = json.span(array).end - 1;
            (at..at, elements.join(","))
        }
    }
}

/// An element leaves with the comma before it, or those before the first that stays with the comma after them.
fn removals(json: &Json, array: Value, kept: &[bool]) -> Vec<(Range<usize>, String)> {
    let spans: Vec<Range<usize>> = json.elements(array).map(|value| json.span(value)).collect();
    let first = kept.iter().position(|&kept| kept).unwrap_or(0);
    let span_of = |number: usize| match number {
        number if number < first => spans[number].start..spans[number + 1].start,
        number => spans[number - 1].end..spans[number].end,
    };
    let removed = (0..spans.len().min(kept.len())).filter(|&number| !kept[number]);
    removed.map(|number| (span_of(number), String::new())).collect()
}

fn blanks_before(text: &str, at: usize) -> &str {
    let blanks = text.as_bytes()[..at].iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
    &text[at - blanks..at]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Json {
        Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap()
    }

    fn changed(text: &str, changes: &[(&str, Option<&str>)]) -> String {
        let json = parse(text);
        let mut splices = Splices::new(&json);
        for &(name, text) in changes {
            match text {
                Some(text) => splices.set(json.root(), name, text),
                None => splices.remove(json.root(), name),
            }
        }
        splices.apply()
    }

    #[test]
    fn members_change_and_nothing_else_does() {
        let text = "{ \"a\" : 1.0,\n  \"b\": [2] ,\n  \"c\": {} }";
        assert_eq!(changed(text, &[("b", Some("3"))]), text.replace("[2]", "3"));
        assert_eq!(
            changed(text, &[("d", Some("4"))]),
            "{ \"a\" : 1.0,\n  \"b\": [2] ,\n  \"c\": {},\n  \"d\": 4 }"
        );
        assert_eq!(changed(text, &[("zz", None)]), text);
        assert_eq!(changed("{}", &[("d", Some("4")), ("e", Some("5"))]), "{\"d\":4,\"e\":5}");
        assert_eq!(changed("{\"a\":1,\"a\":2}", &[("a", Some("3"))]), "{\"a\":1,\"a\":3}");
    }

    #[test]
    fn every_way_to_take_members_out_leaves_json() {
        let text = "{ \"a\" : 1 , \"b\":2,\"c\": 3 }";
        for taken in 0..8_u32 {
            for added in 0..3 {
                let mut changes: Vec<(&str, Option<&str>)> = Vec::new();
                let names = ["a", "b", "c"];
                changes.extend((0..3).filter(|bit| taken >> bit & 1 == 1).map(|bit| (names[bit], None)));
                changes.extend([("x", Some("8")), ("y", Some("9"))].into_iter().take(added));
                let result: serde_json::Value = serde_json::from_str(&changed(text, &changes)).unwrap();
                let members = result.as_object().unwrap();
                assert_eq!(members.len(), 3 - taken.count_ones() as usize + added);
                assert!(
                    names
                        .iter()
                        .enumerate()
                        .all(|(bit, name)| members.contains_key(*name) == (taken >> bit & 1 == 0))
                );
            }
        }
    }

    #[test]
    fn arrays_grow_at_their_end() {
        let json = parse("{\"a\":[ ],\"b\":[\n  1,\n  2\n]}");
        let mut splices = Splices::new(&json);
        for (list, text) in [("a", "7"), ("a", "8"), ("b", "3"), ("c", "4"), ("c", "5")] {
            splices.push(list, text.into());
        }
        assert_eq!(splices.apply(), "{\"a\":[ 7,8],\"b\":[\n  1,\n  2,\n  3\n],\"c\":[4,5]}");
    }

    #[test]
    fn every_way_to_remove_elements_leaves_json() {
        let text = "{ \"a\" : [ {\"x\":0} , {\"x\":1},\n{\"x\":2}, {\"x\":3} ], \"b\": 1 }";
        let json = parse(text);
        let array = json.member(json.root(), "a").unwrap();
        for mask in 0..16_u32 {
            let kept: Vec<bool> = (0..4).map(|bit| mask >> bit & 1 == 1).collect();
            let mut splices = Splices::new(&json);
            splices.keep("a", kept.clone());
            for (object, _) in json.elements(array).zip(&kept).filter(|(_, kept)| **kept) {
                splices.set(object, "y", "true");
            }
            let result: serde_json::Value = serde_json::from_str(&splices.apply()).unwrap();
            let expected: Vec<_> =
                (0..4).filter(|&n| kept[n]).map(|n| serde_json::json!({"x": n, "y": true})).collect();
            assert_eq!(result["b"], 1);
            assert_eq!(
                result.get("a").and_then(|a| a.as_array()),
                Some(&expected).filter(|list| !list.is_empty())
            );
        }
    }

    #[test]
    fn a_copy_of_an_object_takes_changes() {
        let json = parse("[{\"a\":1,\"b\":2}]");
        let object = json.elements(json.root()).next().unwrap();
        let changes = vec![("a".to_owned(), None), ("c".to_owned(), Some("3".to_owned()))];
        assert_eq!(changed_object(&json, object, &changes), "{\"b\":2,\"c\":3}");
    }
}
