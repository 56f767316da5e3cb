use crate::num::test_numbers::Numbers;
use crate::surface::rays::primitive::*;

fn unit_sized() -> [Primitive; 9] {
    [
        Plane::default().into(),
        Sphere::default().into(),
        Ellipsoid::default().into(),
        Cylinder::default().into(),
        Cone::default().into(),
        Torus::default().into(),
        Ellipsoid::new(DVec3::new(0.05, 1.0, 0.5)).unwrap().into(),
        Cone::new(0.2, 1.5).unwrap().into(),
        Torus::new(1.0, 0.01).unwrap().into(),
    ]
}

fn in_cube(numbers: &mut Numbers, half: f64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| (2.0 * numbers.unit() - 1.0) * half))
}

/// A ray from a point at a distance to a point on the surface, or, every second time, to somewhere near.
fn aimed(primitive: &Primitive, numbers: &mut Numbers, distance: f64) -> Ray {
    let origin = in_cube(numbers, 1.0).normalize() * distance;
    let near = in_cube(numbers, 1.2);
    let target = match primitive.normal_at(near) {
        Some(normal) if numbers.below(2) == 0 => near - normal.get() * primitive.value(near),
        _ => near,
    };
    Ray::new(origin, (target - origin) * (0.1 + numbers.unit())).unwrap()
}

/// Whether the surface itself, not its continuation, is at this point of the zero set.
fn reaches(primitive: &Primitive, point: DVec3) -> bool {
    match primitive {
        Primitive::Plane(plane) => point.truncate().abs().cmple(plane.size() / 2.0).all(),
        Primitive::Cylinder(cylinder) => point.y.abs() <= cylinder.height() / 2.0,
        Primitive::Cone(cone) => point.y.abs() <= cone.height() / 2.0,
        _ => true,
    }
}

/// The first change of sign of the surface's function in many small steps along the ray, then bisected: slow, and
/// blind to pairs of crossings within a step, but it shares nothing with the closed forms.
fn march(primitive: &Primitive, ray: &Ray, steps: u32) -> Option<f64> {
    let end = 4.0 / ray.direction().length();
    let value = |t: f64| primitive.value(ray.at(t));
    let mut before = (0.0, value(0.0));
    for step in 1..=steps {
        let t = end * f64::from(step) / f64::from(steps);
        let after = (t, value(t));
        if (before.1 < 0.0) != (after.1 < 0.0) {
            let (mut low, mut high) = (before.0, after.0);
            for _ in 0..70 {
                let middle = f64::midpoint(low, high);
                if (value(middle) < 0.0) == (before.1 < 0.0) { low = middle } else { high = middle }
            }
            if reaches(primitive, ray.at(high)) {
                return Some(high);
            }
        }
        before = after;
    }
    None
}

#[test]
fn marching_along_the_ray_finds_the_same_hits() {
    let mut numbers = Numbers::new(41);
    for primitive in unit_sized() {
        let (mut hits, mut misses, mut tangent) = (0, 0, 0);
        for _ in 0..400 {
            let ray = aimed(&primitive, &mut numbers, 2.0);
            let (hit, marched) = (primitive.intersect(&ray), march(&primitive, &ray, 4000));
            match (hit, marched) {
                (None, None) => misses += 1,
                (Some(hit), Some(t)) => {
                    // Both solve the equation to some 4e-16 across the surface, which along the ray is more by 1
                    // over the cosine of incidence; the ray's length of about 2 adds its own rounding.
                    let cosine = hit.normal.get().dot(ray.direction().normalize()).abs();
                    let error = (hit.t - t).abs() * ray.direction().length();
                    if error > 0.01 {
                        tangent += 1;
                        continue;
                    }
                    assert!(error * cosine.min(1.0) < 4e-15, "{primitive:?}: {error:e} at cosine {cosine:e}");
                    hits += 1;
                }
                // Two crossings within one step of the march.
                (Some(hit), None) => {
                    let beyond = ray.at(hit.t + 0.002 / ray.direction().length());
                    assert!(primitive.value(beyond).abs() < 0.002, "{primitive:?} {ray:?} {hit:?}");
                    tangent += 1;
                }
                (None, Some(t)) => panic!("{primitive:?} missed at {t}: {ray:?}"),
            }
        }
        assert!(hits >= 10 && misses >= 50 && tangent <= 8, "{primitive:?}: {hits} {misses} {tangent}");
    }
}

