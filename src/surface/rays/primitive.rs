//! The surfaces that rays can be cast at, and their placement in a world.

use crate::mesh::{NormalMatrix, normal_matrix};
use crate::num::UnitVec3;
use crate::surface::error::{Result, SurfaceError};
use crate::surface::rays::ray::{Hit, Ray};
use crate::surface::shapes::height::Plane;
use crate::surface::shapes::implicit::{Cast, Implicit, Shape};
use crate::surface::shapes::revolution::{Cone, Cylinder, Torus};
use crate::surface::shapes::star::{Ellipsoid, Sphere};
use glam::{DMat3, DMat4, DVec3};

/// A surface whose first hit by a ray can be computed.
///
/// # Accuracy
/// For a surface of size about 1 and a ray from up to 1e6 away, the hit lies within 1e-15 of the surface, with the
/// exact normal of that point. The error of `t` is a few roundings plus 1e-15 over the cosine of the angle of
/// incidence. A ray that grazes the surface closer than that may hit it or miss it.
///
/// ```
/// use crease::surface::{Primitive, Ray, Torus};
/// use glam::DVec3;
///
/// let torus = Primitive::from(Torus::new(2.0, 0.5)?);
/// let ray = Ray::new(DVec3::new(1e6, 0.0, 0.0), DVec3::NEG_X).unwrap();
/// let hit = torus.intersect(&ray).unwrap();
/// assert_eq!((hit.position, hit.normal.get(), hit.front), (DVec3::new(2.5, 0.0, 0.0), DVec3::X, true));
/// # Ok::<(), crease::surface::SurfaceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A rectangle.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid),
    /// A tube.
    Cylinder(Cylinder),
    /// A cone.
    Cone(Cone),
    /// A torus.
    Torus(Torus),
}

macro_rules! each {
    ($self:ident, $surface:ident => $work:expr) => {
        match $self {
            Primitive::Plane($surface) => $work,
            Primitive::Sphere($surface) => $work,
            Primitive::Ellipsoid($surface) => $work,
            Primitive::Cylinder($surface) => $work,
            Primitive::Cone($surface) => $work,
            Primitive::Torus($surface) => $work,
        }
    };
}

macro_rules! from {
    ($($surface:ident),*) => {$(
        impl From<$surface> for Primitive {
            fn from(surface: $surface) -> Self {
                Primitive::$surface(surface)
            }
        }
    )*};
}

from!(Plane, Sphere, Ellipsoid, Cylinder, Cone, Torus);

impl Primitive {
    /// The first hit of a ray in front of its origin, on either side of the surface. A ray that starts on the surface
    /// may or may not hit it there: start it a small distance away, on the intended side.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        each!(self, surface => surface.first_hit(ray))
    }

    /// Half the sizes of the smallest box about the origin, along the axes, that holds the surface.
    pub fn half_extents(&self) -> DVec3 {
        let turned = |radius: f64, height: f64| DVec3::new(radius, height / 2.0, radius);
        match self {
            Primitive::Plane(plane) => (plane.size() / 2.0).extend(0.0),
            Primitive::Sphere(sphere) => DVec3::splat(sphere.radius()),
            Primitive::Ellipsoid(ellipsoid) => ellipsoid.semi_axes(),
            Primitive::Cylinder(tube) => turned(tube.radius(), tube.height()),
            Primitive::Cone(cone) => turned(cone.radius(), cone.height()),
            Primitive::Torus(torus) => turned(torus.major() + torus.minor(), 2.0 * torus.minor()),
        }
    }

    /// Whether it has no border, so that a ray that enters also leaves.
    pub fn is_closed(&self) -> bool {
        matches!(self, Primitive::Sphere(_) | Primitive::Ellipsoid(_) | Primitive::Torus(_))
    }

    pub(crate) fn shape(&self) -> &dyn Shape {
        each!(self, surface => surface)
    }
}

impl Implicit for Primitive {
    fn value(&self, point: DVec3) -> f64 {
        self.shape().value(point)
    }

    fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        self.shape().normal_at(point)
    }
}

/// A primitive under an affine map: moved, rotated, stretched, sheared or mirrored.
///
/// Rays are mapped by the inverse, normals by the inverse transpose. Outward surfaces stay outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    primitive: Primitive,
    world_from_object: DMat3,
    object_from_world: DMat3,
    origin: DVec3,
    normals: NormalMatrix,
}

impl Placed {
    /// A primitive placed by a matrix, the last row of which is ignored.
    ///
    /// # Errors
    /// A singular map, or one that is not finite.
    pub fn new(primitive: Primitive, world_from_object: DMat4) -> Result<Self> {
        let (linear, origin) = (DMat3::from_mat4(world_from_object), world_from_object.w_axis.truncate());
        let normals = normal_matrix(linear);
        let object_from_world = linear.inverse();
        match normals.filter(|_| object_from_world.is_finite() && origin.is_finite()) {
            Some(normals) => {
                Ok(Self { primitive, world_from_object: linear, object_from_world, origin, normals })
            }
            None => {
                let fact = "the transform is singular or not finite, so the surface has no normals under it";
                Err(SurfaceError::Invalid(fact.into()))
            }
        }
    }

    /// The primitive.
    pub fn primitive(&self) -> &Primitive {
        &self.primitive
    }

    /// The first hit of a ray, both in world space; `None` also for coordinates beyond 1e90 in the primitive's own space.
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        // The origin is subtracted first: the difference of two far points is exact, that of their images is not.
        let map = self.object_from_world;
        let ray = Ray::new(map * (ray.origin() - self.origin), map * ray.direction())?;
        let hit = self.primitive.intersect(&ray)?;
        Some(Hit {
            position: self.world_from_object * hit.position + self.origin,
            normal: self.normal(hit.normal)?,
            ..hit
        })
    }

    /// The centre and the radius of a sphere around the surface, in world space.
    pub(crate) fn sphere(&self) -> (DVec3, f64) {
        let half = self.primitive.half_extents();
        let axes = self.world_from_object * DMat3::from_diagonal(half);
        (self.origin, [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::length).iter().sum())
    }

    /// The exact normal at a point of the surface in world space, as [`Implicit::normal_at`].
    pub fn normal_at(&self, point: DVec3) -> Option<UnitVec3> {
        self.normal(self.primitive.normal_at(self.object_from_world * (point - self.origin))?)
    }

    fn normal(&self, normal: UnitVec3) -> Option<UnitVec3> {
        UnitVec3::new(self.normals.apply(normal.get())?)
    }
}

#[cfg(test)]
mod tests;
