# SPDX-License-Identifier: Apache-2.0
"""What queries answer."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating[Any]]


class _Shown:
    """Says what is in it, without the numbers."""

    def __repr__(self) -> str:
        members = ", ".join(
            f"{field.name} {getattr(self, field.name).shape}"
            for field in fields(self)  # type: ignore[arg-type]
        )
        return f"<boxwood.{type(self).__name__}: {members}>"


class _OfRays(_Shown):
    """Hits that may be missing."""

    triangle: NDArray[np.int32]

    @property
    def hit(self) -> NDArray[np.bool_]:
        """Whether there is a hit, in the shape of `triangle`."""
        return np.asarray(self.triangle >= 0)


class _Lists(_Shown):
    """Lists, one after another."""

    offsets: NDArray[np.int64]

    @property
    def counts(self) -> NDArray[np.int64]:
        """(n) how many there are in each list."""
        return np.diff(self.offsets)


@dataclass(frozen=True, repr=False, eq=False)
class Hits(_OfRays):
    """Where rays meet the scene, as arrays of the shape (...) that the rays have.

    t: (...) distance along the ray, in lengths of its direction; inf for a miss.
    triangle: (...) int32, the face index in its mesh; -1 for a miss.
    instance: (...) int32, the place in the scene's instances; -1 for a miss.
    uv: (..., 2) the point is (1 - u - v) a + u b + v c on the triangle (a, b, c).
    normal: (..., 3) of the triangle, of unit length, on the side of its front; zero for a miss.
    """

    t: Floats
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
    uv: Floats
    normal: Floats


@dataclass(frozen=True, repr=False, eq=False)
class FirstHits(_OfRays):
    """The first k hits of each ray, as arrays of shape (..., k); inf and -1 where there are fewer.
    Members are those of Hits."""

    t: NDArray[np.float64]
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
    uv: NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class HitLists(_Lists):
    """All hits of rays, one list after another: those of ray i stand from offsets[i] to
    offsets[i + 1] in the other arrays. Rays of more dimensions count in the order of C.

    offsets: (n + 1) int64.
    t, triangle, instance, uv: as in Hits, one for each hit.
    """

    offsets: NDArray[np.int64]
    t: NDArray[np.float64]
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
    uv: NDArray[np.float64]

    @property
    def ray(self) -> NDArray[np.int64]:
        """(hits) the ray of each hit."""
        return np.repeat(np.arange(len(self.offsets) - 1), self.counts)

    def of_ray(self, i: int) -> slice:
        """Where the hits of a ray stand in the other arrays."""
        return slice(int(self.offsets[i]), int(self.offsets[i + 1]))


@dataclass(frozen=True, repr=False, eq=False)
class ClosestPoints(_Shown):
    """The places on the scene that are nearest to points, as arrays of their shape (...).

    distance: (...) inf where nothing is within the radius.
    point: (..., 3) the place; zero where there is none.
    triangle, instance: (...) int32; -1 where there is none.
    uv: (..., 2) as in Hits.
    """

    distance: NDArray[np.float64]
    point: NDArray[np.float64]
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
    uv: NDArray[np.float64]

    @property
    def found(self) -> NDArray[np.bool_]:
        """(...) whether there is one."""
        return np.asarray(self.triangle >= 0)


@dataclass(frozen=True, repr=False, eq=False)
class SignedDistances(_Shown):
    """Distances that are negative inside, with what ClosestPoints has.

    distance: (...) inf where nothing is within the radius.
    is_undefined: (...) whether the sign is a guess, as the mesh isn't closed or its triangles don't
        face the same way.
    """

    distance: NDArray[np.float64]
    is_undefined: NDArray[np.bool_]
    point: NDArray[np.float64]
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
    uv: NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class TriangleLists(_Lists):
    """The triangles that touch each of some shapes, one list after another: those of shape i stand
    from offsets[i] to offsets[i + 1] in the other arrays.

    offsets: (n + 1) int64.
    triangle, instance: int32, one for each triangle found.
    """

    offsets: NDArray[np.int64]
    triangle: NDArray[np.int32]
    instance: NDArray[np.int32]
