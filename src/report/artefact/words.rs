//! What pages say beside what experiments say.

use crate::artefact::{Language, Moved, Outcome, Range, Role, Text};

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
pub(super) const NO_FORMULAS: Text = Text::new(
    "The closed forms of this experiment are of its own shapes; without --mesh it shows them.",
    "As fórmulas deste experimento são das suas próprias formas; sem --mesh ele as mostra.",
);
pub(super) const VERDICT: Text = Text::new("Verdict", "Veredito");
pub(super) const HOLDS: Text = Text::new("It holds", "Vale");
pub(super) const HOLDS_ONLY_IF: Text = Text::new("It holds only if", "Vale somente se");
pub(super) const FAILS: Text = Text::new("It fails", "Não vale");
pub(super) const ABSENT: Text = Text::new("Not put to the test here", "Não posto à prova aqui");
pub(super) const PICTURES: Text = Text::new("Pictures", "Imagens");
pub(super) const MOVED: Text = Text::new("The number that moved", "O número que mudou");
pub(super) const MEASURED: Text = Text::new("Measured", "Medido");
pub(super) const NUMBERS: Text = Text::new(
    "Every quantity, and what it should be where that is known",
    "Cada grandeza, e o que deveria ser onde isso se sabe",
);
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
pub(super) const NOTHING: Text = Text::same("–");
pub(super) const EXPERIMENT: Text = Text::new("experiment", "experimento");
pub(super) const TITLE: Text = Text::new("title", "título");
pub(super) const OPTIONS: Text = Text::new("options", "opções");
pub(super) const OWN_MESH: Text = Text::new("of a mesh of your own (--mesh)", "de uma malha sua (--mesh)");
pub(super) const EXPERIMENTS: Text = Text::new("Experiments", "Experimentos");

/// What a picture shows.
pub(super) fn role(role: Role) -> Text {
    match role {
        Role::Bad => Text::new("artefact", "artefato"),
        Role::Cured => Text::new("cured", "curado"),
        Role::Attempt => Text::new("attempted cure", "tentativa de cura"),
        Role::Absent => Text::new("no artefact measured", "nenhum artefato medido"),
        Role::Difference => Text::new("difference", "diferença"),
        Role::Truth => Text::new("truth", "verdade"),
        Role::Seen => Text::new("as it looks", "como se vê"),
    }
}

/// What a number came to, and what it had to.
pub(super) fn moved(moved: &Moved, language: Language) -> String {
    let is_present = moved.is_present();
    let is_left = moved.cured.abs() > moved.present.value;
    let Reported { name, bad, from, why, cure, cured, less, factor } = reported(moved, language);
    let name = capitalised(name);
    match language {
        Language::English if !is_present => format!(
            "{name}: {bad}, which is no artefact: there is one from {from} on ({why}). After what cures it elsewhere ({cure}) it \
             is {cured}."
        ),
        Language::Portuguese if !is_present => format!(
            "{name}: {bad}, o que não é artefato: há um a partir de {from} ({why}). Depois do que o cura em outros casos ({cure}) \
             fica {cured}."
        ),
        Language::English => {
            let from = match is_left {
                true => format!(", though it can still be told: from {from} on ({why}). The"),
                false => format!(". There is an artefact from {from} on ({why}); the"),
            };
            format!(
                "{name}: {bad} with the artefact, {cured} after the cure ({cure}): {less}{from} cure has to bring it below that, \
                 or to make it at least {factor} times smaller."
            )
        }
        Language::Portuguese => {
            let from = match is_left {
                true => format!(", embora ainda se possa notar: a partir de {from} ({why}). A"),
                false => format!(". Há artefato a partir de {from} ({why}); a"),
            };
            format!(
                "{name}: {bad} com o artefato, {cured} depois da cura ({cure}): {less}{from} cura tem de levá-lo abaixo disso, \
                 ou torná-lo ao menos {factor} vezes menor."
            )
        }
    }
}

