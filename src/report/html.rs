//! Pages that open from disk with nothing else: one file, no address, no script.

use super::error::ReportError;
use super::picture::Picture;
use super::png::encode_png;
use crate::num::Transfer;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Text as HTML: what would be markup is escaped, also between quotation marks.
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

/// Running text as HTML, with what stands between two backticks as code and the rest as `prose` writes it.
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

/// Running text as HTML, with what stands between two backticks as code.
pub(super) fn with_code(text: &str) -> String {
    with_code_in(text, |text, out| out.push_str(&escape_html(text)))
}

/// A page under construction: headings, paragraphs, tables and figures, one after the other.
///
/// Everything is inside the one file: style, pictures (as data) and drawings. Each picture has alternative text, headings
/// are linked from a list of contents, and the style knows paper. Text that comes in is escaped; [`Page::raw`] is not.
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
    /// The language's tag, and what the list of contents is called in it.
    language: [String; 2],
    /// How running text becomes HTML.
    setting: fn(&str) -> String,
    body: String,
    /// The text and the id of each heading.
    contents: Vec<(String, String)>,
    ids: BTreeSet<String>,
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
            ids: BTreeSet::new(),
        }
    }

    /// The page in another language than English: its tag (BCP 47), and what the list of contents is called.
    #[must_use]
    pub fn in_language(mut self, tag: &str, contents: &str) -> Self {
        self.language = [tag, contents].map(str::to_owned);
        self
    }

    /// The page with running text (the lead, paragraphs, lists, cells, captions of drawings) made HTML by this, which has to
    /// escape it.
    #[must_use]
    pub(super) fn set_by(mut self, setting: fn(&str) -> String) -> Self {
        self.setting = setting;
        self
    }

    /// A part's heading, listed in the contents.
    pub fn heading(&mut self, text: &str) {
        let id = self.id(text);
        let _ = writeln!(self.body, "<h2 id=\"{id}\">{}</h2>", escape_html(text));
        self.contents.push((text.to_owned(), id));
    }

    /// A heading within a part.
    pub fn subheading(&mut self, text: &str) {
        let id = self.id(text);
        let _ = writeln!(self.body, "<h3 id=\"{id}\">{}</h3>", escape_html(text));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        let _ = writeln!(self.body, "<p>{}</p>", (self.setting)(text));
    }

    /// A list of points.
    pub fn list<'a>(&mut self, points: impl IntoIterator<Item = &'a str>) {
        self.body.push_str("<ul>\n");
        for point in points {
            let _ = writeln!(self.body, "<li>{}</li>", (self.setting)(point));
        }
        self.body.push_str("</ul>\n");
    }

    /// A table.
    pub fn table(&mut self, table: &Table) {
        let _ = writeln!(
            self.body,
            "<div class=\"wide\"><table><caption>{}</caption>",
            escape_html(&table.caption)
        );
        self.body.push_str("<thead><tr>");
        let class = |column: usize| if table.has_words(column) { " class=\"words\"" } else { "" };
        for (column, name) in table.columns.iter().enumerate() {
            let _ = write!(self.body, "<th scope=\"col\"{}>{}</th>", class(column), escape_html(name));
        }
        self.body.push_str("</tr></thead>\n<tbody>\n");
        for row in &table.rows {
            self.body.push_str("<tr>");
            for (column, cell) in row.iter().enumerate() {
                let (tag, scope) = if column == 0 { ("th", " scope=\"row\"") } else { ("td", "") };
                let _ = write!(self.body, "<{tag}{scope}{}>{}</{tag}>", class(column), (self.setting)(cell));
            }
            self.body.push_str("</tr>\n");
        }
        self.body.push_str("</tbody></table></div>\n");
    }

    /// Pictures side by side under one caption, as many in a row as fit; each with what it shows for those who cannot see
    /// it. Nothing for no pictures.
    ///
    /// # Errors
    /// Sizes that do not fit a picture's pixels.
    pub fn pictures(&mut self, pictures: &[(&Picture, &str)], caption: &str) -> Result<(), ReportError> {
        let images = pictures.iter().map(|(picture, alternative)| image(picture, alternative));
        let images: Vec<String> = images.collect::<Result<_, _>>()?;
        if !images.is_empty() {
            let (images, caption) = (images.join("\n"), escape_html(caption));
            let _ = writeln!(
                self.body,
                "<figure>\n<div class=\"row\">\n{images}\n</div>\n<figcaption>{caption}</figcaption>\n</figure>"
            );
        }
        Ok(())
    }

    /// A drawing under a caption; it is given an id for its parts to refer to. See [`Plot::svg`](super::Plot::svg).
    pub fn drawing(&mut self, name: &str, caption: &str, draw: impl FnOnce(&str) -> String) {
        let id = self.id(name);
        let (drawing, caption) = (draw(&id), (self.setting)(caption));
        let _ = writeln!(self.body, "<figure>\n{drawing}\n<figcaption>{caption}</figcaption>\n</figure>");
    }

    /// HTML as it is.
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
        // Ids of drawings have parts of their own after a dot, which no id made here contains.
        let id = numbered.into_iter().find(|id| !self.ids.contains(id)).expect("there are numbers enough");
        self.ids.insert(id.clone());
        id
    }

    /// The whole page.
    pub fn finish(self) -> String {
        let (title, lead) = (escape_html(&self.title), (self.setting)(&self.lead));
        let entries = self.contents.iter();
        let entries =
            entries.map(|(text, id)| format!("<li><a href=\"#{id}\">{}</a></li>\n", escape_html(text)));
        let contents: String = entries.collect();
        let [tag, named] = self.language.each_ref().map(|text| escape_html(text));
        let contents = match contents.as_str() {
            "" => String::new(),
            entries => format!("<nav aria-label=\"{named}\"><ol>\n{entries}</ol></nav>\n"),
        };
        format!(
            "<!DOCTYPE html>\n<html lang=\"{tag}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
             <style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n<p class=\"lead\">{lead}</p>\n\
             {contents}{body}</main>\n</body>\n</html>\n",
            body = self.body,
        )
    }
}

