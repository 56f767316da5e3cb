use super::*;

fn series(name: &str, mark: Mark, points: &[[f64; 2]]) -> Series {
    Series { name: name.into(), points: points.to_vec(), mark, ..Series::default() }
}

fn plot(series: Vec<Series>) -> Plot {
    Plot {
        title: "T < U".into(),
        description: "what is seen".into(),
        x: Axis::log("x"),
        y: Axis::log("y"),
        series,
        ..Plot::default()
    }
}

/// Every number written in an attribute.
fn is_finite(svg: &str) -> bool {
    !["NaN", "inf"].iter().any(|bad| svg.contains(bad))
}

#[test]
fn every_part_that_is_referred_to_is_there() {
    let svg = plot(vec![series("a", Mark::Line, &[[1.0, 2.0], [3.0, 4.0]])]).svg("p");
    for id in ["p.title", "p.desc", "p.field"] {
        assert_eq!(svg.matches(&format!("id=\"{id}\"")).count(), 1, "{id}");
    }
    assert!(svg.contains("aria-labelledby=\"p.title p.desc\"") && svg.contains("url(#p.field)"));
    assert!(svg.contains("T &lt; U") && !svg.contains("http"));
    assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count());
}

/// A sign for each point that has a place, and one in the legend.
#[test]
fn what_has_no_place_is_left_out() {
    let odd = [[0.0, 1.0], [1.0, f64::NAN], [f64::INFINITY, 1.0], [1.0, -1.0], [1.0, 1.0], [2.0, 1.0]];
    let svg = plot(vec![series("a", Mark::Points, &odd)]).svg("p");
    assert!(is_finite(&svg), "{svg}");
    assert_eq!(svg.matches("fill-opacity").count(), 2 + 1);
    for empty in [vec![], vec![series("a", Mark::Steps, &[])], vec![series("", Mark::Line, &[[1.0, 1.0]])]] {
        assert!(is_finite(&plot(empty).svg("p")));
    }
}

#[test]
fn marks_differ() {
    let points = [[1.0, 1.0], [2.0, 4.0], [3.0, 2.0]];
    let paths = |mark| {
        let svg = plot(vec![series("", mark, &points)]).svg("p");
        let start = svg.find("stroke-width=\"1.6\"");
        start.map(|start| {
            let path = svg[..start].rfind("d=\"").unwrap();
            svg[path..start].matches(['L', 'H', 'V']).map(str::to_owned).collect::<String>()
        })
    };
    assert_eq!(paths(Mark::Points), None);
    assert_eq!(paths(Mark::Line).as_deref(), Some("LL"));
    assert_eq!(paths(Mark::Guide).as_deref(), Some("LL"));
    assert_eq!(paths(Mark::Frontier).as_deref(), Some("HVHV"));
    assert_eq!(paths(Mark::Steps).as_deref(), Some("VHVHV"));
}

/// On a telephone, 390 pixels wide, text has 11 pixels: long labels are broken, and names are below the plot.
#[test]
fn text_is_large_and_long_labels_are_broken() {
    let words = "a label of many words ".repeat(5);
    let points = [[1.0, 1.0], [2.0, 300.0]];
    let series = (0..9).map(|k| series(&format!("a series of number {k}"), Mark::Line, &points)).collect();
    let long = Plot { title: words.clone(), x: Axis::log(&words), y: Axis::log(&words), ..plot(series) };
    long.assert_legible();
    let svg = long.svg("p");
    assert!(svg.contains("viewBox=\"0 0 400 ") && 12.0 * 390.0 / super::draw::WIDTH >= 11.0);
    assert!(svg.matches("<text").count() > 9 + 3 * 2, "several lines each");
}

/// Numbers of eight letters once lay under the upright title.
#[test]
fn wide_numbers_get_room() {
    let points = [[1.0, 0.000_02], [2.0, 0.000_03]];
    let wide =
        Plot { y: Axis::linear("what is measured, upright"), ..plot(vec![series("a", Mark::Line, &points)]) };
    wide.assert_legible();
    let comma = Plot { language: crate::text::Language::Portuguese, ..wide.clone() };
    assert!(wide.svg("p").contains(">2.2 × 10⁻⁵<"), "{}", wide.svg("p"));
    assert!(comma.svg("p").contains(">2,2 × 10⁻⁵<"), "{}", comma.svg("p"));
}

#[test]
fn series_differ_without_colour() {
    let points: Vec<[f64; 2]> = (1..100).map(|x| [f64::from(x), f64::from(x)]).collect();
    let marks = [
        Mark::Points,
        Mark::Line,
        Mark::Curve,
        Mark::Curve,
        Mark::Guide,
        Mark::Guide,
        Mark::Guide,
        Mark::Frontier,
    ];
    let all: Vec<Series> = marks.into_iter().map(|mark| series("a", mark, &points)).collect();
    plot(all.clone()).assert_legible();
    // Signs of curves are few, and not at the same places.
    let styles = super::series::series_styles(&all);
    let [first, second] = [2, 3].map(|k| styles[k].signed(Mark::Curve, points.len()));
    assert_eq!((first.len(), second.len()), (4, 4));
    assert!(first.iter().all(|place| !second.contains(place)));
    assert_eq!((styles[0].signed(Mark::Points, 99).len(), styles[4].signed(Mark::Guide, 99).len()), (99, 0));
}

#[test]
#[should_panic(expected = "look alike in grey")]
fn series_of_one_colour_are_alike() {
    let one = Series { colour: Some(0), ..series("a", Mark::Points, &[[1.0, 1.0]]) };
    plot(vec![one.clone(), one]).assert_legible();
}

#[test]
#[should_panic(expected = "leaves the plot")]
fn a_word_that_is_too_long_is_found() {
    let y = Axis::linear(&"unbreakable".repeat(9));
    Plot { y, ..plot(vec![series("a", Mark::Points, &[[1.0, 1.0]])]) }.assert_legible();
}
