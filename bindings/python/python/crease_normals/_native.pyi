import os
from pathlib import Path
from typing import Any, Dict, List, Literal, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__VERSION__: str

_Path = Union[str, "os.PathLike[str]"]
_Format = Literal["obj", "ply", "stl", "gltf", "glb"]
_Weight = Literal["uniform", "area", "angle", "angle-area", "max", "edge", "quadric", "jet", "best"]
_Slivers = Literal["exclude", "keep"]
_Precision = Literal["faithful", "fast"]
_Weld = Union[Literal["off", "exact"], float]
_Faces = Union[ArrayLike, Tuple[ArrayLike, ArrayLike]]
_Floats = NDArray[np.floating[Any]]
_Indices = NDArray[np.uint32]
_Faults = NDArray[np.void]

class ReadError(ValueError):
    path: Path
    line: Optional[int]
    offset: Optional[int]
    pointer: Optional[str]
    help: str

class WriteError(OSError): ...

@overload
def vertex_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    out: Optional[_Floats] = None,
    return_faults: Literal[False] = False,
) -> _Floats: ...
@overload
def vertex_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    out: Optional[_Floats] = None,
    return_faults: Literal[True],
) -> Tuple[_Floats, _Faults]: ...
@overload
def face_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    threads: Optional[int] = None,
    out: Optional[_Floats] = None,
    return_faults: Literal[False] = False,
) -> _Floats: ...
@overload
def face_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    threads: Optional[int] = None,
    out: Optional[_Floats] = None,
    return_faults: Literal[True],
) -> Tuple[_Floats, _Faults]: ...
@overload
def corner_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    crease: Optional[float] = 40,
    weld: _Weld = "off",
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    return_faults: Literal[False] = False,
) -> Tuple[_Floats, _Indices]: ...
@overload
def corner_normals(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    crease: Optional[float] = 40,
    weld: _Weld = "off",
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    return_faults: Literal[True],
) -> Tuple[_Floats, _Indices, _Faults]: ...
@overload
def split(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    crease: Optional[float] = 40,
    weld: _Weld = "off",
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    return_faults: Literal[False] = False,
) -> Tuple[_Floats, Any, _Floats, _Indices]: ...
@overload
def split(
    vertices: ArrayLike,
    faces: _Faces,
    *,
    crease: Optional[float] = 40,
    weld: _Weld = "off",
    weight: _Weight = "angle",
    slivers: _Slivers = "exclude",
    precision: _Precision = "faithful",
    threads: Optional[int] = None,
    return_faults: Literal[True],
) -> Tuple[_Floats, Any, _Floats, _Indices, _Faults]: ...

class Part:
    @property
    def name(self) -> str: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def faces(self) -> Union[_Indices, Tuple[_Indices, _Indices]]: ...
    @property
    def normals(self) -> Optional[Tuple[NDArray[np.float64], _Indices]]: ...

class Mesh:
    @property
    def path(self) -> "os.PathLike[str]": ...
    @property
    def format(self) -> _Format: ...
    @property
    def notes(self) -> List[str]: ...
    @property
    def parts(self) -> List[Part]: ...
    def normals(self, *, threads: Optional[int] = None, **options: Any) -> List[Dict[str, Any]]: ...
    def write(
        self,
        path: _Path,
        *,
        format: Optional[_Format] = None,
        sync: bool = False,
        threads: Optional[int] = None,
    ) -> List[str]: ...

def read(
    path: _Path,
    *,
    format: Optional[_Format] = None,
    root: Optional[_Path] = None,
    allow_extension: Sequence[str] = (),
    force: bool = False,
    threads: Optional[int] = None,
) -> Mesh: ...
def render(
    path: _Path,
    *,
    size: Optional[Tuple[int, int]] = None,
    shading: Optional[str] = None,
    threads: Optional[int] = None,
    **options: Any,
) -> NDArray[np.uint8]: ...
def inspect(path: _Path, threads: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> str: ...
def plan(path: _Path, threads: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> Tuple[str, str]: ...
def check_batch(jobs: List[Tuple[str, _Path, _Path, List[str]]], options: List[str]) -> None: ...
def program(words: List[str]) -> int: ...
