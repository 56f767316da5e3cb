"""Normals compared with those of other packages. A test is skipped if its package is missing."""

import numpy as np
import pytest
from conftest import cube, degrees_between, grid, triangulated

import crease_normals as crease


def used(vertices, faces):
    """Rows of vertices that a face uses."""
    return np.unique(np.asarray(faces))


def clean(vertices, faces):
    """Without faces of tiny area: other packages give them zero or undefined normals."""
    corners = vertices[faces].astype(np.float64)
    sides = corners - np.roll(corners, 1, axis=1)
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    return faces[area > 1e-5 * longest**2]


def meshes(all_parts):
    yield "grid", *grid(40)
    for name, part in all_parts.items():
        vertices = part.vertices.astype(np.float64)
        faces = clean(vertices, triangulated(part.faces))
        if len(faces):
            yield name, vertices, faces


def worst_angle(ours, theirs, vertices, faces, faults):
    """Largest angle at vertices whose sum does not nearly cancel and whose normal both packages define."""
    rows = np.setdiff1d(used(vertices, faces), faults["index"][faults["element"] == "vertex"])
    lengths = np.linalg.norm(theirs[rows], axis=1)
    rows = rows[np.isfinite(lengths) & (lengths > 0.5)]
    return degrees_between(ours[rows], theirs[rows]) if len(rows) else np.zeros(1)


@pytest.mark.parametrize("weight", ["uniform", "area", "angle"])
def test_igl_per_vertex_normals(all_parts, weight):
    igl = pytest.importorskip("igl")
    kinds = {
        "uniform": igl.PER_VERTEX_NORMALS_WEIGHTING_TYPE_UNIFORM,
        "area": igl.PER_VERTEX_NORMALS_WEIGHTING_TYPE_AREA,
        "angle": igl.PER_VERTEX_NORMALS_WEIGHTING_TYPE_ANGLE,
    }
    count = 0
    for name, vertices, faces in meshes(all_parts):
        ours, faults = crease.vertex_normals(vertices, faces, weight=weight, return_faults=True)
        theirs = igl.per_vertex_normals(vertices, faces.astype(np.int64), weighting=kinds[weight])
        angles = worst_angle(ours, theirs, vertices, faces, faults)
        # The mean of normals that nearly cancel has no precise direction in either package.
        assert np.percentile(angles, 99) < 1e-5 and angles.max() < 0.1, (name, angles.max())
        count += 1
    assert count > 5


def test_trimesh_vertex_normals(all_parts):
    trimesh = pytest.importorskip("trimesh")
    count = 0
    for name, vertices, faces in meshes(all_parts):
        mesh = trimesh.Trimesh(vertices, faces, process=False)
        theirs = trimesh.geometry.weighted_vertex_normals(
            len(vertices), mesh.faces, mesh.face_normals, mesh.face_angles
        )
        ours, faults = crease.vertex_normals(mesh.vertices, mesh.faces, weight="angle", return_faults=True)
        angles = worst_angle(ours, theirs, vertices, faces, faults)
        assert np.percentile(angles, 99) < 1e-5 and angles.max() < 0.1, (name, angles.max())
        count += 1
    assert count > 5


def vtk_mesh(vertices, faces):
    pyvista = pytest.importorskip("pyvista")
    return pyvista.PolyData.from_regular_faces(vertices, faces)


def vtk_split(mesh, degrees):
    return mesh.compute_normals(
        cell_normals=False,
        point_normals=True,
        split_vertices=True,
        feature_angle=degrees,
        consistent_normals=False,
        non_manifold_traversal=False,
    )


def test_vtk_splits_at_30_degrees(all_parts):
    """The same normals in the same number at each position, if no edge is within 1° of 30°. VTK averages without weights."""
    pytest.importorskip("vtk")
    count = 0
    for name, vertices, faces in meshes(all_parts):
        if not is_plain(vertices, faces, 30):
            continue
        vertices = vertices.astype(np.float64)
        theirs = vtk_split(vtk_mesh(vertices, faces), 30)
        ours = crease.split(vertices, faces, crease=30, weight="uniform")
        # `regular_faces` refers to freed memory in PyVista 0.46.
        new_faces = theirs.faces.reshape(-1, 4)[:, 1:]
        assert len(new_faces) == len(faces), name
        corners = np.asarray(theirs.point_data["Normals"])[new_faces].reshape(-1, 3)
        angles = degrees_between(ours[2][ours[1]].reshape(-1, 3), corners)
        # VTK stores normals in single precision.
        assert angles.max() < 0.01, (name, angles.max())
        assert len(ours[0]) == len(np.unique(new_faces)), name
        count += 1
    assert count >= 3, "too few meshes are without edges near 30°"


