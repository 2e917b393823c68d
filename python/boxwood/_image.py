# SPDX-License-Identifier: Apache-2.0
"""Pictures."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core


class Image:
    """A picture, which a notebook shows.

    pixels: array (height, width), (height, width, 3) or (height, width, 4): grey, red green blue,
        and alpha; uint8, or floats of which 0 is black and 1 is full, as they should be shown.

    >>> import boxwood as bw, numpy as np
    >>> image = bw.Image(np.full((2, 3, 3), 0.5))
    >>> image.numpy().shape, image.numpy()[0, 0].tolist()
    ((2, 3, 3), [128, 128, 128])
    """

    def __init__(self, pixels: ArrayLike) -> None:
        given = arguments.array(pixels, "pixels")
        if given.dtype != np.uint8 and given.dtype.kind not in "fb":
            raise TypeError(f"pixels: found {arguments.describe(given)}, expected uint8 or floats")
        if given.ndim == 2:
            given = np.repeat(given[..., None], 3, axis=2)
        if given.ndim != 3 or given.shape[2] not in (3, 4) or 0 in given.shape:
            raise ValueError(
                f"pixels: found {arguments.describe(given)}, "
                "expected shape (height, width) or (height, width, 3 or 4)"
            )
        #: Array (height, width, 3 or 4) of uint8 or floats, as it was given.
        self.pixels: NDArray[Any] = given

    @property
    def width(self) -> int:
        """In pixels."""
        return int(self.pixels.shape[1])

    @property
    def height(self) -> int:
        """In pixels."""
        return int(self.pixels.shape[0])

    def numpy(self) -> NDArray[np.uint8]:
        """The picture as array (height, width, 3 or 4) of uint8."""
        rgba = self._rgba()
        return rgba if self.pixels.shape[2] == 4 else np.ascontiguousarray(rgba[..., :3])

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """The same as `numpy`, for what takes arrays."""
        return self.numpy().astype(dtype or np.uint8, copy=False)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a PNG file, which appears whole or not at all. Raises ValueError for another
        extension, OSError when it can't be written."""
        name = arguments.path(path)
        if not name.lower().endswith(".png"):
            raise ValueError(f"path: found {name!r}, expected the name of a .png file")
        _core.write_png(name, self._rgba())

    def _repr_png_(self) -> bytes:
        """The picture as the bytes of a PNG file, for notebooks."""
        data: bytes = _core.encode_png(self._rgba())
        return data

    def __repr__(self) -> str:
        return f"<boxwood.Image: {self.width}x{self.height}>"

    def _rgba(self) -> NDArray[np.uint8]:
        pixels = self.pixels
        if pixels.dtype == np.uint8:
            rgba = np.full((self.height, self.width, 4), 255, np.uint8)
            rgba[..., : pixels.shape[2]] = pixels
            return rgba
        flat = pixels.astype(np.float64).reshape(-1, pixels.shape[2])
        rgba = np.empty((len(flat), 4), np.uint8)
        _core.to_rgba8(np.ascontiguousarray(flat[:, :3]), rgba)
        if pixels.shape[2] == 4:
            alpha = np.empty_like(rgba)
            _core.to_rgba8(np.ascontiguousarray(np.repeat(flat[:, 3:], 3, axis=1)), alpha)
            rgba[:, 3] = alpha[:, 0]
        return rgba.reshape(self.height, self.width, 4)

    @staticmethod
    def of_depth(t: ArrayLike) -> Image:
        """Distances (height, width) in grey, near ones bright; what is infinite is black.

        >>> import boxwood as bw
        >>> bw.Image.of_depth([[1.0, 2.0, float("inf")]]).numpy()[0, :, 0].tolist()
        [255, 64, 0]
        """
        depth = arguments.floats(t, "t").astype(np.float64)
        _check_shape(depth, "t", "(height, width)", depth.ndim == 2)
        grey = np.zeros(depth.shape)
        seen = np.isfinite(depth)
        if seen.any():
            near, far = depth[seen].min(), depth[seen].max()
            grey[seen] = 1 - 0.75 * (depth[seen] - near) / (far - near if far > near else 1)
        return Image(grey)

    @staticmethod
    def of_normal(normal: ArrayLike) -> Image:
        """Normals (height, width, 3) as colors: 0.5 + 0.5 n; zero is black."""
        n = arguments.vectors(normal, "normal")
        _check_shape(n, "normal", "(height, width, 3)", n.ndim == 3)
        return Image(np.where(n.any(axis=-1, keepdims=True), 0.5 + 0.5 * n, 0.0))

    @staticmethod
    def of_ids(ids: ArrayLike) -> Image:
        """Numbers (height, width), of triangles, say, as colors that tell neighbours apart; below 0
        is black."""
        given = arguments.integers(ids, "ids").astype(np.int64)
        _check_shape(given, "ids", "(height, width)", given.ndim == 2)
        mixed = given.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(29)
        shifts = np.array([0, 8, 16], np.uint64)
        colors = (mixed[..., None] >> shifts & np.uint64(0xFF)).astype(np.uint8)
        # Never as dark as what isn't there.
        colors = (colors // 4 * 3 + 64).astype(np.uint8)
        colors[given < 0] = 0
        return Image(colors)


def _check_shape(array: NDArray[Any], name: str, expected: str, is_so: bool) -> None:
    if not is_so:
        raise ValueError(f"{name}: found {arguments.describe(array)}, expected shape {expected}")
