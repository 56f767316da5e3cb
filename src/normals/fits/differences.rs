//! The errors of jets and quadrics, estimated from how much these differ from fits to wider neighbourhoods.

use serde::Serialize;

/// Quadrics differ from those of one more ring by about their error. If that is up to so many times as large, it may be all of
/// their difference from jets.
const BIAS: f64 = 1.25;

/// Noisy jets are at most so many times as far from the truth as from the jets of one more ring: 2.4 to 3.4 times were measured.
const NOISY: f64 = 3.5;

/// The rms angles, in degrees, by which the fits at a mesh differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FitDifferences {
    /// Between jets and jets of one more ring of neighbours.
    pub jet: f64,
    /// Between quadrics and quadrics of one more ring.
    pub quadric: f64,
    /// Between jets and quadrics.
    pub jet_to_quadric: f64,
}

impl FitDifferences {
    /// The estimated error of jets.
    ///
    /// Without noise the error of a fit grows with its neighbourhood, so the difference from a wider fit is about the error itself.
    /// [Noise](Self::noise) is added.
    pub fn jet_error(&self) -> f64 {
        libm::hypot(self.jet, self.noise())
    }

    /// The estimated error of quadrics: their difference from wider ones, with and without noise. On coarse meshes both are wrong alike.
    /// It is at least the part of |j − q| that jets cannot have caused: (|j − q|² − (3.5 |j − j'|)²)^½.
    pub fn quadric_error(&self) -> f64 {
        let of_jets = NOISY * self.jet;
        let rest = self.jet_to_quadric * self.jet_to_quadric - of_jets * of_jets;
        self.quadric.max(rest.max(0.0).sqrt())
    }

    /// The part of the error of jets that is due to noise.
    ///
    /// Noise moves a jet and its wider twin alike, since both depend on the nearest vertices most. But it moves the jet away from
    /// the quadric, by more than the quadric's error: (|j − q|² − (1.25 |q − q'|)²)^½. This is at most 3.5 |j − j'|.
    pub fn noise(&self) -> f64 {
        let explained = BIAS * self.quadric;
        let unexplained = self.jet_to_quadric * self.jet_to_quadric - explained * explained;
        unexplained.max(0.0).sqrt().min(NOISY * self.jet)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_what_neither_error_explains() {
        let of = |jet, quadric, jet_to_quadric| FitDifferences { jet, quadric, jet_to_quadric };
        // Slivers: the quadric alone is wrong, and its difference from the wider one shows it.
        assert_eq!(of(0.05, 0.82, 0.8).jet_error(), 0.05);
        // The wider quadric shows but half of the error; the jets agree.
        assert!(of(0.02, 1.0, 2.0).jet_error() < 0.08);
        // Noise.
        let noisy = of(0.9, 0.9, 3.1);
        assert!((noisy.jet_error() - 3.1).abs() < 0.1 && noisy.noise() > 2.8, "{}", noisy.jet_error());
        assert_eq!((noisy.quadric_error(), FitDifferences::default().jet_error()), (0.9, 0.0));
        // A coarse wave without noise: quadrics were 20.6° from the truth, jets 1.4°.
        let coarse = of(2.9, 8.1, 20.2);
        assert!(coarse.quadric_error() > 17.0 && coarse.jet_error() < 11.0, "{}", coarse.quadric_error());
    }
}