const STYLE: &str = include_str!("page.css");

/// A picture as an element that holds its own bytes.
pub(super) fn image(picture: &Picture, alternative: &str) -> Result<String, ReportError> {
    let file = STANDARD.encode(encode_png(picture, Transfer::Srgb)?);
    let ([width, height], alternative) = (picture.size, escape_html(alternative));
    Ok(format!(
        "<img src=\"data:image/png;base64,{file}\" width=\"{width}\" height=\"{height}\" alt=\"{alternative}\">"
    ))
}

/// Rows under columns, the first of which names the row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    caption: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(caption: &str, columns: &[&str]) -> Self {
        Self {
            caption: caption.to_owned(),
            columns: columns.iter().map(|&column| column.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// With another row.
    #[must_use]
    pub fn row<T: Into<String>>(mut self, cells: impl IntoIterator<Item = T>) -> Self {
        self.push(cells);
        self
    }

    /// Adds a row. Cells that are not there are empty.
    pub fn push<T: Into<String>>(&mut self, cells: impl IntoIterator<Item = T>) {
        let mut row: Vec<String> = cells.into_iter().map(Into::into).collect();
        row.resize(self.columns.len(), String::new());
        self.rows.push(row);
    }

    /// Leaves out the columns in which no row has anything.
    pub fn drop_empty_columns(&mut self) {
        let keep: Vec<bool> = (0..self.columns.len())
            .map(|column| self.rows.iter().any(|row| !row[column].is_empty()))
            .collect();
        for row in self.rows.iter_mut().chain([&mut self.columns]) {
            let mut kept = keep.iter();
            row.retain(|_| kept.next() == Some(&true));
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether a column holds words: fewer than half of what stands in it are numbers, a digit first and one word at most,
    /// such as a unit.
    fn has_words(&self, column: usize) -> bool {
        let filled = || self.rows.iter().map(|row| &row[column]).filter(|cell| !cell.is_empty());
        let is_word = |text: &&str| text.chars().filter(|c| c.is_alphabetic()).count() > 1;
        let words = |cell: &str| cell.split(' ').filter(is_word).count();
        let is_number = |cell: &&String| {
            let starts = |c: char| c.is_ascii_digit() || c == '∞';
            cell.trim_start_matches(['-', '−', '+']).starts_with(starts) && words(cell) < 2
        };
        2 * filled().filter(is_number).count() < filled().count()
    }

    /// As text for a terminal: columns of equal width, numbers to the right, words to the left.
    pub fn to_text(&self) -> String {
        let lines = || std::iter::once(&self.columns).chain(&self.rows);
        let width = |column: usize| lines().map(|line| line[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let words: Vec<bool> = (0..self.columns.len()).map(|column| self.has_words(column)).collect();
        let mut text = format!("{}\n", self.caption);
        for line in lines() {
            let cells = line.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
                let fill = " ".repeat(width - cell.chars().count());
                if column == 0 || words[column] { format!("{cell}{fill}") } else { format!("{fill}{cell}") }
            });
            let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
        }
        text
    }

    /// As a table of Markdown, without the caption.
    pub fn to_markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells = cells.iter().map(|cell| cell.replace('|', "\\|"));
            format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
        };
        let mut text = line(&self.columns);
        let _ = writeln!(text, "|---|{}", "---:|".repeat(self.columns.len().saturating_sub(1)));
        self.rows.iter().for_each(|row| text.push_str(&line(row)));
        text
    }
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
    fn tables_are_the_same_in_every_form() {
        let table =
            Table::new("Errors", &["weight", "rms"]).row(["max", "0.5"]).row(["a|b", "11.25"]).row(["–"]);
        assert_eq!(table.to_text(), "Errors\n  weight    rms\n  max       0.5\n  a|b     11.25\n  –\n");
        let markdown = "| weight | rms |\n|---|---:|\n| max | 0.5 |\n| a\\|b | 11.25 |\n| – |  |\n";
        assert_eq!(table.to_markdown(), markdown);
        assert!(!table.is_empty());
    }

    #[test]
    fn columns_in_which_nothing_stands_go() {
        let mut table =
            Table::new("t", &["face", "corner", "degrees"]).row(["1", "", ""]).row(["2", "", "30"]);
        table.drop_empty_columns();
        assert_eq!(table, Table::new("t", &["face", "degrees"]).row(["1", ""]).row(["2", "30"]));
    }

    /// What begins with a digit may be words all the same.
    #[test]
    fn columns_of_words_are_distinguished_from_numbers() {
        let table = Table::new("t", &["quantity", "found", "others"])
            .row(["1/d²: share of the floor", "0.5 px", "8.7 to 9.7"])
            .row(["8 bits: largest change", "-3", "0.5 (12 %)"]);
        assert_eq!([0, 1, 2].map(|column| table.has_words(column)), [true, false, false]);
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
