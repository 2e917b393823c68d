# SPDX-License-Identifier: Apache-2.0
"""Ray tracing and geometric queries on triangle meshes: numpy in, numpy out, on all cores.

>>> import boxwood as bw
>>> scene = bw.Scene(bw.generate("icosphere", 1280))
>>> hits = scene.closest_hit([[0, 0, 5], [0, 3, 5]], [0, 0, -1])
>>> hits.triangle >= 0
array([ True, False])
"""

from __future__ import annotations

from ._camera import OrthographicCamera, PinholeCamera, SphericalCamera
from ._color_map import color_map
from ._core import Error, ParseError
from ._image import Image
from ._instance import Instance
from ._mesh import Attribute, Labels, Mesh, MeshWarning, generate, load
from ._render import render
from ._results import ClosestPoints, FirstHits, HitLists, Hits, SignedDistances, TriangleLists
from ._scene import Scene
from ._scene import open_scene as open
from ._threads import thread_limit
from ._tree import Tree, build

__version__ = "0.1.0"

__all__ = [
    "Attribute",
    "ClosestPoints",
    "Error",
    "FirstHits",
    "HitLists",
    "Hits",
    "Image",
    "Instance",
    "Labels",
    "Mesh",
    "MeshWarning",
    "OrthographicCamera",
    "ParseError",
    "PinholeCamera",
    "Scene",
    "SignedDistances",
    "SphericalCamera",
    "Tree",
    "TriangleLists",
    "build",
    "color_map",
    "generate",
    "load",
    "open",
    "render",
    "thread_limit",
]
