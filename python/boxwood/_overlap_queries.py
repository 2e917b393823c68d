# SPDX-License-Identifier: Apache-2.0
"""Which triangles of scenes touch a shape."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core
from ._progress import Progress, reporting
from ._results import TriangleLists


class OverlapQueries:
    """The questions of a Scene about shapes."""

    _core: _core.Scene

    def box_overlap(
        self, lower: ArrayLike, upper: ArrayLike, *, progress: Progress = None
    ) -> TriangleLists:
        """The triangles that touch each box, in order.

        lower, upper: arrays (..., 3), the boxes' corners of least and greatest coordinates.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.box_overlap([[-2, -2, -2], [3, 3, 3]], [[2, 2, 2], [4, 4, 4]]).counts.tolist()
        [1280, 0]
        """
        lo, hi = arguments.vectors(lower, "lower"), arguments.vectors(upper, "upper")
        if lo.shape != hi.shape:
            raise ValueError(
                f"lower and upper: found shapes {lo.shape} and {hi.shape}, expected the same"
            )
        with reporting(progress, "box overlaps") as report:
            found = self._core.box_overlap(arguments.points(lo)[0], arguments.points(hi)[0], report)
        return TriangleLists(found["offsets"], found["triangle"], found["instance"])

    def sphere_overlap(
        self, centers: ArrayLike, radii: ArrayLike, *, progress: Progress = None
    ) -> TriangleLists:
        """The triangles no farther from each center (..., 3) than its radius, in order; one radius
        may do for all.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.sphere_overlap([[0, 0, 0], [0, 0, 9]], [2, 1]).counts.tolist()
        [1280, 0]
        """
        places, shape = arguments.points(centers, "centers")
        sizes = arguments.per_item(radii, "radii", shape, np.float64)
        with reporting(progress, "sphere overlaps") as report:
            found = self._core.sphere_overlap(places, sizes, report)
        return TriangleLists(found["offsets"], found["triangle"], found["instance"])

    def triangle_overlap(
        self, corners: ArrayLike, *, progress: Progress = None
    ) -> NDArray[np.bool_]:
        """Whether each triangle, (..., 3, 3) its corners, touches the scene.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> bool(scene.triangle_overlap([[0, 0, 0], [0, 0, 2], [0, 1, 2]]))
        True
        """
        given = arguments.vectors(corners, "corners")
        if given.ndim < 2 or given.shape[-2] != 3:
            raise ValueError(
                f"corners: found {arguments.describe(given)}, expected shape (..., 3, 3)"
            )
        shape = given.shape[:-2]
        results = np.empty(int(np.prod(shape, dtype=np.int64)), np.bool_)
        with reporting(progress, "triangle overlaps") as report:
            self._core.triangle_overlap(arguments.points(given)[0], results, report)
        return results.reshape(shape)
