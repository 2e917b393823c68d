# SPDX-License-Identifier: Apache-2.0
"""Binary trees of boxes, to look at."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments as arguments
from . import _core
from ._mesh import Mesh


class Tree:
    """A binary tree of boxes over a mesh's triangles, as `build` makes it. Node 0 is the root; the
    children of node i are first[i] and first[i] + 1. All arrays are read-only views.

    >>> import boxwood as bw
    >>> tree = bw.build(bw.generate("icosphere", 320), "median")
    >>> len(tree.count), tree.boxes(1).shape
    (639, (2, 2, 3))
    """

    def __init__(self, core: Any) -> None:
        self._core = core

    @property
    def lower(self) -> NDArray[np.float32]:
        """(n, 3) the least coordinates of each node's box."""
        result: NDArray[np.float32] = self._core.lower
        return result

    @property
    def upper(self) -> NDArray[np.float32]:
        """(n, 3) the greatest coordinates of each node's box."""
        result: NDArray[np.float32] = self._core.upper
        return result

    @property
    def first(self) -> NDArray[np.uint32]:
        """(n) of an inner node its left child, of a leaf the place in `order` of its first
        triangle."""
        result: NDArray[np.uint32] = self._core.first
        return result

    @property
    def count(self) -> NDArray[np.uint32]:
        """(n) the triangles of a leaf; 0 says inner node."""
        result: NDArray[np.uint32] = self._core.count
        return result

    @property
    def order(self) -> NDArray[np.uint32]:
        """The triangles; leaves are ranges of it. Spatial splits may have one in several leaves."""
        result: NDArray[np.uint32] = self._core.order
        return result

    @property
    def depths(self) -> NDArray[np.uint32]:
        """(n) how many nodes are above each one."""
        result: NDArray[np.uint32] = self._core.depths()
        return result

    def boxes(self, depth: int) -> NDArray[np.float32]:
        """(m, 2, 3) the lower and upper corners of the boxes that are so deep, the root at 0."""
        here = self.depths == arguments.count(depth, "depth")
        return np.stack([self.lower[here], self.upper[here]], axis=1)

    @property
    def statistics(self) -> dict[str, Any]:
        """nodes, leaves, depth, largest_leaf, bytes, and sah_cost: the boxes and triangles that a
        random line through the root's box is expected to test."""
        found: dict[str, Any] = self._core.statistics()
        return found

    def __repr__(self) -> str:
        return f"<boxwood.Tree: {len(self.count)} nodes>"


def build(mesh: Mesh, method: str = "binned_sah", *, cost: str = "surface_area") -> Tree:
    """A binary tree over the mesh's triangles.

    method: "median", "agglomerative", "binned_sah", "block_sah", "morton", "ploc", "sweep_sah",
        "spatial_split" or "reinsertion".
    cost: what "agglomerative" merges by: "centroid_distance", "volume_increase" or "surface_area".

    Raises ValueError for another name.

    >>> import boxwood as bw
    >>> bw.build(bw.generate("icosphere", 320), "median").statistics["leaves"]
    320
    """
    if not isinstance(mesh, Mesh):
        raise TypeError(f"mesh: found {arguments.describe(mesh)}, expected a boxwood.Mesh")
    arguments.text(method, "method")
    arguments.text(cost, "cost")
    slow = _core.warning_before_build(len(mesh.faces), method)
    if slow is not None:
        warnings.warn(slow, stacklevel=2)
    vertices = np.ascontiguousarray(mesh.vertices, dtype=np.float64)
    return Tree(_core.build(vertices, mesh.faces, method, cost))
