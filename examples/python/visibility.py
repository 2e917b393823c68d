# SPDX-License-Identifier: Apache-2.0
"""What can be seen from a place: of a landscape, say, from a tower in its middle.

Usage: python examples/python/visibility.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

given = begin(__doc__, bw.generate("terrain", 300_000), up="z")
mesh = given.mesh
scene = bw.Scene(mesh)
size = float(np.ptp(mesh.bounds, axis=0).max())
up = np.eye(3)["xyz".index(given.up)]

# The eye is above the highest vertex near the middle.
from_middle = mesh.vertices - mesh.bounds.mean(axis=0)
from_middle -= np.outer(from_middle @ up, up)
is_near = np.linalg.norm(from_middle, axis=1) < 0.2 * size
heights = mesh.vertices @ up
eye = mesh.vertices[np.where(is_near, heights, -np.inf).argmax()] + 0.05 * size * up

# From each vertex, from a little above its triangles, a ray to the eye. t_max=1 ends it there.
starts = mesh.vertices + 1e-4 * size * up
is_seen = ~scene.any_hit(starts, eye - starts, t_max=1)

# What is seen is lighter the nearer it is.
distance = np.linalg.norm(mesh.vertices - eye, axis=1)
light = bw.color_map(-distance, low=-0.9 * size, high=0.1 * size)
rgba = np.ones((len(mesh.vertices), 4))
rgba[:, :3] = np.where(is_seen[:, None], light, [0.07, 0.10, 0.16])
mesh.colors = bw.Attribute(rgba)

# A ball where the eye is.
ball = np.diag([0.012 * size] * 3 + [1])
ball[:3, 3] = eye
shown = bw.Scene([mesh, bw.Instance(bw.generate("icosphere", 1280), ball)])
camera = bw.PinholeCamera.framing(mesh, up=given.up, width=given.width, height=given.height)
higher = bw.PinholeCamera(
    camera.position + size * up,
    mesh.bounds.mean(axis=0),
    up,
    field_of_view=camera.field_of_view,
    width=given.width,
    height=given.height,
)
bw.render(shown, camera=higher, up=given.up).save(given.picture)
print(f"{given.picture}: {is_seen.mean():.0%} of the vertices are seen from {eye.round(2)}")
