"""Diagnosis of a file."""

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Union

from . import _native


@dataclass(frozen=True)
class Finding:
    """Something that is wrong with a file, or a note about it.

    The fields are the members of `findings` in the JSON of `crease inspect`, which docs/json.md describes.
    """

    id: str
    """The kind; `crease inspect --explain ID` describes it."""
    severity: str
    """"error", "warning" or "note"."""
    family: str
    cause: str
    """The cause in words, with the numbers of this file."""
    element: str
    """What is counted: "face", "corner", "vertex" and others."""
    count: int
    of: int
    share: float
    """count / of."""
    area_share: Optional[float]
    """Share of the surface's area, from 0 to 1."""
    degrees: Optional[float]
    """Largest angle, in degrees."""
    steps: Optional[float]
    """Largest change of the grey value under a key light, in steps of 1/255."""
    measure: Optional[Dict[str, Any]]
    """value and unit at the worst position."""
    confidence: Optional[float]
    command: Optional[str]
    """A command that fixes it."""
    places: List[Dict[str, Any]]
    """The worst positions, worst first."""


@dataclass(frozen=True)
class Report:
    """The diagnosis of a file."""

    findings: List[Finding]
    """The worst first."""
    verdict: Optional[str]
    """The highest severity: "error", "warning", "note", or None without findings."""
    fix: Optional[str]
    """One command that fixes what can be fixed together."""
    json: Dict[str, Any]
    """The whole report, as `crease inspect --json` prints it, without times."""


def inspect(path: Union[str, "os.PathLike[str]"], *, threads: Optional[int] = None, **options: Any) -> Report:
    """Finds what is wrong with a mesh file and its normals.

    Parameters
    ----------
    path : str or path
        OBJ, PLY, STL, glTF, GLB or 3MF.
    threads : int, optional
        Maximum number of threads; default: one for each processor.
    **options
        The options of `crease inspect`, with underscores: severity="warning", only=("flipped-normals",), ignore, places=10, format,
        and the thresholds. `python -m crease_normals inspect --help` describes them.

    Returns
    -------
    Report

    Raises
    ------
    ReadError
        The file cannot be read. Its attributes have the path and the line or the byte offset.
    ValueError
        An unknown option or value.
    """
    report = json.loads(_native.inspect(path, threads, options))
    del report["seconds"]
    fix = report["fix"]
    return Report(
        findings=[Finding(**finding) for finding in report["findings"]],
        verdict=report["verdict"],
        fix=fix and fix["command"],
        json=report,
    )