#[test]
fn hits_lie_on_surface_and_ray_at_any_distance() {
    let mut numbers = Numbers::new(42);
    let (mut worst_value, mut worst_off) = (0.0_f64, 0.0_f64);
    for primitive in unit_sized() {
        for distance in [0.0, 2.0, 1e3, 1e6, 1e9] {
            for _ in 0..3000 {
                let ray = aimed(&primitive, &mut numbers, distance);
                let Some(hit) = primitive.intersect(&ray) else { continue };
                worst_value = worst_value.max(primitive.value(hit.position).abs());
                // The offset of the hit across the ray, in units of what the rounding of the ray's origin leaves open.
                let direction = ray.direction().normalize();
                let across = (hit.position - ray.origin()).cross(direction).length();
                worst_off = worst_off.max(across / (1.0 + distance));
                let along = (ray.at(hit.t) - hit.position).length();
                let cosine = hit.normal.get().dot(direction).abs();
                assert!(along * cosine.min(1.0) < 1e-15 * (4.0 + 4.0 * distance), "{primitive:?} {along:e}");
                assert!(hit.t > 0.0 && reaches(&primitive, hit.position * (1.0 - 1e-15)));
                assert_eq!(hit.front, direction.dot(hit.normal.get()) < 0.0);
            }
        }
    }
    // Measured: 3.3e-16 and 4.5e-16.
    assert!(worst_value < 1e-15, "{worst_value:e}");
    assert!(worst_off < 1e-15, "{worst_off:e}");
}

/// Central differences of the function have an error of h²/6 of its third derivative: halving h divides it by four.
#[test]
fn normals_are_gradients_to_second_order() {
    let mut numbers = Numbers::new(43);
    for primitive in unit_sized() {
        let difference = |p: DVec3, h: f64| {
            let slope = |axis: DVec3| primitive.value(p + axis * h) - primitive.value(p - axis * h);
            DVec3::from_array(DVec3::AXES.map(slope)).normalize()
        };
        let mut errors = [0.0_f64; 3];
        let mut count = 0;
        while count < 200 {
            let Some(hit) = primitive.intersect(&aimed(&primitive, &mut numbers, 2.0)) else { continue };
            // Close to the tip the third derivative has no bound.
            if matches!(primitive, Primitive::Cone(_)) && hit.position.y > 0.6 {
                continue;
            }
            count += 1;
            for (error, h) in errors.iter_mut().zip([4e-3, 2e-3, 1e-3]) {
                *error = error.max((difference(hit.position, h) - hit.normal.get()).length());
            }
        }
        if matches!(primitive, Primitive::Plane(_)) {
            assert!(errors[0] < 1e-12, "{errors:?}");
            continue;
        }
        for pair in errors.windows(2) {
            let order = libm::log2(pair[0] / pair[1]);
            // For the thinnest torus and ellipsoid h is a tenth of the radius of curvature: terms of higher order show.
            assert!((order - 2.0).abs() < 0.2, "{primitive:?}: order {order} from {errors:?}");
        }
    }
}

