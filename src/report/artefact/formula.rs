//! Formulas without a network: a plain notation as MathML, which browsers typeset by themselves.

use crate::report::escape_html;
use std::iter::Peekable;
use std::str::Chars;

/// The notation of [`Formula`](crate::artefact::Formula) as an element of a page.
///
/// ```
/// let root = crate_mathml("\\sqrt{x_1}");
/// # fn crate_mathml(text: &str) -> String { crease::report::mathml(text) }
/// assert!(root.contains("<msqrt><mrow><msub><mi>x</mi><mn>1</mn></msub></mrow></msqrt>"));
/// ```
pub fn mathml(notation: &str) -> String {
    let row = all_terms(notation);
    let alternative = notation.replace("\\quad ", "");
    let alternative = escape_html(&alternative);
    format!("<math display=\"block\" alttext=\"{alternative}\"><mrow>{row}</mrow></math>")
}

type Signs<'a> = Peekable<Chars<'a>>;

/// A whole notation. A brace that closes nothing is left out.
fn all_terms(notation: &str) -> String {
    let mut signs = notation.chars().peekable();
    let mut row = String::new();
    while signs.peek().is_some() {
        row.push_str(&terms(&mut signs));
        signs.next();
    }
    row
}

/// Everything up to the brace that closes the group, or the end.
fn terms(signs: &mut Signs) -> String {
    let (mut row, mut ends_term) = (String::new(), false);
    while let Some(&next) = signs.peek().filter(|&&c| c != '}') {
        if let Some(base) = atom(signs) {
            row.push_str(&scripts(base, signs));
            ends_term = next.is_alphanumeric() || ")]}|\\".contains(next);
        } else if ends_term && signs.peek().is_some_and(|&c| c.is_alphabetic()) {
            // Functions stand off from what they are multiplied with.
            row.push_str("<mspace width=\"0.17em\"></mspace>");
        }
    }
    row
}

/// What stands below and above a term.
fn scripts(mut base: String, signs: &mut Signs) -> String {
    let (mut below, mut above) = (None, None);
    while let Some(&mark) = signs.peek().filter(|&&c| "_^′".contains(c)) {
        signs.next();
        match mark {
            '_' => below = atom(signs),
            '^' => above = atom(signs),
            // A sign that is small and high by itself, and would be tiny above.
            _ => base = format!("<mrow>{base}<mo lspace=\"0\" rspace=\"0\">′</mo></mrow>"),
        }
    }
    match (below, above) {
        (None, None) => base,
        (Some(below), None) => format!("<msub>{base}{below}</msub>"),
        (None, Some(above)) => format!("<msup>{base}{above}</msup>"),
        (Some(below), Some(above)) => format!("<msubsup>{base}{below}{above}</msubsup>"),
    }
}

/// A number, a name, a sign, or a group; `None` for a space.
fn atom(signs: &mut Signs) -> Option<String> {
    let first = signs.next()?;
    Some(match first {
        ' ' => return None,
        '{' => group(signs),
        '\\' => match taken(signs, |c| c.is_ascii_alphabetic()).as_str() {
            "frac" => format!("<mfrac>{}{}</mfrac>", argument(signs), argument(signs)),
            "sqrt" => format!("<msqrt>{}</msqrt>", argument(signs)),
            // Between two formulas on one line.
            "quad" => "<mspace width=\"1em\"></mspace>".to_owned(),
            name => format!("<mi>{name}</mi>"),
        },
        c if c.is_ascii_digit() => format!("<mn>{c}{}</mn>", number(signs)),
        c if is_of_words(c) => {
            format!("<mi>{c}{}</mi>", taken(signs, is_of_words))
        }
        c if c.is_alphabetic() => format!("<mi>{c}</mi>"),
        // Which of a pair of bars closes is not told, so they neither stretch nor keep a distance.
        '|' => "<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo>".to_owned(),
        '(' if let Some(inner) = tall(signs) => {
            signs.nth(inner.chars().count());
            // A row of its own, so that the brackets are as tall as what is between them, and scripts stand at its end.
            format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", all_terms(&inner))
        }
        // Stretched by itself, as scripts have their bases, a bracket would sink below its line.
        c @ ('(' | ')' | '[' | ']') => format!("<mo stretchy=\"false\">{c}</mo>"),
        '/' => "<mo lspace=\"0\" rspace=\"0\">/</mo>".to_owned(),
        c => format!("<mo>{}</mo>", escape_html(&c.to_string())),
    })
}

