# SPDX-License-Identifier: Apache-2.0
"""What the adapters to other libraries have in common."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._mesh import Attribute, Mesh, Of
from ._scene import Scene


def sign_method(scene: Scene) -> str:
    """How the inside is told where the caller doesn't say: by what rays cross, as other libraries
    do, but by winding numbers where there are holes."""
    return "ray_parity" if scene.is_sign_trustworthy("ray_parity") else "winding_number"


def add_fields(mesh: Mesh, of: Of, arrays: Mapping[str, Any]) -> None:
    """Takes over what has one number for each vertex or face. A field of faces gets another name
    where vertices have one of the same."""
    for name, given in arrays.items():
        values = np.asarray(given)
        if values.ndim == 1 and values.dtype.kind in "biuf":
            mesh.fields[f"{name} of {of}" if name in mesh.fields else name] = Attribute(values, of)


def fields_of(mesh: Mesh, of: Of) -> dict[str, NDArray[Any]]:
    """The values of a mesh's fields by name."""
    return {name: np.asarray(field.values) for name, field in mesh.fields.items() if field.of == of}


def colors_from_bytes(colors: NDArray[Any], of: Of) -> Attribute:
    """Colors (n, 3 or 4), in uint8 or from 0 to 1, as those of a Mesh."""
    given = np.asarray(colors)
    table = given / 255 if given.dtype == np.uint8 else given.astype(np.float64)
    rgba = np.ones((len(table), 4))
    rgba[:, : table.shape[1]] = table
    return Attribute(rgba, of)


def colors_to_bytes(colors: Attribute) -> NDArray[np.uint8]:
    """Colors (n, 4) of a Mesh in uint8."""
    return np.asarray(np.clip(np.asarray(colors.values) * 255 + 0.5, 0, 255).astype(np.uint8))
