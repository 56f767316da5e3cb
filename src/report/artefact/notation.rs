//! Formulas as MathML and in words, and sub- and superscripts in running text, where there is no room for a formula.

use crate::report::escape_html;
use crate::report::html::with_code_in;
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Running text as HTML: `θ_L`, `c_{13}`, `cosⁿ` and `sin(α)^n` with their scripts below and above the line, names between
/// backticks as code. A number stays on one line with its unit and its power of ten.
///
/// A subscript belongs to a single letter, so that names of files and of options do not change. A script is a
/// group in braces or parentheses, which are not shown, or the letters and digits that follow.
pub fn running(text: &str) -> String {
    with_code_in(text, scripts)
}

fn scripts(text: &str, out: &mut String) {
    // What is before the mark, and up to where it is written.
    let (mut written, mut before): (usize, [Option<char>; 2]) = (0, [None; 2]);
    for (place, c) in text.char_indices() {
        if place < written {
            continue;
        }
        let element = match c {
            '_' if is_letter(before) => Some("sub"),
            '^' if before[1].is_some_and(|c| c.is_alphanumeric() || c == ')') => Some("sup"),
            _ => None,
        };
        let found = element.and_then(|element| Some((element, script(&text[place + c.len_utf8()..])?)));
        match found {
            Some((element, (script, length))) => {
                out.push_str(&format!("<{element}>{}</{element}>", escape_html(script)));
                written = place + c.len_utf8() + length;
                before = [before[1], script.chars().last()];
            }
            None => {
                let after = &text[place + c.len_utf8()..];
                match c {
                    ' ' if is_in_number(before[1], after) => out.push(NO_BREAK),
                    _ => out.push_str(&escape_html(&text[place..place + c.len_utf8()])),
                }
                if c == '/' && after.starts_with('°') {
                    out.push(JOINER);
                }
                before = [before[1], Some(c)];
            }
        }
    }
}

/// A space at which no line ends, and nothing at which one does.
const NO_BREAK: char = '\u{a0}';
const JOINER: char = '\u{2060}';

/// Whether a space after a sign is within `3 px`, `11 %` or `2 × 10⁻⁵`.
fn is_in_number(before: Option<char>, after: &str) -> bool {
    let is_unit =
        |unit: &str| after.strip_prefix(unit).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric));
    match before {
        Some('×') => after.starts_with("10"),
        Some(digit) if digit.is_numeric() => {
            after.starts_with("× 10") || ["px", "%"].into_iter().any(is_unit)
        }
        _ => false,
    }
}

fn is_letter([before, last]: [Option<char>; 2]) -> bool {
    last.is_some_and(char::is_alphabetic) && !before.is_some_and(|c| c.is_alphanumeric() || "_.-".contains(c))
}

/// The script at the start of a text, and how long it is there; none if nothing is there.
fn script(text: &str) -> Option<(&str, usize)> {
    for (open, close) in [('{', '}'), ('(', ')')] {
        if let Some(rest) = text.strip_prefix(open) {
            return rest.find(close).map(|end| (&rest[..end], end + 2));
        }
    }
    let end = text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len());
    (end > 0).then(|| (&text[..end], end))
}

/// A formula in LaTeX notation as an element of a page, with [`spoken`] as its alternative text.
///
/// A part that is no LaTeX becomes an error element of MathML; the tests of the pages find it.
///
/// ```
/// let root = crease::report::mathml("\\sqrt{x_1}");
/// assert!(root.contains("<msqrt>") && root.contains("<msub>"));
/// ```
pub fn mathml(latex: &str) -> String {
    let storage = Storage::new();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut element = String::new();
    // Writing to a string cannot fail; what the parser refuses is written as an error element.
    let _ = push_mathml(&mut element, Parser::new(latex, &storage), config);
    let alternative = format!("<math alttext=\"{}\"", escape_html(&spoken(latex)));
    element.replacen("<math", &alternative, 1)
}

