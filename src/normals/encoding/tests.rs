use crate::normals::encoding::*;
use crate::num::test_numbers::Numbers;

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
}

fn directions(count: usize) -> impl Iterator<Item = DVec3> {
    let mut numbers = Numbers::new(38);
    std::iter::from_fn(move || {
        let v = DVec3::from_array(std::array::from_fn(|_| 2.0 * numbers.unit() - 1.0));
        Some(v)
    })
    .filter(|v| (0.01..1.0).contains(&v.length()))
    .map(|v| v.normalize())
    .take(count)
}

/// The worst angle of an encoding, as in the table of the module.
fn worst(encoding: Encoding) -> f64 {
    encoding.worst_angle().0
}

#[test]
fn no_direction_is_worse_than_documented() {
    for encoding in Encoding::ALL {
        let found = directions(100_000)
            .map(|normal| {
                let back = encoding.decode(encoding.encode(normal));
                assert!((back.length() - 1.0).abs() < 1e-15);
                angle(normal, back)
            })
            .fold(0.0, f64::max);
        // That the bound is not idle: a sample of this size comes within a tenth of it.
        let bound = worst(encoding);
        assert!((0.9 * bound..=bound).contains(&found), "{}: {found} of {bound}", encoding.name());
    }
}

/// Normals that are looked for, as a sample does not find them: components halfway between two codes, where all three
/// errors are at right angles to the normal.
#[test]
fn the_worst_directions_come_close_to_the_bound_and_not_over_it() {
    let mut numbers = Numbers::new(59);
    let mut halfway = |near: f64, step: f64| {
        // As many steps as it takes the third component to go from one code to the next by the sphere's curvature.
        let off = (0.9 / step.sqrt() * numbers.unit()).round() + 0.5;
        ((near / step).round() + off) * step + 1e-9 * step * (numbers.unit() - 0.5)
    };
    let third = |a: f64, b: f64| (1.0 - a * a - b * b).max(0.0).sqrt();
    for (encoding, share) in [
        (Encoding::Half, 0.995),
        (Encoding::Snorm(Snorm::SIXTEEN), 0.999),
        (Encoding::OCTAHEDRAL_16, 0.997),
        (Encoding::Single, 0.995),
    ] {
        let mut found = 0.0_f64;
        for _ in 0..40_000 {
            let normal = match encoding {
                Encoding::Half | Encoding::Single => {
                    let step = if encoding == Encoding::Half { 1.0 / 2048.0 } else { libm::ldexp(1.0, -24) };
                    let [b, c] = [0; 2].map(|_| halfway(0.5, step));
                    DVec3::new(third(b, c), b, c)
                }
                Encoding::Snorm(_) => {
                    let [b, c] = [FRAC_1_SQRT_2, 0.0].map(|near| halfway(near, 1.0 / 32767.0));
                    DVec3::new(-third(b, c), b, c)
                }
                Encoding::Octahedral(..) => {
                    let [x, y] = [0; 2].map(|_| halfway(1.0 / 3.0, 1.0 / 32767.0));
                    DVec3::new(x, y, 1.0 - x - y).normalize()
                }
            };
            found = found.max(angle(normal, encoding.decode(encoding.encode(normal))));
        }
        let bound = worst(encoding);
        assert!((share * bound..=bound).contains(&found), "{}: {found} of {bound}", encoding.name());
    }
}

/// The largest error is in the middle of an octant. Samples seldom hit it, so the search starts there and at the worst
/// of a sample, and climbs by random steps that shrink.
#[test]
fn climbing_to_the_worst_direction_stays_below_the_bound() {
    let mut numbers = Numbers::new(28);
    for bits in 8..=16 {
        for rounding in [Rounding::Plain, Rounding::Nearest] {
            let encoding = Encoding::octahedral(bits, rounding);
            let error = |normal: DVec3| angle(normal, encoding.decode(encoding.encode(normal)));
            let signs =
                (0..8).map(|octant| [0, 1, 2].map(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 }));
            let mut starts: Vec<DVec3> = signs.map(|signs| DVec3::from(signs).normalize()).collect();
            if rounding == Rounding::Nearest && bits == 8 {
                // The value of an independent search among all codes.
                assert!((error(starts[0]) - 0.637_993).abs() < 1e-6, "{}", error(starts[0]));
            }
            let mut sample: Vec<DVec3> = directions(5_000).collect();
            sample.sort_by(|&a, &b| error(b).total_cmp(&error(a)));
            starts.extend(&sample[..8]);
            let mut found = 0.0_f64;
            for mut best in starts {
                let mut step = 4.0 / largest_code(bits);
                while step > 1e-9 {
                    let offset = DVec3::from_array(std::array::from_fn(|_| 2.0 * numbers.unit() - 1.0));
                    let next = (best + step * offset).normalize();
                    if error(next) > error(best) { best = next } else { step *= 0.95 }
                }
                found = found.max(error(best));
            }
            let bound = worst(encoding);
            assert!((0.995 * bound..=bound).contains(&found), "{}: {found} of {bound}", encoding.name());
        }
    }
}

