# SPDX-License-Identifier: Apache-2.0
"""Rays as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core

_ALL = 0xFFFFFFFF


@dataclass(frozen=True)
class Rays:
    """What a query asks with: the compiled form of the rays, and what their answers look like."""

    shape: tuple[int, ...]
    dtype: type[np.floating[Any]]
    core: Any

    @property
    def size(self) -> int:
        return int(np.prod(self.shape, dtype=np.int64))


def rays(
    origins: ArrayLike,
    directions: ArrayLike,
    t_min: ArrayLike,
    t_max: ArrayLike,
    skip_triangle: ArrayLike | None,
    skip_instance: ArrayLike | None,
    visibility: ArrayLike | None,
    *,
    in_double: bool = False,
) -> Rays:
    """Broadcasts the arguments over each other. Rays are in float if origins and directions are."""
    starts = arguments.vectors(origins, "origins")
    along = arguments.vectors(directions, "directions")
    try:
        shape = np.broadcast_shapes(starts.shape, along.shape)
    except ValueError:
        raise ValueError(
            f"origins and directions: found shapes {starts.shape} and {along.shape}, "
            "expected ones that broadcast"
        ) from None
    items = shape[:-1]
    given = np.float32 if starts.dtype == along.dtype == np.float32 else np.float64
    # Only rays in double know what to skip.
    plain = skip_triangle is None and skip_instance is None and visibility is None
    dtype = given if plain and not in_double else np.float64

    def rows(values: NDArray[Any]) -> NDArray[Any]:
        found = np.broadcast_to(values.astype(dtype, copy=False), shape).reshape(-1, 3)
        return found if found.strides[-1] == found.itemsize else np.ascontiguousarray(found)

    common = (
        rows(starts),
        rows(along),
        arguments.per_item(t_min, "t_min", items, dtype),
        arguments.per_item(t_max, "t_max", items, dtype),
    )
    if dtype == np.float32:
        return Rays(items, given, _core.Raysf(*common))

    def index(value: ArrayLike | None, name: str, default: int) -> NDArray[Any]:
        whole = np.int32(default) if value is None else arguments.int32(value, name, -1)
        return arguments.per_item(whole, name, items, np.int32)

    mask = np.uint32(_ALL) if visibility is None else arguments.uint32(visibility, "visibility")
    core = _core.Rays(
        *common,
        index(skip_instance, "skip_instance", 0),
        index(skip_triangle, "skip_triangle", -1),
        arguments.per_item(mask, "visibility", items, np.uint32),
    )
    return Rays(items, given, core)
