# SPDX-License-Identifier: Apache-2.0
"""Pictures of scenes."""

from __future__ import annotations

import os

import numpy as np

from . import _arguments as arguments
from . import _core
from ._camera import OrthographicCamera, PinholeCamera
from ._image import Image
from ._mesh import Mesh, warn
from ._progress import Progress, reporting
from ._scene import Scene
from ._studio import studio

Camera = PinholeCamera | OrthographicCamera


def render(
    scene: str | os.PathLike[str] | Mesh | Scene,
    *,
    camera: Camera | None = None,
    width: int | None = None,
    height: int | None = None,
    integrator: str | None = None,
    samples: int | None = None,
    bounces: int | None = None,
    seed: int | None = None,
    up: str | None = None,
    progress: Progress = None,
) -> Image:
    """A picture of a scene file (.json), a glTF file, a mesh file, a Mesh or a Scene. What comes
    without a camera is framed from three quarters, what comes without lights is lit as in a studio.

    camera: a PinholeCamera or OrthographicCamera; also says the size.
    width, height: pixels; without, what the scene says.
    integrator: what the picture shows: "phong", "whitted" (shadows, mirrors, glass), "normal",
        "depth" or "heat" (how much work each pixel is).
    samples: rays a pixel, for smooth edges.
    bounces: how often "whitted" follows a ray.
    seed: of the samples' places.
    up: the axis of a mesh that points upward, "y" or "z".

    Raises TypeError or ValueError for bad arguments, OSError and ParseError for files.

    >>> import boxwood as bw
    >>> bw.render(bw.generate("torus_knot", 2000), width=64, height=48)
    <boxwood.Image: 64x48>
    """
    if camera is not None and not isinstance(camera, (PinholeCamera, OrthographicCamera)):
        raise TypeError(
            f"camera: found {arguments.describe(camera)}, "
            "expected a PinholeCamera or OrthographicCamera"
        )
    for value, name in ((integrator, "integrator"), (up, "up")):
        if value is not None:
            arguments.text(value, name)
    is_file = not isinstance(scene, (Mesh, Scene))
    if isinstance(scene, (Mesh, Scene)):
        world = studio(scene, up or "y")
    else:
        world = _core.World.read(arguments.path(scene, "scene"), up, "", False)
        warn(world.warnings())
    columns = width if width is not None else (camera.width if camera else world.width)
    rows = height if height is not None else (camera.height if camera else world.height)
    pixels = np.empty(
        (arguments.count(rows, "height", 1, 2**15), arguments.count(columns, "width", 1, 2**15), 3)
    )
    if camera is not None:
        world.camera = camera._core
        if not is_file:
            world.light_studio(up or "y")
    elif not is_file:
        world.frame(up or "y", pixels.shape[1], pixels.shape[0])
    with reporting(progress, "rendering") as report:
        world.render(
            integrator,
            None if samples is None else arguments.count(samples, "samples", 1, 65536),
            None if bounces is None else arguments.count(bounces, "bounces", 0, 10_000),
            None if seed is None else arguments.count(seed, "seed", 0, 2**64 - 1),
            pixels,
            report,
        )
    return Image(pixels)