/// A text as the beginning of a sentence.
fn capitalised(text: &str) -> String {
    let mut signs = text.chars();
    signs.next().map_or(String::new(), |first| first.to_uppercase().chain(signs).collect())
}

/// Why nothing is seen, what would show it, and which pictures show it all the same, being of conditions of their own.
pub(super) fn absent(outcome: &Outcome, shown_by: &str, language: Language) -> String {
    let Reported { name, bad, from, why, .. } = reported(&outcome.moved, language);
    let mut said = match (language, outcome.moved.is_present()) {
        (Language::English, false) => {
            format!("{name} is {bad}, and from {from} on it would be seen ({why}); {shown_by}")
        }
        (Language::Portuguese, false) => {
            format!("{name} é {bad}, e a partir de {from} isso se veria ({why}); {shown_by}")
        }
        (Language::English, true) => {
            format!("with these parameters the pictures do not show it ({name}: {bad}); {shown_by}")
        }
        (Language::Portuguese, true) => {
            format!("com estes parâmetros as imagens não o mostram ({name}: {bad}); {shown_by}")
        }
    };
    let shown = outcome.shots.iter().filter(|shot| shot.role == Role::Bad);
    let shown: Vec<&str> = shown.map(|shot| shot.label.get(language)).collect();
    if !shown.is_empty() {
        let all_the_same = match language {
            Language::English => "These pictures show something of it all the same",
            Language::Portuguese => "Estas imagens mostram algo dele mesmo assim",
        };
        said.push_str(&format!(" {all_the_same}: {}.", shown.join("; ")));
    }
    said
}

/// That the cure did too little.
pub(super) fn uncured(moved: &Moved, language: Language) -> String {
    let Reported { name, bad, cure, cured, less, factor, .. } = reported(moved, language);
    match language {
        Language::English => format!(
            "The cure fails here ({cure}): {name} goes from {bad} to {cured}, {less} where it has to be {factor}."
        ),
        Language::Portuguese => format!(
            "A cura falha aqui ({cure}): {name} vai de {bad} a {cured}, {less} onde devem ser {factor}."
        ),
    }
}

/// What is said of a number that moved, in words.
struct Reported<'a> {
    name: &'a str,
    bad: String,
    from: String,
    why: &'a str,
    cure: &'a str,
    cured: String,
    /// What the cure did to it.
    less: String,
    factor: String,
}

fn reported(moved: &Moved, language: Language) -> Reported<'_> {
    let of = |x| language.short(moved.reported(x), moved.unit);
    Reported {
        name: moved.name.get(language),
        bad: of(moved.bad),
        from: language.short(moved.present.value, moved.unit),
        why: moved.present.why.get(language),
        cure: moved.cure.get(language),
        cured: of(moved.cured),
        less: match (moved.reduction(), language) {
            (f64::INFINITY, Language::English) => "gone".into(),
            (f64::INFINITY, Language::Portuguese) => "sumiu".into(),
            (_, Language::English) if moved.reported(moved.cured) == 0.0 => "gone, but for rounding".into(),
            (_, Language::Portuguese) if moved.reported(moved.cured) == 0.0 => {
                "sumiu, salvo arredondamento".into()
            }
            (times, Language::English) => format!("{} times less", language.short(times, "")),
            (times, Language::Portuguese) => format!("{} vezes menos", language.short(times, "")),
        },
        factor: language.short(moved.factor, ""),
    }
}

/// Where a number has to lie.
pub(super) fn wanted(range: Range, unit: &str, language: Language) -> String {
    match (range, language) {
        (Range::Near { value, tolerance }, _) => {
            format!("{} ± {}", language.quantity(value, unit), language.quantity(tolerance, unit))
        }
        (Range::AtMost { at_most }, Language::English) => {
            format!("at most {}", language.quantity(at_most, unit))
        }
        (Range::AtMost { at_most }, Language::Portuguese) => {
            format!("no máximo {}", language.quantity(at_most, unit))
        }
    }
}

