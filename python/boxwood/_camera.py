# SPDX-License-Identifier: Apache-2.0
"""Cameras, which make arrays of rays."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core
from ._studio import studio

_MOST = 2**15


def _size(width: int, height: int) -> tuple[int, int]:
    return (
        arguments.count(width, "width", 1, _MOST),
        arguments.count(height, "height", 1, _MOST),
    )


class _Camera:
    """What looks from a place at another through a film of pixels."""

    def __init__(
        self,
        position: ArrayLike,
        target: ArrayLike,
        up: ArrayLike,
        width: int,
        height: int,
        *,
        is_perspective: bool,
        field_of_view: float = 1.0,
        view_height: float = 1.0,
    ) -> None:
        self.position = arguments.vector(position, "position")
        self.target = arguments.vector(target, "target")
        self.up = arguments.vector(up, "up")
        if not np.cross(self.target - self.position, self.up).any():
            raise ValueError(
                f"target and up: found a view along {(self.target - self.position).tolist()} and "
                f"up {self.up.tolist()}, expected directions that differ"
            )
        self.width, self.height = _size(width, height)
        self._core = _core.Camera(
            self.position, self.target, self.up, is_perspective, field_of_view, view_height
        )

    def _rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        origins = np.empty((self.width * self.height, 3))
        directions = np.empty_like(origins)
        self._core.rays(self.width, self.height, origins, directions)
        shape = (self.height, self.width, 3)
        return origins.reshape(shape), directions.reshape(shape)


class PinholeCamera(_Camera):
    """A camera with perspective.

    position, target: where it stands and what is in the middle of its picture.
    up: the direction that is upward in the picture, nearly.
    field_of_view: the full vertical angle, in degrees.
    width, height: pixels.

    >>> import boxwood as bw
    >>> scene = bw.Scene(bw.generate("icosphere", 1280))
    >>> camera = bw.PinholeCamera([0, 0, 4], [0, 0, 0], width=64, height=48)
    >>> origins, directions = camera.rays()
    >>> origins.shape, directions.shape
    ((3,), (48, 64, 3))
    >>> scene.closest_hit(origins, directions).t.shape
    (48, 64)
    """

    def __init__(
        self,
        position: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = (0.0, 1.0, 0.0),
        *,
        field_of_view: float = 45.0,
        width: int = 640,
        height: int = 480,
    ) -> None:
        self.field_of_view = arguments.number(field_of_view, "field_of_view")
        if not 0 < self.field_of_view < 180:
            raise ValueError(
                f"field_of_view: found {field_of_view}, expected degrees between 0 and 180"
            )
        super().__init__(
            position,
            target,
            up,
            width,
            height,
            is_perspective=True,
            field_of_view=float(np.radians(self.field_of_view)),
        )

    def rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Their one origin (3,), and directions (height, width, 3) of unit length through the
        middle of each pixel, from the upper left one on."""
        origins, directions = self._rays()
        return origins[0, 0].copy(), directions

    @staticmethod
    def framing(what: Any, *, up: str = "y", width: int = 640, height: int = 480) -> PinholeCamera:
        """A camera that shows all of a Mesh or Scene from three quarters, from the front and a
        little from above.

        up: the axis that points upward, "y" or "z".
        """
        found = studio(what, arguments.text(up, "up"), *_size(width, height)).camera
        position = np.array(found.position)
        return PinholeCamera(
            position,
            position - np.array(found.back),
            found.up,
            field_of_view=float(np.degrees(found.field_of_view)),
            width=width,
            height=height,
        )


