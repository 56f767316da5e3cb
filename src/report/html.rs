//! Pages of HTML that open from disk: one file without addresses and scripts.

use super::error::Result;
use super::picture::{Picture, encode_png};
use super::table::Table;
use crate::num::Transfer;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Text as HTML: markup is escaped, also in attributes.
///
/// ```
/// assert_eq!(crease::report::escape_html("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
/// ```
pub fn escape_html(text: &str) -> Cow<'_, str> {
    if !text.contains(['&', '<', '>', '"', '\'']) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            _ => out.push(c),
        }
    }
    Cow::Owned(out)
}

/// Running text as HTML: the text between two backticks as code, the rest by `prose`.
pub(super) fn with_code_in(text: &str, prose: impl Fn(&str, &mut String)) -> String {
    let mut out = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some((before, (code, after))) =
        rest.split_once('`').and_then(|(before, after)| Some((before, after.split_once('`')?)))
    {
        prose(before, &mut out);
        let _ = write!(out, "<code>{}</code>", escape_html(code));
        rest = after;
    }
    prose(rest, &mut out);
    out
}

/// Running text as HTML, with the text between two backticks as code.
pub(super) fn with_code(text: &str) -> String {
    with_code_in(text, |text, out| out.push_str(&escape_html(text)))
}

/// A page under construction: headings, paragraphs, tables and figures, one after the other.
///
/// Style, pictures (as data) and drawings are all inside the one file. Each picture has alternative text, headings are linked
/// from a list of contents, and the style includes rules for print. Text is escaped, except that of [`Page::raw`].
///
/// ```
/// use crease::report::{Page, Table};
///
/// let mut page = Page::new("Weights", "Which normals?");
/// page.heading("Errors");
/// page.paragraph("In degrees.");
/// page.table(&Table::new("Root mean square", &["weight", "rms"]).row(["max", "0.498"]));
/// assert!(page.finish().starts_with("<!DOCTYPE html>"));
/// ```
#[derive(Debug)]
pub struct Page {
    title: String,
    lead: String,
    /// The language's tag, and the name of the list of contents in it.
    language: [String; 2],
    /// Turns running text into HTML.
    setting: fn(&str) -> String,
    body: String,
    /// The text and the id of each heading.
    contents: Vec<(String, String)>,
    ids: BTreeSet<String>,
    drawings: Vec<Drawing>,
}

/// A drawing of a page, also as a file of its own.
#[derive(Debug)]
pub struct Drawing {
    /// The name of the file, without suffix.
    pub name: String,
    /// The file: SVG.
    pub svg: String,
}

impl Page {
    /// An empty page with a title and a sentence under it.
    pub fn new(title: &str, lead: &str) -> Self {
        Self {
            title: title.to_owned(),
            lead: lead.to_owned(),
            language: ["en", "Contents"].map(str::to_owned),
            setting: |text| escape_html(text).into_owned(),
            body: String::new(),
            contents: Vec::new(),
            drawings: Vec::new(),
            ids: BTreeSet::new(),
        }
    }

    /// The page in another language than English: its tag (BCP 47), and the name of the list of contents.
    #[must_use]
    pub fn in_language(mut self, tag: &str, contents: &str) -> Self {
        self.language = [tag, contents].map(str::to_owned);
        self
    }

    /// The page with a function that turns running text (the lead, paragraphs, lists, cells, captions of drawings) into HTML
    /// and escapes it.
    #[must_use]
    pub(super) fn set_by(mut self, setting: fn(&str) -> String) -> Self {
        self.setting = setting;
        self
    }

    /// Running text as HTML.
    fn set(&self, text: &str) -> Markup {
        PreEscaped((self.setting)(text))
    }

    /// Adds an element and a line break.
    pub(super) fn push(&mut self, element: Markup) {
        self.body.push_str(&element.0);
        self.body.push('\n');
    }

    /// A heading of a section, listed in the contents. Returns its id.
    pub fn heading(&mut self, text: &str) -> String {
        let id = self.id(text);
        self.push(html! { h2 id=(id) { (text) } });
        self.contents.push((text.to_owned(), id.clone()));
        id
    }

    /// A heading within a section.
    pub fn subheading(&mut self, text: &str) {
        let id = self.id(text);
        self.push(html! { h3 id=(id) { (text) } });
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.push(html! { p { (self.set(text)) } });
    }

