"""Speed of Mesa's software rasterizer llvmpipe on the torus of raster.rs.

    python3 -m venv venv && venv/bin/pip install moderngl numpy && venv/bin/python benches/llvmpipe.py [ROUNDS] [TRIANGLES]...

Needs Mesa's EGL driver (Debian: libegl-mesa0 libgl1-mesa-dri). The same camera, light and material as the Rust bench: buffers stay in
memory, back faces are culled, and a picture is drawn into 8 bits a component with a depth buffer. Flat shading lights one corner of a
triangle.
"""

import math
import os
import statistics
import subprocess
import sys
import time

import numpy as np

from torus import ANGLE, EYE, HEIGHT, WIDTH, axes, torus

LIGHT = """
uniform vec3 eye;
vec3 light(vec3 position, vec3 normal) {
    vec3 n = normalize(normal), l = normalize(vec3(0.4, 0.6, 1.0));
    float cosine = dot(n, l);
    if (cosine <= 0.0) return vec3(0.0);
    vec3 h = normalize(l + normalize(eye - position));
    return vec3(0.8) * cosine + vec3(0.2) * pow(max(dot(n, h), 0.0), 32.0);
}
"""

VERTEX = """
#version 330
uniform mat4 camera;
in vec3 at;
in vec3 n;
QUALIFIER out vec3 a;
out vec3 b;
LIGHT
void main() {
    gl_Position = camera * vec4(at, 1.0);
    CORNER
}
"""

FRAGMENT = """
#version 330
QUALIFIER in vec3 a;
in vec3 b;
out vec4 colour;
LIGHT
void main() { colour = vec4(PIXEL, 1.0); }
"""

SHADINGS = {
    "flat": ("flat", "a = light(at, n); b = vec3(0.0);", "a"),
    "Gouraud": ("smooth", "a = light(at, n); b = vec3(0.0);", "a"),
    "Phong": ("smooth", "a = at; b = n;", "light(a, b)"),
}


def camera():
    right, up, forward = axes()
    view = np.eye(4)
    view[:3, :3] = [right, up, -forward]
    view[:3, 3] = -view[:3, :3] @ EYE
    near, far = 0.1, 100.0
    f = 1.0 / math.tan(math.radians(ANGLE) / 2)
    project = np.zeros((4, 4))
    project[0, 0], project[1, 1] = f * HEIGHT / WIDTH, f
    project[2, 2:] = [(far + near) / (near - far), 2 * far * near / (near - far)]
    project[3, 2] = -1.0
    return (project @ view).T.astype("f4").tobytes()


def measure(rounds, sizes):
    import moderngl

    context = moderngl.create_context(standalone=True, backend="egl")
    if "llvmpipe" not in context.info["GL_RENDERER"]:
        sys.exit(f"error: the driver is {context.info['GL_RENDERER']}, not llvmpipe")
    target = context.framebuffer([context.renderbuffer((WIDTH, HEIGHT))], context.depth_renderbuffer((WIDTH, HEIGHT)))
    target.use()
    context.enable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
    for size in sizes:
        positions, normals, faces = torus(size)
        vertices = np.concatenate([positions, normals], -1)
        buffers = context.buffer(vertices.tobytes()), context.buffer(faces.tobytes())
        for name, (qualifier, corner, pixel) in SHADINGS.items():
            texts = [VERTEX, FRAGMENT]
            for key, text in {"QUALIFIER": qualifier, "LIGHT": LIGHT, "CORNER": corner, "PIXEL": pixel}.items():
                texts = [source.replace(key, text) for source in texts]
            program = context.program(vertex_shader=texts[0].strip(), fragment_shader=texts[1].strip())
            program["camera"].write(camera())
            if "eye" in program:
                program["eye"].value = tuple(EYE)
            names = ["at", "n"]
            mesh = context.vertex_array(program, [(buffers[0], "3f 3f", *names)], buffers[1], index_element_size=4)
            times = []
            for _ in range(rounds + 2):
                start = time.perf_counter()
                context.clear(0.0, 0.0, 0.0)
                mesh.render()
                context.finish()
                times.append(time.perf_counter() - start)
            pixels = np.frombuffer(target.read(components=3), "u1").reshape(-1, 3)
            covered = 100.0 * (pixels.max(1) > 0).mean()
            threads = os.environ["LP_NUM_THREADS"]
            print(f"| {len(faces)} | {name} | {threads} | {1e3 * statistics.median(times[2:]):.1f} | {covered:.1f} % |", flush=True)


if __name__ == "__main__":
    numbers = [int(argument.replace("_", "")) for argument in sys.argv[1:]] or [9]
    rounds, sizes = max(numbers[0], 5), numbers[1:] or [70_000, 1_000_000]
    if "LP_NUM_THREADS" in os.environ:
        measure(rounds, sizes)
    else:
        print("| triangles | shading | threads | ms | lit pixels |\n|---|---|---:|---:|---:|", flush=True)
        for threads in ["1", "2"]:
            environment = {**os.environ, "LP_NUM_THREADS": threads, "GALLIUM_DRIVER": "llvmpipe"}
            environment["LIBGL_ALWAYS_SOFTWARE"] = "1"
            subprocess.run([sys.executable, __file__, *sys.argv[1:]], env=environment, check=True)
