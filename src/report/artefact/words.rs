//! What pages say beside what experiments say.

use crate::artefact::{Language, Role, Text};

pub(super) const LABORATORY: Text = Text::new("The artefact laboratory", "O laboratório de artefatos");
pub(super) const LEAD: Text = Text::new(
    "What textbooks say of the artefacts of shading, put to the test: each claim with pictures, measured numbers beside their \
     closed forms, and the conditions under which it fails.",
    "O que os livros dizem dos artefatos de sombreamento, posto à prova: cada afirmação com imagens, números medidos ao lado \
     das suas fórmulas, e as condições em que falha.",
);
pub(super) const CONTENTS: Text = Text::new("Contents", "Conteúdo");
pub(super) const ALL: Text = Text::new("All experiments", "Todos os experimentos");
pub(super) const CLAIM: Text = Text::new("The claim", "A afirmação");
pub(super) const VERDICT: Text = Text::new("Verdict", "Veredito");
pub(super) const HOLDS: Text = Text::new("It holds", "Vale");
pub(super) const HOLDS_ONLY_IF: Text = Text::new("It holds only if", "Vale somente se");
pub(super) const FAILS: Text = Text::new("It fails", "Não vale");
pub(super) const PICTURES: Text = Text::new("Pictures", "Imagens");
pub(super) const MOVED: Text = Text::new("The number that moved", "O número que mudou");
pub(super) const MEASURED: Text = Text::new("Measured", "Medido");
pub(super) const PLOTS: Text = Text::new("Plots", "Gráficos");
pub(super) const EXPLAINED: Text = Text::new("What is seen", "O que se vê");
pub(super) const REPRODUCE: Text = Text::new("Do it again", "Refazer");
pub(super) const COMMAND: Text = Text::new(
    "One command draws and measures all of this again; each picture is a file of its own, named below it:",
    "Um comando desenha e mede tudo isto de novo; cada imagem é um arquivo, cujo nome está abaixo dela:",
);
pub(super) const QUANTITY: Text = Text::new("quantity", "grandeza");
pub(super) const FOUND: Text = Text::new("measured", "medido");
pub(super) const EXPECTED: Text = Text::new("expected", "esperado");
pub(super) const WITHIN: Text = Text::new("within", "tolerância");
pub(super) const AGREES: Text = Text::new("agrees", "confere");
pub(super) const BY: Text = Text::new("by", "por");
pub(super) const YES: Text = Text::new("yes", "sim");
pub(super) const NO: Text = Text::new("NO", "NÃO");
pub(super) const EXPERIMENT: Text = Text::new("experiment", "experimento");
pub(super) const TITLE: Text = Text::new("title", "título");
pub(super) const OPTIONS: Text = Text::new("options", "opções");
pub(super) const OWN_MESH: Text = Text::new("of a mesh of your own (--mesh)", "de uma malha sua (--mesh)");
pub(super) const EXPERIMENTS: Text = Text::new("Experiments", "Experimentos");

/// What a picture is there for.
pub(super) fn role(role: Role) -> Text {
    match role {
        Role::Bad => Text::new("artefact", "artefato"),
        Role::Cured => Text::new("cured", "curado"),
        Role::Difference => Text::new("difference", "diferença"),
        Role::Truth => Text::new("truth", "verdade"),
    }
}

/// What a number came to.
pub(super) fn moved(
    name: &Text,
    cure: &Text,
    bad: &str,
    cured: &str,
    factor: &str,
    language: Language,
) -> String {
    let (name, cure) = (name.get(language), cure.get(language));
    match language {
        Language::English => {
            format!("{name}: {bad} with the artefact, {cured} after the cure ({cure}): {factor} times less.")
        }
        Language::Portuguese => {
            format!("{name}: {bad} com o artefato, {cured} depois da cura ({cure}): {factor} vezes menos.")
        }
    }
}

/// A number to six significant digits, with the language's decimal mark.
pub(super) fn number(x: f64, language: Language) -> String {
    let text = match x.abs() {
        0.0 => "0".to_owned(),
        _ if x.is_infinite() => if x > 0.0 { "∞" } else { "−∞" }.to_owned(),
        magnitude @ 1e-4..1e7 => {
            let decimals = (5 - libm::floor(libm::log10(magnitude)) as i32).max(0) as usize;
            let text = format!("{x:.decimals$}");
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
        _ => format!("{x:.2e}"),
    };
    match language {
        Language::English => text,
        Language::Portuguese => text.replace('.', ","),
    }
}

/// A number with its unit.
pub(super) fn quantity(x: f64, unit: &str, language: Language) -> String {
    let space = if unit.is_empty() || unit == "°" { "" } else { " " };
    format!("{}{space}{unit}", number(x, language))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let shown = [0.0, 70.528_779, -0.134_38, 1e-7, 0.1, 1_234_567.0, f64::INFINITY]
            .map(|x| number(x, Language::English));
        assert_eq!(shown, ["0", "70.5288", "-0.13438", "1.00e-7", "0.1", "1234567", "∞"]);
        assert_eq!(quantity(70.5, "°", Language::Portuguese), "70,5°");
        assert_eq!(quantity(3.0, "px", Language::English), "3 px");
    }
}
