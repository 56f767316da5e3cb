//! The GLB container: a header and chunks, all of which are kept.

use crate::io::text::counted;
use crate::io::{Note, Place, Problem, ReadError, WriteError};
use std::ops::Range;

pub const TRUNCATED: &str = "the file is cut off; copy or export it again";

const MAGIC: &[u8; 4] = b"glTF";
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// Bytes of the headers of the file and of its first chunk.
const SHORTEST: usize = 20;

/// The chunks of a GLB file, in order, as spans of the file.
#[derive(Clone, Debug, Default)]
pub struct Glb {
    chunks: Vec<(u32, Range<usize>)>,
}

pub fn is_glb(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

impl Glb {
    pub fn parse(bytes: &[u8], notes: &mut Vec<Note>) -> Result<Glb, ReadError> {
        let error = |problem, at: usize, found: String, advice: &str| {
            Err(ReadError::new(problem, Place::Byte(at as u64), found, advice))
        };
        let truncated = |at, found| error(Problem::Truncated, at, found, TRUNCATED);
        let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let size = bytes.len();
        let (Some(version), Some(length)) = (word(4), word(8)) else {
            return truncated(size, format!("a GLB header has 12 bytes, but the file has only {size}"));
        };
        if version != 2 {
            let advice = "convert the file to glTF 2.0, for example with glTF-Transform";
            return error(Problem::Unsupported, 4, format!("unsupported GLB version {version}"), advice);
        }
        let length = length as usize;
        if length > size {
            return truncated(8, format!("the header states {length} bytes, but the file has only {size}"));
        }
        if length < SHORTEST {
            let found = format!("the header states {length} bytes, but the headers alone have {SHORTEST}");
            return truncated(8, found);
        }
        if length < size {
            let rest = counted(size - length, "byte", "bytes");
            let text = format!("ignored after the end of the GLB: {rest}");
            notes.push(Note::warning(Place::Byte(length as u64), text));
        }
        let mut chunks = Vec::new();
        let mut at = 12;
        while at < length {
            let (Some(size), Some(kind), true) = (word(at), word(at + 4), at + 8 <= length) else {
                return truncated(at, "the chunk header is cut off".into());
            };
            let (start, size) = (at + 8, size as usize);
            let rest = length - start;
            if size > rest {
                let found = format!("chunk length is {size} bytes, but only {rest} bytes remain");
                let advice = "a length is wrong; copy or export the file again";
                return error(Problem::Truncated, at, found, advice);
            }
            chunks.push((kind, start..start + size));
            at = start + size;
        }
        if chunks.first().is_none_or(|(kind, _)| *kind != JSON) {
            let found = "the first chunk is not JSON".into();
            return error(Problem::Syntax, 12, found, "the file is damaged; export it again");
        }
        Ok(Glb { chunks })
    }

    pub fn json(&self) -> Range<usize> {
        self.chunks[0].1.clone()
    }

    pub fn bin(&self) -> Option<Range<usize>> {
        self.bin_chunk().map(|chunk| self.chunks[chunk].1.clone())
    }

    fn bin_chunk(&self) -> Option<usize> {
        self.chunks.iter().position(|(kind, _)| *kind == BIN)
    }

    /// The number of chunks other than JSON and the first BIN.
    pub fn other_chunks(&self) -> usize {
        self.chunks.len() - 1 - usize::from(self.bin_chunk().is_some())
    }

    /// A file with the same chunks in the same order, but other JSON and, if given, another BIN.
    pub fn rewrite(
        &self,
        bytes: &[u8],
        json: &str,
        bin: Option<[&[u8]; 3]>,
    ) -> Result<(Vec<u8>, usize), WriteError> {
        let chunk = |(kind, span): &(u32, Range<usize>)| (*kind, vec![&bytes[span.clone()]]);
        let mut chunks: Vec<(u32, Vec<&[u8]>)> = self.chunks.iter().map(chunk).collect();
        chunks[0].1 = vec![json.as_bytes()];
        match (self.bin_chunk(), bin) {
            (_, None) => {}
            (Some(number), Some(bin)) => chunks[number].1 = bin.to_vec(),
            (None, Some(bin)) => chunks.insert(1, (BIN, bin.to_vec())),
        }
        let length = |pieces: &[&[u8]]| 8 + padded(pieces.iter().map(|piece| piece.len()).sum());
        let before = chunks.iter().take_while(|(kind, _)| *kind != BIN);
        let start = 12 + before.map(|(_, pieces)| length(pieces)).sum::<usize>() + 8;
        Ok((assemble(&chunks, 0)?, start))
    }
}

pub fn glb(json: &str, bin: Vec<&[u8]>) -> Result<Vec<u8>, WriteError> {
    let mut out = before_bin(json, bin.iter().map(|piece| piece.len()).sum())?;
    bin.iter().for_each(|piece| out.extend_from_slice(piece));
    out.resize(padded(out.len()), 0);
    Ok(out)
}

/// A new GLB file up to its BIN, which the caller appends: so many bytes, then zeros up to a multiple of four.
pub fn before_bin(json: &str, length: usize) -> Result<Vec<u8>, WriteError> {
    let chunk = if length > 0 { 8 + padded(length) } else { 0 };
    let mut out = assemble(&[(JSON, vec![json.as_bytes()])], chunk)?;
    if length > 0 {
        out.extend_from_slice(&(padded(length) as u32).to_le_bytes());
        out.extend_from_slice(&BIN.to_le_bytes());
    }
    Ok(out)
}

/// A file of these chunks, with room for so many bytes more.
fn assemble(chunks: &[(u32, Vec<&[u8]>)], room: usize) -> Result<Vec<u8>, WriteError> {
    let size = |pieces: &[&[u8]]| pieces.iter().map(|piece| piece.len()).sum::<usize>();
    let length = 12 + room + chunks.iter().map(|(_, pieces)| 8 + padded(size(pieces))).sum::<usize>();
    let Ok(counted) = u32::try_from(length) else {
        let text = format!("the GLB would have {length} bytes (limit 4 GiB); write .gltf instead");
        return Err(WriteError::TooLarge(text));
    };
    let mut out = Vec::with_capacity(length);
    out.extend_from_slice(MAGIC);
    out.extend_from_slice(&2_u32.to_le_bytes());
    out.extend_from_slice(&counted.to_le_bytes());
    for (kind, pieces) in chunks {
        let padded = padded(size(pieces));
        out.extend_from_slice(&(padded as u32).to_le_bytes());
        out.extend_from_slice(&kind.to_le_bytes());
        let end = out.len() + padded;
        pieces.iter().for_each(|piece| out.extend_from_slice(piece));
        out.resize(end, if *kind == JSON { b' ' } else { 0 });
    }
    Ok(out)
}

/// A chunk of JSON without the blanks that filled it up.
pub fn unpadded(json: &str) -> &str {
    json.trim_end_matches(' ')
}

/// The next multiple of four: where a chunk or a buffer view may begin.
pub fn padded(length: usize) -> usize {
    length.next_multiple_of(4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_chunks_stay_where_they_are() {
        let chunk = |kind, data: &'static [u8]| (kind, vec![data]);
        let chunks = [chunk(JSON, b"{}  "), chunk(7, b"abcd"), chunk(BIN, b"1234"), chunk(9, b"xy\0\0")];
        let file = assemble(&chunks, 0).unwrap();
        let glb = Glb::parse(&file, &mut Vec::new()).unwrap();
        assert_eq!(&file[glb.json()], b"{}  ");
        assert_eq!(&file[glb.bin().unwrap()], b"1234");
        assert_eq!(glb.other_chunks(), 2);
        assert_eq!(glb.rewrite(&file, "{}  ", None).unwrap().0, file);
        let (longer, bin) = glb.rewrite(&file, "{\"a\":1}", Some([b"123", b"45", b""])).unwrap();
        assert_eq!(&longer[bin..bin + 5], b"12345");
        let again = Glb::parse(&longer, &mut Vec::new()).unwrap();
        assert_eq!(&longer[again.json()], b"{\"a\":1} ");
        assert_eq!(&longer[again.bin().unwrap()], b"12345\0\0\0");
        assert_eq!(again.chunks.iter().map(|(kind, _)| *kind).collect::<Vec<_>>(), [JSON, 7, BIN, 9]);
    }

    #[test]
    fn what_is_wrong_with_lengths_is_distinguished() {
        let error = |file: &[u8]| Glb::parse(file, &mut Vec::new()).unwrap_err().to_string();
        let header = |length: u32| [&b"glTF\x02\0\0\0"[..], &length.to_le_bytes()].concat();
        assert!(error(b"glTF\x02\0").contains("the file has only 6"));
        assert!(error(&header(12)).contains("the header states 12 bytes, but the headers alone have 20"));
        assert!(error(&header(13)).contains("the header states 13 bytes, but the file has only 12"));
        let mut file = glb("{}", vec![&b"1234"[..]]).unwrap();
        file[12] = 200;
        let error = error(&file);
        assert!(error.contains("chunk length is 200 bytes, but only 16 bytes remain"), "{error}");
        assert!(!error.contains("cut off"), "the file has the length that it states: {error}");
    }

    #[test]
    fn every_prefix_is_an_error() {
        let file = glb("{}", vec![&b"12"[..], b"34"]).unwrap();
        for end in 0..file.len() {
            assert!(Glb::parse(&file[..end], &mut Vec::new()).is_err(), "{end}");
        }
        assert!(Glb::parse(&file, &mut Vec::new()).is_ok());
    }
}
