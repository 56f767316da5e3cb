//! Buffer and image addresses: data URIs and files below a folder, nothing else.

use crate::io::{Place, Problem, ReadError};
use base64::Engine;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};

/// What an address is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Uri {
    /// Data in the address itself.
    Data,
    /// A file, relative to the document.
    File(String),
    /// An address with a scheme: a network, an absolute file.
    Elsewhere,
}

impl Uri {
    pub fn parse(uri: &str) -> Uri {
        if uri.get(..5).is_some_and(|head| head.eq_ignore_ascii_case("data:")) {
            return Uri::Data;
        }
        let head = uri.split(['/', '?', '#', '\\']).next().unwrap_or_default();
        if head.contains(':') || uri.starts_with("//") {
            Uri::Elsewhere
        } else {
            Uri::File(String::from_utf8(percent_decoded(uri)).unwrap_or_else(|_| uri.to_owned()))
        }
    }
}

/// The bytes of a data URI.
pub fn decode_data(uri: &str, place: Place) -> Result<Vec<u8>, ReadError> {
    let broken = |found: String| {
        ReadError::new(Problem::Syntax, place.clone(), found, "the data URI is broken; export the file again")
    };
    let Some((head, data)) = uri.split_once(',') else {
        return Err(broken("a data URI without a comma".into()));
    };
    if !head.to_ascii_lowercase().ends_with(";base64") {
        return Ok(percent_decoded(data));
    }
    let config = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let engine = GeneralPurpose::new(&base64::alphabet::STANDARD, config);
    engine.decode(data).map_err(|error| broken(format!("a data URI that is not base64 ({error})")))
}

/// A data URI of raw bytes.
pub fn encode_data(bytes: &[u8]) -> String {
    let mut uri = String::from("data:application/octet-stream;base64,");
    base64::engine::general_purpose::STANDARD.encode_string(bytes, &mut uri);
    uri
}

fn percent_decoded(text: &str) -> Vec<u8> {
    let hex = |byte: u8| (byte as char).to_digit(16).map(|digit| digit as u8);
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        rest = tail;
        if let (b'%', [high, low, after @ ..]) = (*first, tail)
            && let (Some(high), Some(low)) = (hex(*high), hex(*low))
        {
            out.push(high << 4 | low);
            rest = after;
        } else {
            out.push(*first);
        }
    }
    out
}

/// The address of data: of a file of this name, or a data URI.
pub fn address(name: Option<&str>, data: &[u8]) -> String {
    name.map_or_else(|| encode_data(data), percent_encoded)
}

/// A file name as a relative address.
pub fn percent_encoded(name: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let encoded =
        |byte: u8| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    name.bytes().map(encoded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_distinguished() {
        assert_eq!(Uri::parse("data:;base64,AA"), Uri::Data);
        assert_eq!(Uri::parse("a%20b/c.bin"), Uri::File("a b/c.bin".into()));
        assert_eq!(Uri::parse("%FF.bin"), Uri::File("%FF.bin".into()), "not UTF-8: left as it is");
        for elsewhere in ["http://x/y", "HTTPS://x", "file:///etc/passwd", "C:\\x.bin", "//host/x"] {
            assert_eq!(Uri::parse(elsewhere), Uri::Elsewhere, "{elsewhere}");
        }
    }

    #[test]
    fn data_round_trips() {
        let bytes: Vec<u8> = (0..=255).collect();
        assert_eq!(decode_data(&encode_data(&bytes), Place::File).unwrap(), bytes);
        assert_eq!(decode_data("data:,a%41%", Place::File).unwrap(), b"aA%");
        assert_eq!(decode_data("data:x;base64,AAE", Place::File).unwrap(), [0, 1]);
        assert!(decode_data("data:x;base64,A*", Place::File).is_err());
        assert!(decode_data("data:x;base64", Place::File).is_err());
        assert_eq!(Uri::parse(&percent_encoded("ü 1.bin")), Uri::File("ü 1.bin".into()));
    }
}