/// The vectors of meshoptimizer's own tests of its octahedral filter: x, y of the code.
#[test]
fn octahedral_codes_are_those_of_meshoptimizer() {
    let cases = [
        ([1.0, 0.0, 0.0], [0x7f, 0], [0x7ff, 0]),
        ([0.0, -1.0, 0.0], [0, -0x7f], [0, -0x7ff]),
        ([FRAC_1_SQRT_2, 0.0, 0.707_168], [0x3f, 0], [0x3ff, 0]),
        ([-FRAC_1_SQRT_2, 0.0, -0.707_168], [-0x7f, 0x40], [-0x7ff, 0x400]),
    ];
    for (normal, eight, twelve) in cases {
        let encode = |bits| Octahedral::new(bits).unwrap().encode(DVec3::from(normal), Rounding::Plain);
        assert_eq!((encode(8), encode(12)), (eight, twelve), "{normal:?}");
    }
}

#[test]
fn axes_are_exact() {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    for axis in axes {
        for encoding in Encoding::ALL {
            assert_eq!(encoding.decode(encoding.encode(axis)), axis, "{}", encoding.name());
        }
    }
    // All four corners of the square are the lower pole.
    for corner in [[127, 127], [127, -127], [-127, 127], [-127, -127], [-128, -128]] {
        assert_eq!(Octahedral::new(8).unwrap().decode(corner), DVec3::NEG_Z);
    }
}

/// Folds are where codes of neighbours are far apart: both sides must decode to neighbours, and no direction near them
/// may be worse than elsewhere.
#[test]
fn poles_and_edges_of_octants_are_no_worse() {
    let mut numbers = Numbers::new(5);
    let near_edges: Vec<DVec3> = (0..60_000)
        .map(|round| {
            let angle = std::f64::consts::TAU * numbers.unit();
            let off = numbers.spread(40) * 1e-12;
            let [a, b] = [libm::cos(angle), libm::sin(angle)];
            let v = match round % 4 {
                0 => DVec3::new(a, b, off),
                1 => DVec3::new(a, off, b),
                2 => DVec3::new(off, a, b),
                // Close to the poles.
                _ => DVec3::new(a * off.abs().min(1.0) * 1e-3, b * 1e-3, if a > 0.0 { 1.0 } else { -1.0 }),
            };
            v.normalize()
        })
        .collect();
    for encoding in Encoding::ALL {
        let found =
            near_edges.iter().map(|&n| angle(n, encoding.decode(encoding.encode(n)))).fold(0.0, f64::max);
        assert!(found <= worst(encoding), "{}: {found}", encoding.name());
    }
}

#[test]
fn the_nearest_of_four_is_never_farther() {
    for bits in [8, 11, 16] {
        let codec = Octahedral::new(bits).unwrap();
        for normal in directions(20_000) {
            let [plain, nearest] = [Rounding::Plain, Rounding::Nearest]
                .map(|rounding| codec.decode(codec.encode(normal, rounding)).distance(normal));
            // Chords of directions that are equally near differ in their last bits.
            assert!(nearest <= plain + 1e-15, "{bits} {normal}");
        }
    }
}

/// A code's own direction has that code.
#[test]
fn codes_come_back() {
    let mut numbers = Numbers::new(9);
    let codec = Octahedral::new(8).unwrap();
    for x in -127..=127_i32 {
        for y in -127..=127_i32 {
            let on_fold = x.abs() == 127 || y.abs() == 127;
            let again = codec.encode(codec.decode([x, y]), Rounding::Plain);
            // On the square's sides two codes share a direction.
            assert!(again == [x, y] || on_fold && codec.decode(again).distance(codec.decode([x, y])) < 1e-15);
        }
    }
    for encoding in Encoding::ALL {
        let normals: Vec<DVec3> =
            (0..100).map(|_| DVec3::new(numbers.unit(), -numbers.unit(), 0.3).normalize()).collect();
        let packed = encoding.pack(normals.iter().copied());
        assert_eq!(packed.len(), 100 * encoding.bytes());
        let singly = normals.iter().map(|&n| encoding.decode(encoding.encode(n)));
        assert!(encoding.unpack(&packed).eq(singly), "{}", encoding.name());
    }
}

#[test]
fn what_has_no_direction_is_up_front() {
    let infinite = DVec3::new(f64::INFINITY, 0.0, 0.0);
    for encoding in Encoding::ALL {
        for odd in [DVec3::ZERO, DVec3::NAN] {
            assert_eq!(encoding.decode(encoding.encode(odd)), DVec3::Z, "{}", encoding.name());
        }
        assert!(encoding.decode(encoding.encode(infinite)).is_normalized(), "{}", encoding.name());
        assert!(encoding.decode(u128::MAX).is_normalized());
    }
    // Octahedral codes take any length.
    let codec = Octahedral::new(16).unwrap();
    let code = codec.encode(DVec3::new(1.0, 2.0, 3.0), Rounding::Plain);
    for scale in [1e-300, 1e300] {
        assert_eq!(codec.encode(DVec3::new(1.0, 2.0, 3.0) * scale, Rounding::Plain), code);
    }
}

#[test]
fn sizes() {
    let bytes: Vec<usize> = Encoding::ALL.iter().map(|encoding| encoding.bytes()).collect();
    assert_eq!(bytes[..8], [2, 2, 3, 3, 3, 3, 3, 3]);
    assert_eq!(bytes[16..], [4, 4, 3, 4, 6, 6, 12]);
    assert_eq!(Octahedral::new(7).or(Octahedral::new(17)), None);
}
