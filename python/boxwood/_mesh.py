# SPDX-License-Identifier: Apache-2.0
"""Triangle meshes, and files of them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core

Of = Literal["vertices", "faces", "corners"]


class MeshWarning(UserWarning):
    """A fault of a file that was tolerated."""


@dataclass(frozen=True)
class Attribute:
    """Values for each vertex, face or corner of a mesh. Corner k of face f has number 3 f + k.

    values: an array with one row, or number, for each.
    of: "vertices", "faces" or "corners".
    """

    values: NDArray[Any]
    of: Of = "vertices"


@dataclass(frozen=True)
class Labels:
    """Which of some names each face bears.

    names: the names.
    of_face: an index of `names` for each face.
    """

    names: list[str]
    of_face: NDArray[np.uint32]


class Mesh:
    """A triangle mesh.

    vertices: array (n, 3) of float32 or float64. It isn't copied if it is C-contiguous, so whoever
        changes it changes the mesh; call `Scene.refit` then.
    faces: array (m, 3) of integers, the indices of each triangle's corners. Its front is where they
        turn counter-clockwise. The mesh keeps a copy that can't be written to.

    Raises TypeError or ValueError for arrays of another kind or shape, and ValueError for an index
    that names no vertex.

    >>> import boxwood as bw
    >>> mesh = bw.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> mesh
    <boxwood.Mesh: 3 vertices, 1 face>
    """

    def __init__(self, vertices: ArrayLike, faces: ArrayLike) -> None:
        points = arguments.floats(vertices, "vertices")
        if points.size == 0 and points.ndim < 2:
            points = points.reshape(0, 3)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"vertices: found {arguments.describe(points)}, expected shape (n, 3)")
        corners = arguments.faces(faces)
        bad = np.flatnonzero((corners >= len(points)).any(axis=1))
        if bad.size:
            raise ValueError(
                f"faces: found {[int(i) for i in corners[bad[0]]]} in face {bad[0]}, "
                f"expected indices below {len(points)}, the number of vertices"
            )
        # Queries rely on the indices being in range, so nobody may write to them: numpy never lets
        # anybody write to bytes.
        own = np.ndarray(corners.shape, np.int32, corners.tobytes())
        self._take(np.ascontiguousarray(points), own)

    def _take(self, vertices: NDArray[Any], faces: NDArray[np.int32]) -> None:
        self._vertices = vertices
        self._faces = faces
        #: Normals (n, 3), texture coordinates (n, 2), v upwards, and colors (n, 4) of red, green,
        #: blue and alpha from 0 to 1: an Attribute, or None.
        self.normals: Attribute | None = None
        self.texture_coordinates: Attribute | None = None
        self.colors: Attribute | None = None
        #: Numbers by name, whatever was measured there: Attributes of values (n,).
        self.fields: dict[str, Attribute] = {}
        #: Which group, and which material, each face belongs to, or None.
        self.groups: Labels | None = None
        self.materials: Labels | None = None
        #: Files that define the materials, as the mesh's own file names them.
        self.material_files: list[str] = []

    @property
    def vertices(self) -> NDArray[Any]:
        """Array (n, 3) of float32 or float64."""
        return self._vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """Array (m, 3) of int32, read-only."""
        return self._faces

    def __repr__(self) -> str:
        def counted(count: int, one: str, many: str) -> str:
            return f"{count} {one if count == 1 else many}"

        return (
            f"<boxwood.Mesh: {counted(len(self._vertices), 'vertex', 'vertices')}, "
            f"{counted(len(self._faces), 'face', 'faces')}>"
        )

    @property
    def bounds(self) -> NDArray[np.float64]:
        """The least and the greatest coordinates, array (2, 3); of finite vertices alone.

        >>> import boxwood as bw
        >>> bw.generate("icosphere", 320).bounds.round(1).tolist()
        [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]
        """
        finite = self._vertices[np.isfinite(self._vertices).all(axis=1)]
        if len(finite) == 0:
            return np.array([[np.inf] * 3, [-np.inf] * 3])
        return np.array([finite.min(axis=0), finite.max(axis=0)], dtype=np.float64)

    def inspect(self) -> dict[str, Any]:
        """What there is to know of the mesh: counts of vertices, faces, components and faults, its
        bounds, area and, when it is closed, volume. O(n log n).

        >>> import boxwood as bw
        >>> report = bw.generate("torus_knot", 5000).inspect()
        >>> report["closed"], report["degenerate_faces"]
        (True, 0)
        """
        found: dict[str, Any] = self._data(geometry_only=True).inspect()
        return found

    def repaired(self, *steps: str) -> Mesh:
        """A repaired copy.

        steps: "weld" makes vertices of equal position one, "drop-degenerate" drops faces of no
            area, "orient" turns faces around so that neighbours agree; in this order, say.

        Raises ValueError for another step. O(n log n).

        >>> import boxwood as bw
        >>> soup = bw.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]] * 2, [[0, 1, 2], [5, 4, 3]])
        >>> soup.repaired("weld")
        <boxwood.Mesh: 3 vertices, 2 faces>
        """
        data = self._data()
        data.repair(_texts(steps, "steps"))
        return _of_data(data)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the mesh with all that belongs to it, in the format that the file's extension
        names: .obj, .ply, .stl, .off, .gltf or .glb. The file appears whole or not at all. PLY
        keeps fields, so it is the one for what queries have found:

        >>> import boxwood as bw, numpy as np, tempfile, pathlib
        >>> mesh = bw.generate("icosphere", 320)
        >>> mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
        >>> path = pathlib.Path(tempfile.mkdtemp()) / "sphere.ply"
        >>> mesh.save(path)
        >>> bool((bw.load(path).fields["height"].values == mesh.vertices[:, 2]).all())
        True

        Raises ValueError for an extension without a writer and for attributes that don't fit,
        OSError when the file can't be written.
        """
        self._data().write(arguments.path(path))

    def _data(self, geometry_only: bool = False) -> _core.MeshData:
        data = _core.MeshData(np.ascontiguousarray(self._vertices, dtype=np.float64), self._faces)
        if geometry_only:
            return data
        for name, columns in (("normals", 3), ("texture_coordinates", 2), ("colors", 4)):
            attribute = getattr(self, name)
            if attribute is None:
                continue
            _check_kind(attribute, name, Attribute)
            arguments.text(attribute.of, f"{name}.of")
            table = arguments.floats(attribute.values, name)
            if table.ndim != 2 or table.shape[1] != columns:
                raise ValueError(
                    f"{name}: found {arguments.describe(table)}, expected shape (n, {columns})"
                )
            data.set_attribute(name, attribute.of, np.ascontiguousarray(table, dtype=np.float32))
        _check_kind(self.fields, "fields", dict)
        for name, attribute in self.fields.items():
            arguments.text(name, "the name of a field")
            _check_kind(attribute, f"field {name}", Attribute)
            arguments.text(attribute.of, f"field {name}.of")
            values = arguments.array(attribute.values, f"field {name}")
            if values.ndim != 1 or values.dtype.kind not in "biuf":
                raise ValueError(
                    f"field {name}: found {arguments.describe(values)}, expected shape (n,)"
                )
            data.add_field(name, attribute.of, values.astype(np.float64))
        for kind in ("groups", "materials"):
            labels = getattr(self, kind)
            if labels is not None:
                _check_kind(labels, kind, Labels)
                of_face = arguments.uint32(labels.of_face, f"{kind}.of_face")
                if of_face.ndim != 1:
                    raise ValueError(
                        f"{kind}.of_face: found {arguments.describe(of_face)}, expected shape (m,)"
                    )
                data.set_labels(kind, _texts(labels.names, f"{kind}.names"), of_face)
        data.material_files = _texts(self.material_files, "material_files")
        data.check_attributes()
        return data

    def __reduce__(self) -> tuple[Any, ...]:
        attributes = {key: value for key, value in self.__dict__.items() if not key.startswith("_")}
        return Mesh, (np.array(self._vertices), np.array(self._faces)), attributes


