//! Normals in another space of the node tree than their positions: the node whose matrix applies twice or not at all is found.

use super::clean::meshes;
use super::grave;
use super::planted::{per_corner, unshared};
use crease::io::{Format, Part, ReadOptions, WriteOptions, read_bytes, write_new};
use crease::mesh::{Mesh, normal_matrix};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Thresholds, diagnose};
use glam::{DMat3, DMat4, DQuat, DVec3};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::ops::Range;

/// The names of nodes, from the root on.
const NAMES: [&str; 3] = ["body", "arm", "hand"];

fn rotation(axis: DVec3, degrees: f64) -> DMat4 {
    DMat4::from_quat(DQuat::from_axis_angle(axis.normalize(), degrees.to_radians()))
}

/// Matrices of nodes, from the root on: different nodes rotate, and some stretch as well.
fn chains() -> Vec<Vec<DMat4>> {
    let moved = DMat4::from_translation(DVec3::new(5.0, -1.0, 2.0)) * DMat4::from_scale(DVec3::splat(0.01));
    let body = rotation(DVec3::new(1.0, 0.2, 0.0), -90.0);
    let arm = rotation(DVec3::new(1.0, 2.0, 3.0), 35.0);
    let hand = rotation(DVec3::new(-2.0, 1.0, 0.5), 50.0);
    let stretch = DMat4::from_scale(DVec3::new(1.0, 2.5, 1.5));
    vec![
        vec![arm],
        vec![body, moved],
        vec![moved, hand],
        vec![body, moved, hand],
        vec![moved, arm * moved, moved],
        vec![body, arm, hand],
        vec![body, arm * stretch],
        vec![arm * stretch, hand],
        vec![moved, stretch * arm, hand * moved],
    ]
}

/// The mesh below nodes that follow one another, as a file.
fn below(mesh: &Mesh, chain: &[DMat4]) -> Diagnosis {
    let parts = [Part { mesh: mesh.clone(), ..Part::default() }];
    let written = write_new(&parts, Format::Gltf, &WriteOptions::default()).unwrap();
    let mut document: Value = serde_json::from_slice(&written.bytes).unwrap();
    let node = |(number, matrix): (usize, &DMat4)| {
        let mut node = json!({"name": NAMES[number], "matrix": matrix.to_cols_array().to_vec()});
        if number + 1 < chain.len() {
            node["children"] = json!([number + 1]);
        } else {
            node["mesh"] = json!(0);
        }
        node
    };
    document["nodes"] = chain.iter().enumerate().map(node).collect();
    document["scenes"] = json!([{"nodes": [0]}]);
    let bytes = document.to_string().into_bytes();
    let file = read_bytes(bytes, Some(Format::Gltf), None, &ReadOptions::default()).unwrap();
    diagnose(&file, &Thresholds::default(), &|_| {})
}

fn product<'a>(chain: impl IntoIterator<Item = &'a DMat4>) -> DMat3 {
    DMat3::from_mat4(chain.into_iter().fold(DMat4::IDENTITY, |above, matrix| above * matrix))
}

/// The mesh with stored normals that a viewer shows as if the matrix of the chain were `shown`.
fn shown_by(mesh: &Mesh, chain: &[DMat4], shown: DMat3) -> Mesh {
    let [there, back] = [shown, product(chain).inverse()].map(|map| normal_matrix(map).unwrap());
    let stored = |normal: DVec3| back.apply(there.apply(normal).unwrap()).unwrap();
    per_corner(mesh, unshared(mesh).into_iter().map(stored).collect())
}

/// Ranges of nodes whose matrices are not applied or applied twice, and the matrix that a viewer then shows.
fn mistakes(chain: &[DMat4]) -> Vec<(Range<usize>, &'static str, DMat3)> {
    let count = chain.len();
    let turns = |range: &Range<usize>| {
        let (_, turn, _) = DMat4::from_mat3(product(&chain[range.clone()])).to_scale_rotation_translation();
        turn.to_axis_angle().1 > 0.1
    };
    let mut ranges: Vec<Range<usize>> = (0..count).map(|at| at..at + 1).collect();
    ranges.extend((1..count).flat_map(|at| [0..at, at..count]));
    ranges.push(0..count);
    ranges.retain(turns);
    let of = |range: Range<usize>| {
        let (above, below) = (&chain[..range.start], &chain[range.end..]);
        let [once, twice] = [0, 2].map(|times| {
            product(
                above.iter().chain(std::iter::repeat_n(&chain[range.clone()], times).flatten()).chain(below),
            )
        });
        [(range.clone(), "undone", once), (range, "twice", twice)]
    };
    ranges.into_iter().flat_map(of).collect()
}

/// Whether the cause names the nodes of the range, without those that do not rotate.
fn names(cause: &str, chain: &[DMat4], range: &Range<usize>) -> bool {
    let is_turning = |&at: &usize| product(&chain[at..=at]).x_axis.normalize().dot(DVec3::X) < 0.999;
    let turning: Vec<usize> = range.clone().filter(is_turning).collect();
    let ends = [turning[0], turning[turning.len() - 1]].map(|at| format!("`{}`", NAMES[at]));
    let reported: Vec<&str> = cause.split('`').skip(1).step_by(2).collect();
    let expected: Vec<&str> = ends.iter().map(|name| name.trim_matches('`')).collect();
    if ends[0] == ends[1] { reported == expected[..1] } else { reported == expected }
}

#[test]
fn the_node_whose_matrix_is_missing_is_named() {
    let check = |(name, mesh, chain): &(&str, Mesh, Vec<DMat4>)| {
        let mut misses = Vec::new();
        let clean = below(mesh, chain);
        if clean.get(Kind::Untransformed).is_some() || clean.get(Kind::Rotated).is_some() {
            misses.push(format!("{name} is reported as rotated although it is not, below {chain:?}"));
        }
        for (range, what, shown) in mistakes(chain) {
            let found = below(&shown_by(mesh, chain, shown), chain);
            let cause = found.get(Kind::Untransformed).map_or("", |finding| finding.cause.english());
            let mut others = grave(&found);
            others.retain(|id| *id != Kind::Untransformed.id() && !grave(&clean).contains(id));
            if !cause.contains(what) || !names(cause, chain, &range) || !others.is_empty() {
                let deep = chain.len();
                misses.push(format!("{name}, {range:?} of {deep} {what}: {cause:?}, and {others:?}"));
            }
        }
        misses
    };
    let is_wanted = |name: &str| ["torus", "gear"].contains(&name);
    let wanted = meshes().into_iter().filter(|clean| is_wanted(clean.name));
    let all = wanted.flat_map(|it| chains().into_iter().map(move |chain| (it.name, it.mesh.clone(), chain)));
    let misses: Vec<String> = all.collect::<Vec<_>>().par_iter().flat_map(check).collect();
    assert!(misses.is_empty(), "{} misses:\n{}", misses.len(), misses.join("\n"));
}
