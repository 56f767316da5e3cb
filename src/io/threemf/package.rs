//! The parts of a package (ECMA-376 part 2, Open Packaging Conventions), which is a ZIP archive.

use crate::io::text::shown;
use crate::io::{Limits, Place, Problem, ReadError};
use memchr::memmem;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;
use std::io::{BufReader, Cursor, Read, Take};
use zip::ZipArchive;

/// The largest sum of unpacked model parts, in bytes and in multiples of the size of the file. Real models pack to a fifth, and
/// regular ones to a thirtieth.
const UNPACKED: u64 = 256 << 20;
const RATIO: u64 = 100;

const DAMAGED: &str = "the file is damaged; export it again";

/// Whether these are the bytes of an archive with a model part.
pub fn is_certain(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") && memmem::find(bytes, b"3D/3dmodel.model").is_some()
}

pub fn error(problem: Problem, found: impl Into<String>, advice: &str) -> ReadError {
    ReadError::new(problem, Place::File, found, advice)
}

/// An archive, and how many bytes may still be unpacked.
pub struct Package<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    left: u64,
}

impl<'a> Package<'a> {
    pub fn new(bytes: &'a [u8], limits: &Limits) -> Result<Self, ReadError> {
        let archive = ZipArchive::new(Cursor::new(bytes));
        let archive =
            archive.map_err(|why| error(Problem::Syntax, format!("not a ZIP archive: {why}"), DAMAGED))?;
        let left = UNPACKED.max(RATIO.saturating_mul(bytes.len() as u64)).min(limits.bytes);
        Ok(Self { archive, left })
    }

    /// The name of the part that the relationships of the package name as its model.
    pub fn root(&mut self) -> Result<String, ReadError> {
        const MODEL: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
        let mut root = None;
        self.elements("_rels/.rels", |element| {
            if let Element::Start(start) = element
                && start.local_name().as_ref() == "Relationship"
                && attribute(start, "Type").as_deref() == Some(MODEL)
            {
                root = attribute(start, "Target").map(Cow::into_owned);
            }
            Ok(())
        })?;
        root.ok_or_else(|| error(Problem::Companion, "the package names no 3D model", DAMAGED))
    }

    /// Calls `each` for the start and the end of all elements of a part.
    ///
    /// # Errors
    /// If the part is missing, damaged, too large or not XML, or the error of `each`.
    pub fn elements(
        &mut self,
        name: &str,
        mut each: impl FnMut(Element<'_, '_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let short = name.trim_start_matches('/');
        let quoted = shown(short.as_bytes());
        let found = self.archive.index_for_name(short).ok_or("it is not there".to_owned());
        let file = found.and_then(|index| self.archive.by_index(index).map_err(|why| why.to_string()));
        let file = file.map_err(|why| {
            error(Problem::Companion, format!("the part `{quoted}` cannot be read: {why}"), DAMAGED)
        })?;
        let mut reader = Reader::from_reader(BufReader::new(file.take(self.left)));
        reader.config_mut().expand_empty_elements = true;
        let mut bytes = Vec::new();
        let mut depth = 0_usize;
        loop {
            bytes.clear();
            let event = reader.read_event_into(&mut bytes);
            let result = match event {
                Ok(Event::Start(start)) => {
                    depth += 1;
                    each(Element::Start(&start))
                }
                Ok(Event::End(end)) => {
                    depth = depth.saturating_sub(1);
                    each(Element::End(end.local_name().as_ref()))
                }
                Ok(Event::Eof) if depth == 0 => break,
                _ if is_spent(&reader) => break,
                Ok(Event::Eof) => Err(error(Problem::Truncated, "an element has no end", DAMAGED)),
                Ok(Event::DocType(_)) => {
                    Err(error(Problem::Unsupported, "3MF has no document types", "remove the DOCTYPE"))
                }
                Ok(_) => Ok(()),
                Err(why) => Err(error(Problem::Syntax, why.to_string(), DAMAGED)),
            };
            result.map_err(|why| {
                let found = format!("in `{quoted}`, byte {}: {}", reader.buffer_position(), why.found);
                ReadError { found, ..why }
            })?;
        }
        if is_spent(&reader) {
            let found = format!("the parts of the package have more than {} bytes unpacked", self.left);
            return Err(error(Problem::Limit, found, "divide the model"));
        }
        self.left = reader.get_ref().get_ref().limit();
        Ok(())
    }
}

fn is_spent<R>(reader: &Reader<BufReader<Take<R>>>) -> bool {
    reader.get_ref().get_ref().limit() == 0
}

/// The start of an element, or the name of one that ends.
pub enum Element<'a, 'b> {
    Start(&'a BytesStart<'b>),
    End(&'a str),
}

/// The value of an attribute, whatever its prefix.
pub fn attribute<'a>(start: &'a BytesStart<'_>, name: &str) -> Option<Cow<'a, str>> {
    let mut all = start.attributes();
    // It compares all pairs.
    let mut all = all.with_checks(false).flatten();
    let found = all.find(|it| it.key.local_name().as_ref() == name)?;
    let normal = found.normalized_value(XmlVersion::Explicit1_0);
    Some(normal.unwrap_or(found.value))
}