#[test]
fn rays_along_axes_and_generators_have_their_hits() {
    let cast = |primitive: Primitive, origin: [f64; 3], direction: [f64; 3]| {
        let hit = primitive.intersect(&Ray::new(origin.into(), direction.into()).unwrap())?;
        Some((hit.t, hit.position.to_array(), hit.normal.get().to_array(), hit.front))
    };
    let (cylinder, cone) = (Cylinder::default().into(), Cone::default().into());
    let torus = Torus::default().into();
    assert_eq!(cast(cylinder, [0.5, 5.0, 0.0], [0.0, -1.0, 0.0]), None);
    assert_eq!(
        cast(cylinder, [0.0; 3], [2.0, 0.0, 0.0]),
        Some((0.5, [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], false))
    );
    // Down the axis onto the tip, and along a generator of the other side.
    assert_eq!(
        cast(cone, [0.0, 3.0, 0.0], [0.0, -1.0, 0.0]),
        Some((2.0, [0.0, 1.0, 0.0], [0.0, 1.0, 0.0], true))
    );
    // (0.5t − 0.5)² + 0.1² = (0.5 − t)²/4 has the one root 0.79.
    let (t, [_, y, _], _, front) = cast(cone, [-0.5, 1.5, 0.1], [0.5, -1.0, 0.0]).unwrap();
    assert!((t - 0.79).abs() < 1e-15 && (y - 0.71).abs() < 1e-15 && front, "{t} {y}");
    // Through the hole, and through the tube twice: the first of four.
    assert_eq!(cast(torus, [0.1, 5.0, 0.1], [0.0, -1.0, 0.0]), None);
    let (t, ..) = cast(torus, [-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]).unwrap();
    assert!((t - 1.6).abs() < 1e-15, "{t}");
    let (t, _, normal, front) = cast(torus, [0.0; 3], [1.0, 0.0, 0.0]).unwrap();
    assert!((t - 0.6).abs() < 1e-15 && front && normal == [-1.0, 0.0, 0.0], "{t} {normal:?}");
    let plane = Plane::default().into();
    assert_eq!(cast(plane, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), None);
    assert_eq!(cast(plane, [0.0, 0.0, 1.0], [1.1, 0.0, -1.0]), None);
    assert_eq!(
        cast(plane, [0.5, 0.0, -1.0], [0.0, 0.0, 2.0]),
        Some((0.5, [0.5, 0.0, 0.0], [0.0, 0.0, 1.0], false))
    );
}

/// In a plane through the axis the tube is a circle, so whether a line there meets it is known exactly.
#[test]
fn thin_tubes_are_hit_and_missed_to_the_stated_width() {
    let mut numbers = Numbers::new(46);
    for (minor, slack) in [(0.3, 1e-13), (1e-2, 1e-10), (1e-4, 1e-6)] {
        // 10⁻¹⁵·R²/r, as a share of r and with a hundred times to spare.
        assert!(slack >= 1e-15 / (minor * minor));
        let torus = Torus::new(1.0, minor).unwrap();
        for _ in 0..4000 {
            let (sin, cos) = libm::sincos(7.0 * numbers.unit());
            let out = DVec3::new(sin, 0.0, cos);
            // Steep enough to pass the other side of the ring by far.
            let (rise, run) = libm::sincos(1.0 + 1.1 * numbers.unit());
            let (along, across) = (out * run + DVec3::Y * rise, DVec3::Y * run - out * rise);
            let aim = |share: f64| {
                let origin = out + across * (minor * share) - along * 2.0;
                torus.first_hit(&Ray::new(origin, along).unwrap())
            };
            assert!(aim(1.0 - slack).is_some() && aim(slack - 1.0).is_some(), "{minor} {rise}");
            assert!(aim(1.0 + slack).is_none() && aim(-1.0 - slack).is_none(), "{minor} {rise}");
        }
    }
}