def of_trusted_arrays(vertices: NDArray[Any], faces: NDArray[np.int32]) -> Mesh:
    """A mesh of arrays from the compiled part, without a copy or a check."""
    mesh = Mesh.__new__(Mesh)
    mesh._take(vertices, faces)
    return mesh


def _check_kind(value: object, name: str, kind: type) -> None:
    if not isinstance(value, kind):
        expected = "a dict" if kind is dict else f"a boxwood.{kind.__name__}"
        raise TypeError(f"{name}: found {arguments.describe(value)}, expected {expected}")


def _texts(values: Iterable[str], name: str) -> list[str]:
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise TypeError(f"{name}: found {arguments.describe(values)}, expected a list of str")
    return [arguments.text(value, name) for value in values]


def _of_data(data: _core.MeshData) -> Mesh:
    mesh = of_trusted_arrays(data.vertices, data.faces)
    for name, of, values in data.attributes():
        setattr(mesh, name, Attribute(values, of))
    for name, of, values in data.fields():
        mesh.fields[name] = Attribute(values, of)
    for kind, names, of_face in data.labels():
        setattr(mesh, kind, Labels(names, of_face))
    mesh.material_files = data.material_files
    return mesh


def warn(found: Iterable[tuple[str, int, list[str]]], stack_level: int = 3) -> None:
    """One Python warning for each kind of fault."""
    for kind, count, shown in found:
        warnings.warn(
            f"{kind}: {count}, such as {shown[0] if shown else '?'}",
            MeshWarning,
            stacklevel=stack_level,
        )


def load(path: str | os.PathLike[str], *, allow_outside_files: bool = False) -> Mesh:
    """Reads a mesh file: .obj, .ply, .stl, .off, .gltf or .glb, maybe with .gz behind it. Vertices
    come in double.

    allow_outside_files: whether the file may name others that lie outside its own folder.

    Raises OSError when the file can't be read, ParseError when it isn't what its extension says,
    with the place and what was found and expected. What could be tolerated is a MeshWarning.
    """
    data = _core.read_mesh(
        arguments.path(path), arguments.flag(allow_outside_files, "allow_outside_files")
    )
    warn(data.warnings())
    return _of_data(data)


def generate(shape: str, triangles: int) -> Mesh:
    """A mesh from a formula, of about so many triangles, within the cube from -1 to 1: "icosphere",
    "torus_knot", "gyroid", "terrain", "soup", "stadium" or "interior".

    >>> import boxwood as bw
    >>> bw.generate("icosphere", 1280)
    <boxwood.Mesh: 642 vertices, 1280 faces>
    """
    count = arguments.count(triangles, "triangles", 1, 700_000_000)
    return _of_data(_core.generate(arguments.text(shape, "shape"), count))