/// A formula on one line as it is read aloud: fractions with a slash, and no commands of layout.
///
/// ```
/// assert_eq!(crease::report::spoken("A = \\frac{1}{2} L \\cos(δ)"), "A = (1)/(2) L cos(δ)");
/// ```
pub fn spoken(latex: &str) -> String {
    let mut text = latex.replace("{,}", ",");
    for layout in ["\\left", "\\right", "\\quad ", "\\mathrm"] {
        text = text.replace(layout, "");
    }
    while let Some((before, after)) = text.split_once("\\frac") {
        let Some((above, rest)) = group(after) else { break };
        let Some((below, rest)) = group(rest) else { break };
        text = format!("{before}({above})/({below}){rest}");
    }
    text.replace("\\sqrt", "√").replace('\\', "")
}

/// The content of the braces that a text begins with, and what follows them.
fn group(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (place, c) in text.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return (c == '}').then(|| (&text[1..place], &text[place + 1..]));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{running, *};
    use crate::artefact::{EXPERIMENTS, Language, Setup};

    #[test]
    fn scripts_stand_below_and_above() {
        for (text, html) in [
            ("cos(θ_L) < 1/3", "cos(θ<sub>L</sub>) &lt; 1/3"),
            ("(k_d + k_s M(n)) δ", "(k<sub>d</sub> + k<sub>s</sub> M(n)) δ"),
            ("cos(α)^n, cos^n", "cos(α)<sup>n</sup>, cos<sup>n</sup>"),
            ("z_far/z_near", "z<sub>far</sub>/z<sub>near</sub>"),
            ("(I₀h)^(2/3) − h²", "(I₀h)<sup>2/3</sup> − h²"),
            ("w_{trás}^2", "w<sub>trás</sub><sup>2</sup>"),
            ("|e_1| |e_2|", "|e<sub>1</sub>| |e<sub>2</sub>|"),
        ] {
            assert_eq!(running(text), html);
        }
    }

    #[test]
    fn numbers_stay_with_their_units() {
        for (text, html) in [
            ("σ 1.5 px, 3 px; 67 px/° (8 %)", "σ 1.5\u{a0}px, 3\u{a0}px; 67\u{a0}px/\u{2060}° (8\u{a0}%)"),
            ("1,25 × 10⁻¹⁷ px", "1,25\u{a0}×\u{a0}10⁻¹⁷\u{a0}px"),
            ("2 pxs, 640 × 480, n × 10, a/b", "2 pxs, 640 × 480, n ×\u{a0}10, a/b"),
        ] {
            assert_eq!(running(text), html);
        }
    }

    #[test]
    fn what_is_no_notation_stays() {
        for text in ["a_ b", "_x", "^", "x_{", "x^(", "my_mesh.obj", "--no_such"] {
            assert_eq!(running(text), text);
        }
        assert_eq!(running("of `a_b<.obj`."), "of <code>a_b&lt;.obj</code>.");
    }

    #[test]
    fn formulas_of_all_experiments_are_typeset() {
        let mut count = 0;
        for experiment in EXPERIMENTS {
            let setup = Setup { parameters: experiment.defaults, mesh: None };
            for formula in experiment.closed_forms(&setup) {
                for language in Language::ALL {
                    let latex = formula.notation.get(language);
                    let storage = Storage::new();
                    assert!(Parser::new(latex, &storage).all(|event| event.is_ok()), "{latex}");
                    let element = mathml(latex);
                    assert!(
                        element.contains("display=\"block\"") && !element.contains("merror"),
                        "{element}"
                    );
                    assert!(!spoken(latex).contains('\\'), "{}", spoken(latex));
                    count += 1;
                }
            }
        }
        assert!(count > 60, "{count}");
    }

    #[test]
    fn formulas_are_read_on_one_line() {
        for (latex, said) in [
            ("c_\\mathrm{max} = \\left(1 − \\frac{1}{n}\\right)^{2}", "c_{max} = (1 − (1)/(n))^{2}"),
            ("\\frac{\\frac{a}{b}}{c}", "((a)/(b))/(c)"),
            ("\\frac{a}", "frac{a}"),
            ("54{,}7356° = \\arctan(\\sqrt{2})", "54,7356° = arctan(√{2})"),
        ] {
            assert_eq!(spoken(latex), said);
        }
    }

    #[test]
    fn broken_notation_is_marked() {
        for latex in ["{", "\\frac{1}", "x_", "\\nothing"] {
            assert!(mathml(latex).starts_with("<math alttext="), "{latex}");
        }
    }
}