def is_plain(vertices, faces, degrees):
    """Closed or open manifold of consistent winding, without angles near the crease angle, and without fans that touch in a vertex."""
    edges = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    owners = np.repeat(np.arange(len(faces)), 3)
    order = {}
    for (a, b), face in zip(edges.tolist(), owners.tolist()):
        if (a, b) in order:
            return False
        order[a, b] = face
    normals = crease.face_normals(vertices, faces)
    pairs = np.array([(face, order[b, a]) for (a, b), face in order.items() if (b, a) in order], dtype=int).reshape(-1, 2)
    if len(pairs) and (np.abs(degrees_between(normals[pairs[:, 0]], normals[pairs[:, 1]]) - degrees) < 1).any():
        return False
    # Each vertex with a boundary has one incoming and one outgoing boundary edge.
    ends = np.array([a for a, b in order if (b, a) not in order], dtype=int)
    return len(np.unique(ends)) == len(ends)


class TestOneLiners:
    """The table of docs/python.md: what other packages hand over is taken without conversion by the caller."""

    def same(self, normals, vertices, faces):
        expected = crease.vertex_normals(np.asarray(vertices, dtype=np.float64), faces)
        assert degrees_between(normals, expected).max() < 1e-3

    def test_trimesh(self):
        trimesh = pytest.importorskip("trimesh")
        vertices, faces = grid(8)
        mesh = trimesh.Trimesh(vertices, faces, process=False)
        mesh.vertex_normals = crease.vertex_normals(mesh.vertices, mesh.faces)
        self.same(mesh.vertex_normals, vertices, faces)

    def test_open3d(self):
        o3d = pytest.importorskip("open3d")
        vertices, faces = grid(8)
        mesh = o3d.geometry.TriangleMesh(
            o3d.utility.Vector3dVector(vertices), o3d.utility.Vector3iVector(faces.astype(np.int32))
        )
        mesh.vertex_normals = o3d.utility.Vector3dVector(crease.vertex_normals(mesh.vertices, mesh.triangles))
        self.same(np.asarray(mesh.vertex_normals), vertices, faces)

    def test_pyvista(self):
        pyvista = pytest.importorskip("pyvista")
        vertices, faces = grid(8)
        mesh = pyvista.PolyData.from_regular_faces(vertices, faces)
        mesh.point_data["Normals"] = crease.vertex_normals(mesh.points, mesh.regular_faces)
        self.same(mesh.point_data["Normals"], vertices, faces)

    def test_pyvista_polygons(self):
        pytest.importorskip("pyvista")
        import pyvista

        vertices, (indices, offsets) = cube()
        mesh = pyvista.PolyData.from_irregular_faces(vertices, [indices[a:b] for a, b in zip(offsets, offsets[1:])])
        cells = mesh.GetPolys()
        faces = pyvista.convert_array(cells.GetConnectivityArray()), pyvista.convert_array(cells.GetOffsetsArray())
        mesh.point_data["Normals"] = crease.vertex_normals(mesh.points, faces)
        self.same(mesh.point_data["Normals"], vertices, (indices, offsets))

    def test_igl(self):
        igl = pytest.importorskip("igl")
        vertices, faces = igl.icosahedron() if hasattr(igl, "icosahedron") else grid(8)
        self.same(crease.vertex_normals(vertices, faces), vertices, faces)

    def test_blender_arrays(self):
        """Blender fills flat arrays: positions, the vertices of loops, and where each polygon starts."""
        vertices, (indices, offsets) = cube()
        co, vertex_index = vertices.astype(np.float32).ravel(), indices.astype(np.int32)
        loop_start = offsets[:-1].astype(np.int32)
        faces = (vertex_index, np.append(loop_start, len(vertex_index)))
        normals, index = crease.corner_normals(co.reshape(-1, 3), faces, crease=40)
        assert normals[index].shape == (len(vertex_index), 3) and len(normals) == 24