    /// A list of points.
    pub fn list<'a>(&mut self, points: impl IntoIterator<Item = &'a str>) {
        self.push(html! { ul { @for point in points { li { (self.set(point)) } } } });
    }

    /// A table.
    pub fn table(&mut self, table: &Table) {
        let classes: Vec<Option<&str>> =
            (0..table.columns.len()).map(|column| table.has_words(column).then_some("words")).collect();
        self.push(html! {
            // A region that scrolls needs a name, and the focus for keys.
            div.wide role="region" tabindex="0" aria-label=(table.caption) { table {
                caption { (table.caption) }
                thead { tr {
                    @for (name, class) in table.columns.iter().zip(&classes) {
                        th scope="col" class=[class] { (name) }
                    }
                } }
                tbody { @for row in &table.rows { tr {
                    @for (column, (cell, class)) in row.iter().zip(&classes).enumerate() {
                        @if column == 0 { th scope="row" class=[class] { (self.set(cell)) } }
                        @else { td class=[class] { (self.set(cell)) } }
                    }
                } } }
            } }
        });
    }

    /// Pictures side by side under one caption, as many in a row as fit, each with its alternative text. Nothing for no
    /// pictures.
    ///
    /// # Errors
    /// Sizes that do not fit a picture's pixels.
    pub fn pictures(&mut self, pictures: &[(&Picture, &str)], caption: &str) -> Result<()> {
        let images = pictures.iter().map(|(picture, alternative)| image(picture, alternative));
        let images: Vec<String> = images.collect::<Result<_>>()?;
        if !images.is_empty() {
            let images = PreEscaped(images.concat());
            self.push(html! { figure { div.row { (images) } figcaption { (caption) } } });
        }
        Ok(())
    }

    /// A drawing under a caption; `draw` is given an id for its parts to refer to. See [`Plot::svg`](super::Plot::svg).
    pub fn drawing(&mut self, name: &str, caption: &str, draw: impl FnOnce(&str) -> String) {
        let name = self.id(name);
        let drawing = draw(&name);
        self.push(html! { figure { (PreEscaped(&drawing)) figcaption { (self.set(caption)) } } });
        self.drawings.push(Drawing { name, svg: svg_file(&drawing) });
    }

    /// HTML that is not escaped.
    pub fn raw(&mut self, html: &str) {
        self.body.push_str(html);
    }

    /// An id made from a text, unlike all others of the page.
    pub fn id(&mut self, text: &str) -> String {
        let letters =
            text.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' });
        let words: String = letters.collect();
        let words: Vec<&str> = words.split('-').filter(|word| !word.is_empty()).collect();
        let base = if words.is_empty() { "part".to_owned() } else { words.join("-") };
        let numbered = (1..).map(|n: u32| if n == 1 { base.clone() } else { format!("{base}-{n}") });
        // Ids within drawings have a dot, which no id made here contains.
        let id = numbered.into_iter().find(|id| !self.ids.contains(id)).expect("there are numbers enough");
        self.ids.insert(id.clone());
        id
    }

    /// The drawings so far.
    pub fn take_drawings(&mut self) -> Vec<Drawing> {
        std::mem::take(&mut self.drawings)
    }

    /// The whole page.
    pub fn finish(self) -> String {
        let [tag, contents] = &self.language;
        let page = html! {
            (DOCTYPE)
            html lang=(tag) {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (self.title) }
                    style { (PreEscaped(STYLE)) }
                }
                body { main {
                    h1 { (self.title) }
                    p.lead { (self.set(&self.lead)) }
                    @if !self.contents.is_empty() {
                        nav aria-label=(contents) { ol {
                            @for (text, id) in &self.contents { li { a href={ "#" (id) } { (text) } } }
                        } }
                    }
                    (PreEscaped(&self.body))
                } }
            }
        };
        page.into_string()
    }
}

/// A drawing of a page as a file of its own: with the name of its format and its font.
pub fn svg_file(drawing: &str) -> String {
    const HEAD: &str =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"system-ui, sans-serif\" font-size=\"12\" ";
    drawing.replacen("<svg ", HEAD, 1)
}

const STYLE: &str = include_str!("page.css");

pub(super) fn image(picture: &Picture, alternative: &str) -> Result<String> {
    let source =
        format!("data:image/png;base64,{}", STANDARD.encode(encode_png(picture, None, Transfer::Srgb)?));
    let [width, height] = picture.size;
    Ok(html! { img src=(source) width=(width) height=(height) alt=(alternative); }.into_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_become_markup() {
        let mut page = Page::new("a<b>", "\"&'");
        page.heading("<script>");
        page.paragraph("x < y");
        page.table(&Table::new("<i>", &["<u>"]).row(["<s>"]));
        let picture = Picture::filled([1, 1], false, [0.0; 3]);
        page.pictures(&[(&picture, "a \"quoted\" <alternative>")], "<b>").unwrap();
        let page = page.finish();
        for forbidden in ["<script>", "a<b>", "x < y", "<i>", "<u>", "<s>", "<alternative>", "\"quoted\""] {
            assert!(!page.contains(forbidden), "{forbidden} in {page}");
        }
    }

    #[test]
    fn ids_are_all_different() {
        let mut page = Page::new("", "");
        let ids = ["A b", "a-b", "a b", "", "·"].map(|text| page.id(text));
        assert_eq!(ids, ["a-b", "a-b-2", "a-b-3", "part", "part-2"]);
    }

    #[test]
    fn contents_lead_to_headings() {
        let mut page = Page::new("t", "");
        page.heading("Same");
        page.heading("Same");
        let page = page.finish();
        for id in ["same", "same-2"] {
            assert!(page.contains(&format!("href=\"#{id}\"")) && page.contains(&format!("id=\"{id}\"")));
        }
    }
}