/// That a number is not what it should be.
pub(super) fn miss([name, found, wanted, by]: [&str; 4], language: Language) -> String {
    match language {
        Language::English => format!("{name}: measured {found}, expected {wanted} ({by})"),
        Language::Portuguese => format!("{name}: medido {found}, esperado {wanted} ({by})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::{Measure, Threshold, Verdict};
    use crate::report::{measure_table, misses};

    fn vanished() -> Moved {
        let name = Text::same("x");
        Moved {
            name: name.clone(),
            unit: "",
            bad: 0.25,
            present: Threshold::HALF_STEP_OF_TILT,
            cure: name,
            cured: 0.0,
            factor: 2.0,
        }
    }

    #[test]
    fn what_vanished_is_not_infinitely_less() {
        let vanished = vanished();
        let [en, pt] = Language::ALL.map(|language| moved(&vanished, language));
        assert!(
            en.contains("0 after the cure (x): gone.") && pt.contains("0 depois da cura (x): sumiu."),
            "{en} {pt}"
        );
        assert!(en.starts_with("X: 0.25"), "{en}");
        let halved = moved(&Moved { cured: 0.1, ..vanished.clone() }, Language::Portuguese);
        assert!(halved.contains("2,5 vezes menos. Há artefato a partir de 0,112 ("), "{halved}");
        let rounded = Moved { cured: 1e-6, ..vanished };
        let [en, pt] = Language::ALL.map(|language| moved(&rounded, language));
        assert!(en.contains("0 after the cure (x): gone, but for rounding."), "{en}");
        assert!(pt.contains("0 depois da cura (x): sumiu, salvo arredondamento."), "{pt}");
    }

    #[test]
    fn what_is_left_above_the_threshold_is_said_to_be_seen() {
        let left = Moved { cured: 0.125, ..vanished() };
        let [en, pt] = Language::ALL.map(|language| moved(&left, language));
        assert!(en.contains("2 times less, though it can still be told: from 0.112 on ("), "{en}");
        assert!(pt.contains("2 vezes menos, embora ainda se possa notar: a partir de 0,112 ("), "{pt}");
        assert!(en.contains("). The cure has to") && !en.contains("There is an artefact"), "{en}");
    }

    #[test]
    fn misses_tell_what_was_found_and_what_was_expected() {
        let by = || Text::same("z");
        let measure = |value: f64| Measure::new(Text::same("x"), "px", value);
        let measures = vec![
            measure(1.5).expect(1.0, 0.25, by()),
            measure(1.5).at_most(1.0, by()),
            measure(1.0).expect(1.0, 0.25, by()),
            measure(1.0),
        ];
        let moved = vanished();
        let verdict = Verdict::Holds(by());
        let outcome = Outcome { verdict, moved, measures, shots: vec![], charts: vec![], notes: vec![] };
        assert_eq!(
            misses(&outcome, Language::English),
            [
                "x: measured 1.5 px, expected 1 px ± 0.25 px (z)",
                "x: measured 1.5 px, expected at most 1 px (z)"
            ]
        );
        assert_eq!(
            misses(&outcome, Language::Portuguese),
            [
                "x: medido 1,5 px, esperado 1 px ± 0,25 px (z)",
                "x: medido 1,5 px, esperado no máximo 1 px (z)"
            ]
        );
        let table = measure_table(&outcome, Language::Portuguese).to_text();
        assert!(table.contains("no máximo 1 px") && table.contains("NÃO"), "{table}");
    }

    #[test]
    fn units_are_separate_from_numbers() {
        assert_eq!(Language::Portuguese.quantity(70.5, "°"), "70,5°");
        assert_eq!(Language::English.quantity(3.0, "px"), "3 px");
    }
}
