"""The scene of torus.rs for the programs that crease is measured against: a torus that covers 40 % of 1920 × 1080 pixels."""

import math

import numpy as np

WIDTH, HEIGHT, ANGLE = 1920, 1080, 27.25
EYE = np.array([0.0, 3.2, 4.0])


def torus(triangles):
    """Positions and unit normals of shape (n, 3) in float32, and faces of shape (m, 3) in uint32."""
    around = int(math.sqrt(triangles))
    around += around % 2
    across = -(-(triangles // 2) // around)
    u, v = np.meshgrid(2 * np.pi * np.arange(around) / around, 2 * np.pi * np.arange(across) / across, indexing="ij")
    normal = np.stack([np.cos(v) * np.sin(u), np.sin(v), np.cos(v) * np.cos(u)], -1)
    ring = np.stack([np.sin(u), np.zeros_like(u), np.cos(u)], -1)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")

    def at(i, j):
        return (i % around) * across + j % across

    first = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], -1)
    second = np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], -1)
    faces = np.stack([first, second], -2).reshape(-1, 3)
    positions, normals = [rows.reshape(-1, 3).astype(np.float32) for rows in (ring + 0.4 * normal, normal)]
    return positions, normals, faces.astype(np.uint32)


def axes():
    """Right, up and forward of the camera, which looks at the origin."""
    forward = -EYE / np.linalg.norm(EYE)
    right = np.cross(forward, [0.0, 1.0, 0.0])
    right /= np.linalg.norm(right)
    return right, np.cross(right, forward), forward
