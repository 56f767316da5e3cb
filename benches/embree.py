"""Speed of Embree, through Open3D's RaycastingScene, on the torus of trace.rs.

    python3 -m venv venv && venv/bin/pip install open3d && venv/bin/python benches/embree.py [ROUNDS] [TRIANGLES]...
"""

import math
import statistics
import sys
import time

import numpy as np
import open3d as o3d

from torus import ANGLE, EYE, HEIGHT, WIDTH, axes, torus


def rays():
    right, up, forward = axes()
    scale = 0.5 * HEIGHT / math.tan(math.radians(ANGLE) / 2)
    # In tiles of 8 × 8 pixels, in which Embree finds neighbours together.
    x = (np.arange(WIDTH) + 0.5 - WIDTH / 2) / scale
    y = (np.arange(HEIGHT) + 0.5 - HEIGHT / 2) / scale
    directions = forward + x[None, :, None] * right - y[:, None, None] * up
    directions = directions.reshape(HEIGHT // 8, 8, WIDTH // 8, 8, 3).swapaxes(1, 2).reshape(-1, 3)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return np.concatenate([np.broadcast_to(EYE, directions.shape), directions], 1).astype(np.float32)


def main():
    numbers = [int(argument.replace("_", "")) for argument in sys.argv[1:]]
    rounds, sizes = (numbers[0] if numbers else 5), (numbers[1:] or [70_000, 1_000_000])
    batch = o3d.core.Tensor(rays())
    print("| triangles | tree ms | first hits ms | Mrays/s | covered |")
    print("|---|---:|---:|---:|---:|")
    for size in sizes:
        positions, _, faces = torus(size)
        builds, casts = [], []
        for _ in range(rounds):
            scene = o3d.t.geometry.RaycastingScene(nthreads=2)
            start = time.perf_counter()
            scene.add_triangles(o3d.core.Tensor(positions), o3d.core.Tensor(faces))
            # The tree is built with the first rays.
            scene.cast_rays(batch[:1], nthreads=2)
            builds.append(time.perf_counter() - start)
            start = time.perf_counter()
            found = scene.cast_rays(batch, nthreads=2)
            casts.append(time.perf_counter() - start)
        covered = np.isfinite(found["t_hit"].numpy()).mean()
        build, cast = statistics.median(builds), statistics.median(casts)
        rate = WIDTH * HEIGHT / cast / 1e6
        print(f"| {len(faces)} | {build * 1e3:.0f} | {cast * 1e3:.0f} | {rate:.1f} | {100 * covered:.1f} % |")


main()
