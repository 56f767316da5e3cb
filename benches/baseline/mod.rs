//! The plain code to compare with: a rasterizer in one thread, a pixel at a time.

use crease::raster::{Camera, Projection};
use crease::shade::Material;
use glam::{DVec3, Mat3, Vec3};

/// Where colours are computed.
#[derive(Clone, Copy, PartialEq)]
pub enum Mode {
    Flat,
    Gouraud,
    Phong,
}

/// The picture and what it is drawn with.
pub struct Baseline {
    size: [usize; 2],
    mode: Mode,
    eye: Vec3,
    /// To camera space: x right, y up, z forward.
    turn: Mat3,
    scale: f32,
    towards: Vec3,
    /// Ambient is omitted: the scene has none. Diffuse and specular for each component.
    reflect: [Vec3; 2],
    vertices: Vec<Vertex>,
    depth: Vec<f32>,
    pub pixels: Vec<[u8; 3]>,
}

#[derive(Clone, Copy, Default)]
struct Vertex {
    x: f32,
    y: f32,
    /// 1/z.
    inverse: f32,
    colour: Vec3,
}

impl Baseline {
    pub fn new(size: [u32; 2], camera: &Camera, towards: DVec3, mode: Mode) -> Self {
        let [right, up, forward] = camera.axes().expect("a camera").map(|axis| axis.as_vec3());
        let Projection::Perspective(angle) = camera.projection else { panic!("a perspective camera") };
        let material = Material::default();
        let merged = |k: crease::shade::Reflectance| DVec3::from(k.merged().to_array()).as_vec3();
        let size = size.map(|n| n as usize);
        Self {
            size,
            mode,
            eye: camera.eye.as_vec3(),
            turn: Mat3::from_cols(right, up, forward).transpose(),
            scale: (size[1] as f64 / 2.0 / libm::tan(angle.0 / 2.0)) as f32,
            towards: towards.normalize().as_vec3(),
            reflect: [merged(material.diffuse), merged(material.specular)],
            vertices: Vec::new(),
            depth: vec![0.0; size[0] * size[1]],
            pixels: vec![[0; 3]; size[0] * size[1]],
        }
    }

    /// Diffuse light and Blinn's highlight.
    #[allow(clippy::disallowed_methods, reason = "the platform's power is what a plain program uses")]
    fn light(&self, position: Vec3, normal: Vec3) -> Vec3 {
        let n = normal.normalize();
        let cosine = n.dot(self.towards);
        if cosine <= 0.0 {
            return Vec3::ZERO;
        }
        let view = (self.eye - position).normalize();
        let half = (self.towards + view).normalize();
        self.reflect[0] * cosine + self.reflect[1] * n.dot(half).max(0.0).powf(32.0)
    }

    pub fn draw(
        &mut self,
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        normals: &[[f32; 3]],
        faces: &[[f32; 3]],
    ) {
        self.depth.fill(0.0);
        self.pixels.fill([0; 3]);
        let [width, height] = self.size;
        let mut vertices = std::mem::take(&mut self.vertices);
        vertices.clear();
        vertices.extend(positions.iter().zip(normals).map(|(&position, &normal)| {
            let p = self.turn * (Vec3::from(position) - self.eye);
            let inverse = 1.0 / p.z;
            Vertex {
                x: width as f32 / 2.0 + p.x * inverse * self.scale,
                y: height as f32 / 2.0 - p.y * inverse * self.scale,
                inverse,
                colour: match self.mode {
                    Mode::Gouraud => self.light(position.into(), normal.into()),
                    _ => Vec3::ZERO,
                },
            }
        }));
        for (face, corners) in triangles.iter().enumerate() {
            let [a, b, c] = corners.map(|v| vertices[v as usize]);
            let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            if area >= 0.0 {
                continue;
            }
            let low = |a: f32, b: f32, c: f32| (a.min(b).min(c) - 0.5).ceil().max(0.0) as usize;
            let high = |a: f32, b: f32, c: f32, size: usize| {
                ((a.max(b).max(c) - 0.5).floor() + 1.0).clamp(0.0, size as f32) as usize
            };
            let [pa, pb, pc] = corners.map(|v| Vec3::from(positions[v as usize]));
            let flat = match self.mode {
                Mode::Flat => self.light((pa + pb + pc) / 3.0, faces[face].into()),
                _ => Vec3::ZERO,
            };
            let [na, nb, nc] = corners.map(|v| Vec3::from(normals[v as usize]));
            for y in low(a.y, b.y, c.y)..high(a.y, b.y, c.y, height) {
                for x in low(a.x, b.x, c.x)..high(a.x, b.x, c.x, width) {
                    let (px, py) = (x as f32 + 0.5, y as f32 + 0.5);
                    let edge = |p: Vertex, q: Vertex| (q.x - p.x) * (py - p.y) - (q.y - p.y) * (px - p.x);
                    let (ea, eb, ec) = (edge(b, c), edge(c, a), edge(a, b));
                    if ea > 0.0 || eb > 0.0 || ec > 0.0 {
                        continue;
                    }
                    let (wa, wb, wc) = (ea / area * a.inverse, eb / area * b.inverse, ec / area * c.inverse);
                    let inverse = wa + wb + wc;
                    let pixel = y * width + x;
                    if inverse <= self.depth[pixel] {
                        continue;
                    }
                    self.depth[pixel] = inverse;
                    let mix = |a: Vec3, b: Vec3, c: Vec3| (a * wa + b * wb + c * wc) / inverse;
                    let colour = match self.mode {
                        Mode::Flat => flat,
                        Mode::Gouraud => mix(a.colour, b.colour, c.colour),
                        Mode::Phong => self.light(mix(pa, pb, pc), mix(na, nb, nc)),
                    };
                    self.pixels[pixel] = colour.to_array().map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8);
                }
            }
        }
        self.vertices = vertices;
    }
}
