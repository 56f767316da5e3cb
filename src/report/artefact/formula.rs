//! Formulas as MathML, which browsers typeset by themselves, and in words for screen readers.

use crate::report::escape_html;
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

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
    use super::*;
    use crate::artefact::{EXPERIMENTS, Language, Setup};

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
