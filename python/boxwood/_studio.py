# SPDX-License-Identifier: Apache-2.0
"""What makes a picture of meshes that come without a camera or lights."""

from __future__ import annotations

from typing import Any

from . import _arguments as arguments
from . import _core
from ._instance import Instance, instance_arrays
from ._mesh import Mesh
from ._scene import Scene


def studio(what: Mesh | Scene, up: str, width: int = 640, height: int = 480) -> Any:
    """A world of meshes of clay, framed and lit."""
    if isinstance(what, Mesh):
        what_culls = [False]
        meshes, instances = [what], [Instance(what)]
    elif isinstance(what, Scene):
        meshes, instances = what.meshes, what.instances
        what_culls = what._culls
    else:
        raise TypeError(f"what: found {arguments.describe(what)}, expected a boxwood.Mesh or Scene")
    seen = [instance for instance in instances if instance.visibility]
    places, transforms, _ = instance_arrays(meshes, seen)
    world = _core.World.studio([mesh._data() for mesh in meshes], what_culls, places, transforms)
    world.frame(up, width, height)
    return world
