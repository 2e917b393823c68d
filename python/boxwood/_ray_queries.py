# SPDX-License-Identifier: Apache-2.0
"""What scenes say of rays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core
from ._progress import Progress, reporting
from ._rays import Rays, rays
from ._results import FirstHits, HitLists, Hits


class RayQueries:
    """The questions of a Scene about rays. Their arguments are those of `closest_hit`."""

    _core: _core.Scene

    def closest_hit(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> Hits:
        """The first hit of each ray with t_min <= t <= t_max, from either side of the triangles.
        Equal distances go to the lowest (instance, triangle).

        t_min, t_max: one number, or one for each ray.
        skip_triangle, skip_instance: the triangle that a ray starts on and doesn't see, so that it
            needs no offset; -1 for none. The instance is 0 without.
        visibility: bits; a ray sees the instances that share one with it.
        progress: True for a bar by tqdm, or a function of the part that is done.

        About O(log n) for each ray, on all cores.

        >>> import boxwood as bw, numpy as np
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> hits = scene.closest_hit(np.zeros(3), np.eye(3))
        >>> hits.t.round(2).tolist(), hits.normal.round(1).diagonal().tolist()
        ([1.0, 1.0, 1.0], [1.0, 1.0, 1.0])
        """
        asked = rays(origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility)
        dtype = asked.dtype if isinstance(asked.core, _core.Raysf) else np.float64
        n = asked.size
        t = np.empty(n, dtype)
        triangle = np.empty(n, np.int32)
        instance = np.empty(n, np.int32)
        uv = np.empty((n, 2), dtype)
        normal = np.empty((n, 3), dtype)
        with reporting(progress, "closest hits") as report:
            self._core.closest_hit(asked.core, t, triangle, instance, uv, normal, report)
        shape, given = asked.shape, asked.dtype
        return Hits(
            t.reshape(shape).astype(given, copy=False),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2).astype(given, copy=False),
            normal.reshape(*shape, 3).astype(given, copy=False),
        )

    def any_hit(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> NDArray[np.bool_]:
        """Whether each ray hits anything with t_min <= t <= t_max: faster than `closest_hit`, whose
        arguments it takes. For what two points see of each other take directions from one to the
        other and t_max=1.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.any_hit([0, 0, 5], [[0, 0, -1], [0, 0, 1]]).tolist()
        [True, False]
        """
        asked = rays(origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility)
        results = np.empty(asked.size, np.bool_)
        with reporting(progress, "any hits") as report:
            self._core.any_hit(asked.core, results, report)
        return results.reshape(asked.shape)

    def all_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> HitLists:
        """Every place where each ray goes through the surface, in the order of t: once for each
        crossing, on edges and vertices as well. Arguments as for `closest_hit`; always in double.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> hits = scene.all_hits([[0, 0, 5], [0, 3, 5]], [0, 0, -1])
        >>> hits.offsets.tolist(), hits.t[hits.of_ray(0)].round(2).tolist()
        ([0, 2, 2], [4.0, 6.0])
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        with reporting(progress, "all hits") as report:
            found = self._core.all_hits(asked.core, report)
        return HitLists(
            found["offsets"].view(np.int64),
            found["t"],
            found["triangle"].view(np.int32),
            found["instance"].view(np.int32),
            np.stack([found["u"], found["v"]], axis=-1),
        )

    def count_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> NDArray[np.int64]:
        """How many places `all_hits` would find for each ray; (...) int64.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.count_hits([[0, 0, 5], [0, 0, 0]], [0, 0, -1]).tolist()
        [2, 1]
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        results = np.empty(asked.size, np.int64)
        with reporting(progress, "counting hits") as report:
            self._core.count_hits(asked.core, results, report)
        return results.reshape(asked.shape)

    def first_k_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        k: int,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> FirstHits:
        """The first k of the places that `all_hits` would find for each ray.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.first_k_hits([0, 0, 5], [0, 0, -1], 3).t.round(2).tolist()
        [4.0, 6.0, inf]
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        k = arguments.count(k, "k", 0, 2**20)
        n = asked.size * k
        t = np.empty(n)
        triangle = np.empty(n, np.int32)
        instance = np.empty(n, np.int32)
        uv = np.empty((n, 2))
        with reporting(progress, "first hits") as report:
            self._core.first_k_hits(asked.core, k, t, triangle, instance, uv, report)
        shape = (*asked.shape, k)
        return FirstHits(
            t.reshape(shape),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2),
        )

    @staticmethod
    def _in_double(*given: Any) -> Rays:
        return rays(*given, in_double=True)
