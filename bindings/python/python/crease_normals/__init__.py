"""Mesh normals on NumPy arrays and on files.

Arrays: vertex_normals, face_normals, corner_normals, split.
Files: read (then Mesh.normals and Mesh.write), inspect, render, plan.
The program `crease`: python -m crease_normals.

The conventions are those of the program: right-handed, y up, counter-clockwise front faces, angles in degrees.
"""

from ._native import (
    Mesh,
    Part,
    ReadError,
    WriteError,
    __VERSION__ as __version__,
    corner_normals,
    face_normals,
    read,
    render,
    split,
    vertex_normals,
)
from ._plan import Plan, plan
from ._report import Finding, Report, inspect

__all__ = [
    "Finding",
    "Mesh",
    "Part",
    "Plan",
    "ReadError",
    "Report",
    "WriteError",
    "__version__",
    "corner_normals",
    "face_normals",
    "inspect",
    "plan",
    "read",
    "render",
    "split",
    "vertex_normals",
]