#[test]
fn scale_by_powers_of_two_scales_hits() {
    let scaled = |primitive: &Primitive, by: f64| -> Primitive {
        match primitive {
            Primitive::Plane(plane) => Plane::new(plane.size().x * by, plane.size().y * by).unwrap().into(),
            Primitive::Sphere(sphere) => Sphere::new(sphere.radius() * by).unwrap().into(),
            Primitive::Ellipsoid(ellipsoid) => Ellipsoid::new(ellipsoid.semi_axes() * by).unwrap().into(),
            Primitive::Cylinder(tube) => {
                Cylinder::new(tube.radius() * by, tube.height() * by).unwrap().into()
            }
            Primitive::Cone(cone) => Cone::new(cone.radius() * by, cone.height() * by).unwrap().into(),
            Primitive::Torus(torus) => Torus::new(torus.major() * by, torus.minor() * by).unwrap().into(),
        }
    };
    let mut numbers = Numbers::new(44);
    for primitive in unit_sized() {
        for power in [-180, -60, 60, 180] {
            let by = libm::ldexp(1.0, power);
            let large = scaled(&primitive, by);
            for _ in 0..200 {
                let ray = aimed(&primitive, &mut numbers, 2.0);
                let hit = primitive.intersect(&ray);
                let again = large.intersect(&Ray::new(ray.origin() * by, ray.direction() * by).unwrap());
                assert_eq!(again.map(|hit| Hit { position: hit.position / by, ..hit }), hit);
            }
        }
    }
}

#[test]
fn placed_primitives_are_hit_where_their_images_are() {
    let mut numbers = Numbers::new(45);
    for primitive in unit_sized() {
        for mirror in [1.0, -1.0] {
            let map = DMat4::from_translation(DVec3::new(1e3, -2e3, 500.0))
                * DMat4::from_rotation_x(0.7)
                * DMat4::from_scale(DVec3::new(2.0, 0.5, mirror))
                * DMat4::from_rotation_z(0.3);
            let placed = Placed::new(primitive, map).unwrap();
            let mut hits = 0;
            for _ in 0..300 {
                let ray = aimed(&primitive, &mut numbers, 2.0);
                let origin = map.transform_point3(ray.origin());
                let moved = Ray::new(origin, map.transform_vector3(ray.direction())).unwrap();
                let (Some(hit), Some(image)) = (primitive.intersect(&ray), placed.intersect(&moved)) else {
                    continue;
                };
                hits += 1;
                let cosine = hit.normal.get().dot(ray.direction().normalize()).abs();
                // Positions of 2000 are rounded by 2e-13, which the stretching by 4 can make four times as much.
                assert!((hit.t - image.t).abs() * cosine < 4e-12, "{:e}", hit.t - image.t);
                if cosine > 0.1 {
                    assert!((map.transform_point3(hit.position) - image.position).length() < 4e-11);
                    // Tangents stay perpendicular, and what was seen from outside still is. The sharpest curvature
                    // (the thin ellipsoid's tips) turns the normal by 400 times the offset.
                    for tangent in
                        [hit.normal.get().any_orthonormal_pair().0, hit.normal.get().any_orthonormal_pair().1]
                    {
                        let dot = map.transform_vector3(tangent).dot(image.normal.get());
                        assert!(dot.abs() < 1e-7, "{primitive:?}: {dot:e}");
                    }
                    assert_eq!(hit.front, image.front);
                    let facing = moved.direction().dot(image.normal.get()) < 0.0;
                    assert_eq!(facing, image.front);
                }
            }
            assert!(hits > 10);
        }
    }
    let flat = Placed::new(Sphere::default().into(), DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0)));
    let fact = "the transform is singular or not finite, so the surface has no normals under it";
    assert_eq!(flat, Err(SurfaceError::Invalid(fact.into())));
}

#[test]
fn lengths_are_checked() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e61, 1e-61] {
        assert!(matches!(Sphere::new(bad), Err(SurfaceError::OutOfRange(_))));
        assert!(Plane::new(1.0, bad).is_err() && Ellipsoid::new(DVec3::new(1.0, 1.0, bad)).is_err());
        assert!(
            Cylinder::new(1.0, bad).is_err() && Cone::new(bad, 1.0).is_err() && Torus::new(1.0, bad).is_err()
        );
    }
    let fact = "the tube's radius 0.4 is not smaller than the ring's radius 0.4";
    assert_eq!(Torus::new(0.4, 0.4), Err(SurfaceError::Invalid(fact.into())));
}