class OrthographicCamera(_Camera):
    """A camera without perspective: its rays are parallel.

    position, target, up, width, height: as for PinholeCamera.
    view_height: how much its picture shows from top to bottom, in units of the scene.

    >>> import boxwood as bw
    >>> camera = bw.OrthographicCamera([0, 0, 4], [0, 0, 0], view_height=2, width=4, height=2)
    >>> origins, directions = camera.rays()
    >>> origins[0, 0].round(9).tolist(), directions.tolist()
    ([-1.5, 0.5, 4.0], [0.0, 0.0, -1.0])
    """

    def __init__(
        self,
        position: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = (0.0, 1.0, 0.0),
        *,
        view_height: float = 1.0,
        width: int = 640,
        height: int = 480,
    ) -> None:
        self.view_height = arguments.number(view_height, "view_height")
        if not 0 < self.view_height < np.inf:
            raise ValueError(f"view_height: found {view_height}, expected a number above 0")
        super().__init__(
            position,
            target,
            up,
            width,
            height,
            is_perspective=False,
            view_height=self.view_height,
        )

    def rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Origins (height, width, 3), from the upper left pixel on, and their one direction (3,) of
        unit length."""
        origins, directions = self._rays()
        # 0 instead of -0.
        return origins, directions[0, 0] + 0.0


class SphericalCamera:
    """Rays in all directions from one place, as a lidar scanner sends them or a panorama shows.

    position: where it stands.
    forward, up: directions; forward is in the middle of the picture.
    horizontal: the angles to the left and right, in degrees; from -180 to 180 is all around.
    vertical: the angles from the lowest to the highest ray, in degrees from the horizon; or an
        array of them, one for each of a scanner's lasers, from the top.
    width, height: how many rays in each direction; for an array of angles the height is its length.

    >>> import boxwood as bw
    >>> lidar = bw.SphericalCamera([0, 0, 0], vertical=[15, 0, -15], width=360)
    >>> origin, directions = lidar.rays()
    >>> directions.shape
    (3, 360, 3)
    """

    def __init__(
        self,
        position: ArrayLike,
        forward: ArrayLike = (1.0, 0.0, 0.0),
        up: ArrayLike = (0.0, 0.0, 1.0),
        *,
        horizontal: tuple[float, float] = (-180.0, 180.0),
        vertical: tuple[float, float] | Iterable[float] = (-90.0, 90.0),
        width: int = 1024,
        height: int | None = None,
    ) -> None:
        self.position = arguments.vector(position, "position")
        axis = arguments.vector(up, "up")
        ahead = arguments.vector(forward, "forward")
        side = np.cross(axis, ahead)
        if not side.any():
            raise ValueError(
                f"forward and up: found {ahead.tolist()} and {axis.tolist()}, "
                "expected directions that differ"
            )
        self._up = axis / np.linalg.norm(axis)
        self._left = side / np.linalg.norm(side)
        self._forward = np.cross(self._left, self._up)
        angles = _angles(vertical, "vertical")
        sides = _angles(horizontal, "horizontal")
        if len(sides) != 2:
            raise ValueError(f"horizontal: found {len(sides)} angles, expected 2")
        self.width = arguments.count(width, "width", 1, _MOST)
        is_range = isinstance(vertical, tuple) and len(angles) == 2
        if height is None:
            height = max(self.width // 2, 1) if is_range else len(angles)
        self.height = arguments.count(height, "height", 1, _MOST)
        if is_range:
            self._elevations = _middles(angles[1], angles[0], self.height)
        elif self.height == len(angles):
            self._elevations = np.radians(angles)
        else:
            raise ValueError(
                f"height: found {self.height}, expected {len(angles)}, the number of angles"
            )
        self._azimuths = -_middles(sides[0], sides[1], self.width)

    def rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Their one origin (3,), and directions (height, width, 3) of unit length, from the upper
        left one on."""
        flat = np.cos(self._azimuths)[:, None] * self._forward
        flat = flat + np.sin(self._azimuths)[:, None] * self._left
        across = np.cos(self._elevations)[:, None, None] * flat
        return self.position.copy(), across + np.sin(self._elevations)[:, None, None] * self._up


def _angles(value: Iterable[float], name: str) -> NDArray[np.float64]:
    """Finite numbers, at least one, as a flat array."""
    is_once = isinstance(value, Iterable) and not hasattr(value, "__len__")
    given: Any = list(value) if is_once else value
    result = arguments.floats(given, name).astype(np.float64)
    if result.ndim != 1 or result.size == 0 or not np.isfinite(result).all():
        raise ValueError(f"{name}: found {arguments.describe(result)}, expected finite angles (n,)")
    return result


def _middles(first: float, last: float, count: int) -> NDArray[np.float64]:
    """The middles of so many equal steps, in radians."""
    return np.asarray(np.radians(first + (last - first) * (np.arange(count) + 0.5) / count))
