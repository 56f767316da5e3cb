//! Light on points whose faces turn away from it.

use super::{direction, sun, uniform};
use crate::random::Random;
use crease::num::LinearRgb;
use crease::shade::{
    AreaShape, Attenuation, Cone, Guards, Light, Material, Probe, ShadeSettings, Shader, SurfacePoint,
    SurfaceRows, Terminator, Viewer,
};
use glam::DVec3;

fn settings(terminator: Terminator) -> ShadeSettings {
    ShadeSettings { terminator, viewer: Viewer::At(DVec3::new(0.5, 1.0, 9.0)), ..ShadeSettings::default() }
}

fn lights() -> [Light; 4] {
    let colour = LinearRgb::new(0.9, 0.5, 0.2);
    let (position, attenuation) = (DVec3::new(3.0, -2.0, 1.0), Attenuation::Offset(1.0));
    let shape = AreaShape::Rectangle { centre: position, u: DVec3::X, v: DVec3::Z };
    [
        sun(0.3, 0.8, 0.2),
        Light::Point { position, colour, attenuation },
        Light::Spot { position, cone: Cone::of_lectures(-position), colour, attenuation },
        Light::Area { shape, colour },
    ]
}

/// The published term, written out by itself: diffuse light and highlight alike.
#[test]
fn light_goes_out_as_published() {
    let (light, material) = (sun(0.0, 0.0, 1.0), Material::default());
    let mut random = Random(2019);
    let mut softened = 0;
    for _ in 0..2000 {
        let [normal, face] = [(); 2].map(|()| direction(&mut random));
        let normal = if normal.dot(face) < 0.0 { -normal } else { normal };
        let point = SurfacePoint { position: [0.1, 0.2, 0.3], normal: normal.to_array() };
        let shade = |terminator| {
            let shader = Shader::<f64>::new(&[light], &material, &settings(terminator)).unwrap();
            shader.shade_on(&point, Some(face.to_array())).unwrap()[0]
        };
        let plain = shade(Terminator::Smooth);
        let without = Shader::<f64>::new(&[light], &material, &settings(Terminator::Soft)).unwrap();
        assert_eq!(without.shade(&point).unwrap()[0], plain, "no face, no terminator");
        assert_eq!(shade(Terminator::Hard), if face.z > 0.0 { plain } else { 0.0 });
        if normal.z <= 0.0 {
            continue;
        }
        let g = face.z / (normal.z * face.dot(normal));
        let factor = if g >= 1.0 {
            1.0
        } else if g < 0.0 {
            0.0
        } else {
            softened += 1;
            -(g * g * g) + g * g + g
        };
        // Some ten roundings of numbers below 1.
        assert!((shade(Terminator::Soft) - factor * plain).abs() < 1e-14, "{normal} {face}");
    }
    assert!(softened > 100, "{softened}");
}

#[test]
fn rows_on_faces_have_the_bits_of_their_points_and_probes_tell_them() {
    let mut random = Random(1907);
    let count = 300;
    let mut rows = [(); 9].map(|()| vec![0.0_f32; count]);
    for i in 0..count {
        let normal = direction(&mut random);
        let face = (normal + 0.9 * direction(&mut random)).normalize();
        let position = direction(&mut random) * uniform(&mut random);
        let all = [position, normal, face].map(|v| v.as_vec3().to_array());
        rows.iter_mut().zip(all.as_flattened()).for_each(|(row, &component)| row[i] = component);
    }
    let [px, py, pz, nx, ny, nz, fx, fy, fz] = rows.each_ref().map(|row| &row[..]);
    let points = SurfaceRows { positions: [px, py, pz], normals: [nx, ny, nz], faces: Some([fx, fy, fz]) };
    for terminator in [Terminator::Smooth, Terminator::Hard, Terminator::Soft] {
        for guards in [Guards::default(), Guards::literal()] {
            let settings = ShadeSettings { guards, ..settings(terminator) };
            let material = Material::default();
            let shader = Shader::<f32>::new(&lights(), &material, &settings).unwrap();
            let mut out = [(); 3].map(|()| vec![0.0_f32; count]);
            let colours = out.each_mut().map(|row| &mut row[..]);
            shader.shade_rows(&points, colours).unwrap();
            let probe = Probe::new(&lights(), &material, &settings).unwrap();
            let double = Shader::<f64>::new(&lights(), &material, &settings).unwrap();
            for i in 0..count {
                let point = SurfacePoint { position: [px[i], py[i], pz[i]], normal: [nx[i], ny[i], nz[i]] };
                let face = [fx[i], fy[i], fz[i]];
                let colour = [0, 1, 2].map(|axis| out[axis][i]);
                assert_eq!(shader.shade_on(&point, Some(face)).unwrap(), colour, "{terminator:?} {i}");
                let wide = SurfacePoint {
                    position: point.position.map(f64::from),
                    normal: point.normal.map(f64::from),
                };
                let face = face.map(f64::from);
                assert_eq!(
                    probe.explain_on(&wide, Some(face)).sum,
                    double.shade_on(&wide, Some(face)).unwrap()
                );
            }
        }
    }
}
