//! Numbers, vectors and colours as they are typed.

use crease::num::{Degrees, LinearRgb, Srgb8};
use crease::raster::Show;
use glam::DVec3;

/// The largest side of a picture.
const LARGEST_SIDE: u32 = 16_384;

/// `640x480`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LARGEST_SIDE).contains(side));
    let sides = text.split_once(['x', 'X', '×']).map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok([width, height]),
        _ => Err("WIDTHxHEIGHT was expected, such as 640x480, each side from 1 to 16384".into()),
    }
}

/// `320,240`.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    match text.split_once(',').map(|(x, y)| (x.trim().parse(), y.trim().parse())) {
        Some((Ok(x), Ok(y))) => Ok([x, y]),
        _ => Err("the column and row of a pixel were expected, such as 320,240".into()),
    }
}

pub fn number(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("{text:?} is not a finite number"))
}

/// A finite number that is not negative.
pub fn not_negative(text: &str) -> Result<f64, String> {
    let number = number(text).ok().filter(|&number| number >= 0.0);
    number.ok_or_else(|| format!("{text:?} is not a finite number, 0 or more"))
}

/// `1,2,3`.
pub fn vector(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> = text.split(',').map(number).collect::<Result<_, _>>()?;
    let numbers: [f64; 3] =
        numbers.try_into().map_err(|_| format!("{text:?} is not three numbers such as 1,0,2.5"))?;
    Ok(DVec3::from_array(numbers))
}

/// `#rrggbb` in sRGB, three linear components, or one for a grey.
pub fn colour(text: &str) -> Result<LinearRgb, String> {
    let wrong = || {
        format!("{text:?} is no colour: #rrggbb (sRGB), R,G,B or one number (linear, 0 or more) was expected")
    };
    if let Some(digits) = text.strip_prefix('#') {
        let is_hexadecimal = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let code = u32::from_str_radix(digits, 16).ok().filter(|_| is_hexadecimal).ok_or_else(wrong)?;
        let [_, r, g, b] = code.to_be_bytes();
        return Ok(Srgb8([r, g, b]).into());
    }
    let numbers: Result<Vec<f64>, _> = text.split(',').map(not_negative).collect();
    match numbers.map_err(|_| wrong())?[..] {
        [grey] => Ok(LinearRgb::grey(grey)),
        [r, g, b] => Ok(LinearRgb::new(r, g, b)),
        _ => Err(wrong()),
    }
}

/// `normals`, `facing`, `depth`, `face-id`, `deviation` or `deviation=5`.
pub fn show(text: &str) -> Result<Show, String> {
    let (name, range) = text.split_once('=').map_or((text, None), |(name, range)| (name, Some(range)));
    match (name, range) {
        ("normals", None) => Ok(Show::Normals),
        ("facing", None) => Ok(Show::Facing),
        ("depth", None) => Ok(Show::Depth),
        ("face-id", None) => Ok(Show::FaceId),
        ("deviation", None) => Ok(Show::DEVIATION),
        ("deviation", Some(range)) => match number(range) {
            Ok(degrees) if degrees > 0.0 && degrees <= 180.0 => Ok(Show::Deviation(Degrees(degrees))),
            _ => Err("an angle over 0 and up to 180 degrees was expected after deviation=".into()),
        },
        _ => Err("normals, facing, depth, face-id, deviation or deviation=DEG was expected".into()),
    }
}

/// A guard's name and what becomes of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GuardSwitch {
    pub name: String,
    pub on: bool,
}

/// `highlight=off`.
pub fn guard(text: &str) -> Result<GuardSwitch, String> {
    use crease::shade::Guards;
    let (name, state) = text.split_once('=').unwrap_or((text, ""));
    let on = match state {
        "on" => Some(true),
        "off" => Some(false),
        _ => None,
    };
    match on.filter(|&on| Guards::default().set(name, on)) {
        Some(on) => Ok(GuardSwitch { name: name.into(), on }),
        None => Err(format!("NAME=on or NAME=off was expected, of {}", Guards::NAMES.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_codes_or_light() {
        assert_eq!(colour("#ff0000"), Ok(LinearRgb::new(1.0, 0.0, 0.0)));
        assert!((colour("#bcbcbc").unwrap().g - 0.502_886_5).abs() < 1e-6, "188 is about half the light");
        assert_eq!(colour("0.5"), Ok(LinearRgb::grey(0.5)));
        assert_eq!(colour("2, 0,1e-3"), Ok(LinearRgb::new(2.0, 0.0, 1e-3)));
        for wrong in ["", "#12", "#+12345", "#12345g", "1,2", "1,2,3,4", "-1", "nan", "1,inf,1", "red"] {
            assert!(colour(wrong).unwrap_err().contains("#rrggbb"), "{wrong}");
        }
    }

    #[test]
    fn sizes_and_pixels_are_two_whole_numbers() {
        assert_eq!(size("1920x1080"), Ok([1920, 1080]));
        assert_eq!(size("16384X1"), Ok([16_384, 1]));
        for wrong in ["", "640", "0x4", "4x16385", "-4x4", "4x4x4", "4.5x4"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(pixel("320, 240"), Ok([320, 240]));
        assert!(pixel("320").is_err() && pixel("-1,2").is_err() && pixel("1,2,3").is_err());
    }

    #[test]
    fn what_is_shown_and_guarded_has_names() {
        assert_eq!(show("deviation=5"), Ok(Show::Deviation(Degrees(5.0))));
        assert!(show("deviation=0").is_err() && show("depth=3").is_err() && show("").is_err());
        assert_eq!(guard("spot=off"), Ok(GuardSwitch { name: "spot".into(), on: false }));
        assert!(guard("spot").unwrap_err().contains("renormalise"));
        assert!(guard("lowlight=off").is_err() && guard("spot=maybe").is_err());
    }
}
