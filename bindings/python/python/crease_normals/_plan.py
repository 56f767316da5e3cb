"""The cheapest model that a scene requires."""

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Union

from . import _native


@dataclass(frozen=True)
class Plan:
    """The cheapest model of a scene within a tolerance."""

    text: str
    """The planned scene file (TOML). Its meshes are named relative to the folder of the scene."""
    decisions: List[Dict[str, Any]]
    """What changes: what, axis, from, to, saved, bound, measured and more."""
    declared: Dict[str, Any]
    """The cost as declared: work, bytes, vertices."""
    planned: Dict[str, Any]
    """The cost as planned."""
    json: Dict[str, Any]
    """All numbers, as in the member `plan` of `crease plan --json`."""


def plan(path: Union[str, "os.PathLike[str]"], *, threads: Optional[int] = None, **options: Any) -> Plan:
    """Finds the cheapest shading, normals, storage and lights whose pictures stay within a tolerance.

    Parameters
    ----------
    path : str or path
        A scene in TOML, or a mesh file.
    threads : int, optional
        Maximum number of threads; default: one for each processor.
    **options
        The options of `crease plan`, with underscores: tolerance=2 (steps of 1/255), metric="flip", views=8, size=(320, 240),
        light_cone=10 (degrees), keep=("lights",), minimise="bytes", budget, seconds.
        `python -m crease_normals plan --help` describes them.

    Returns
    -------
    Plan

    Raises
    ------
    ReadError
        The scene cannot be read or drawn.
    ValueError
        An unknown option or value.
    """
    text, report = _native.plan(path, threads, options)
    report = json.loads(report)
    return Plan(
        text=text,
        decisions=report["decisions"],
        declared=report["declared"],
        planned=report["planned"],
        json=report,
    )