/// What stands between the bracket that was taken and the one that closes it, if there is a fraction in it.
fn tall(signs: &Signs) -> Option<String> {
    let (mut inner, mut open) = (String::new(), 1);
    for c in signs.clone() {
        open += i32::from(c == '(') - i32::from(c == ')');
        if open == 0 {
            return inner.contains("\\frac").then_some(inner);
        }
        inner.push(c);
    }
    None
}

/// Letters of words: those of English and Portuguese. Greek ones stand for quantities, each for one.
fn is_of_words(c: char) -> bool {
    c.is_alphabetic() && c <= 'ÿ'
}

/// What is left of a number whose first digit was taken: a point or comma belongs to it if a digit follows.
fn number(signs: &mut Signs) -> String {
    let mut digits = String::new();
    while let Some(&c) = signs.peek() {
        let is_mark = ['.', ','].contains(&c) && signs.clone().nth(1).is_some_and(|c| c.is_ascii_digit());
        if !c.is_ascii_digit() && !is_mark {
            break;
        }
        signs.next();
        digits.push(c);
    }
    digits
}

/// The group that follows a command; nothing if none does.
fn argument(signs: &mut Signs) -> String {
    match signs.next_if_eq(&'{') {
        Some(_) => group(signs),
        None => "<mrow></mrow>".to_owned(),
    }
}

/// What is left of a group whose brace was taken.
fn group(signs: &mut Signs) -> String {
    let row = terms(signs);
    signs.next();
    format!("<mrow>{row}</mrow>")
}

fn taken(signs: &mut Signs, is_taken: impl Fn(char) -> bool) -> String {
    std::iter::from_fn(|| signs.next_if(|&c| is_taken(c))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(notation: &str) -> String {
        let all = mathml(notation);
        let row = all.split_once("<mrow>").unwrap().1;
        row.strip_suffix("</mrow></math>").unwrap().to_owned()
    }

    #[test]
    fn terms_are_set_as_they_are_meant() {
        assert_eq!(row("2x"), "<mn>2</mn><mi>x</mi>");
        let [open, close] = ['(', ')'].map(|bracket| format!("<mo stretchy=\"false\">{bracket}</mo>"));
        assert_eq!(row("cos(θ_L)"), format!("<mi>cos</mi>{open}<msub><mi>θ</mi><mi>L</mi></msub>{close}"));
        assert_eq!(
            row("ΔI′_{ab}"),
            "<mi>Δ</mi><msub><mrow><mi>I</mi><mo lspace=\"0\" rspace=\"0\">′</mo></mrow><mrow><mi>ab</mi></mrow></msub>"
        );
        let space = "<mspace width=\"0.17em\"></mspace>";
        assert_eq!(row("2 sin − x"), format!("<mn>2</mn>{space}<mi>sin</mi><mo>−</mo><mi>x</mi>"));
        assert_eq!(row("x_1^2"), "<msubsup><mi>x</mi><mn>1</mn><mn>2</mn></msubsup>");
        assert_eq!(
            row("w_{trás} 0,5, 1"),
            "<msub><mi>w</mi><mrow><mi>trás</mi></mrow></msub><mn>0,5</mn><mo>,</mo><mn>1</mn>"
        );
        let half = "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>";
        assert_eq!(row("\\frac{1}{2} < 1"), format!("{half}<mo>&lt;</mo><mn>1</mn>"));
        // As tall as the fraction, and the script at the end of all of it.
        assert_eq!(
            row("(\\frac{1}{2})^2"),
            format!("<msup><mrow><mo>(</mo>{half}<mo>)</mo></mrow><mn>2</mn></msup>")
        );
        assert_eq!(row("π/2"), "<mi>π</mi><mo lspace=\"0\" rspace=\"0\">/</mo><mn>2</mn>");
    }

    /// Whatever comes, tags are closed in the order in which they were opened.
    #[test]
    fn broken_notation_gives_sound_markup() {
        for notation in [
            "{",
            "}",
            "a}b",
            "\\frac{1}",
            "\\frac",
            "x_",
            "^",
            "(\\frac}",
            "(\\frac{)}",
            "\\sqrt{\\frac{a}{b_",
            "_{^{",
        ] {
            let all = mathml(notation);
            let mut open = Vec::new();
            for tag in all.split('<').skip(1).map(|tag| tag.split_once('>').unwrap().0) {
                match tag.strip_prefix('/') {
                    Some(name) => assert_eq!(open.pop(), Some(name), "{all}"),
                    None => open.push(tag.split(' ').next().unwrap()),
                }
            }
            assert!(open.is_empty(), "{all}");
        }
    }
}
