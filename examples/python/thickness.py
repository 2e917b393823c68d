# SPDX-License-Identifier: Apache-2.0
"""How thick a solid is behind each triangle, as one who prints or casts it wants to know.

Usage: python examples/python/thickness.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

RAYS = 32
CONE = np.radians(30)


def star() -> bw.Mesh:
    """A ball with five arms and a dent."""
    ball = bw.generate("icosphere", 80_000)
    x, y, z = ball.vertices.T
    arms = 0.55 + 0.45 * np.cos(2.5 * np.arctan2(y, x)) ** 2 * (1 - z**2)
    return bw.Mesh(np.column_stack([arms * x, arms * y, 0.35 * z * (1.2 - z**2)]), ball.faces)


given = begin(__doc__, star())
mesh = given.mesh
scene = bw.Scene(mesh)

# Rays go inward from the middle of each triangle. They leave out the triangle itself, so they need
# no offset.
triangles = np.arange(len(mesh.faces))
centers = mesh.vertices[mesh.faces].mean(axis=1)
inward = -scene.geometric_normal(triangles)

# The median over a cone of rays doesn't jump where a single ray would.
rng = np.random.default_rng(1)
lengths = np.empty((RAYS, len(triangles)))
for i in range(RAYS):
    aside = np.cross(inward, rng.normal(size=3))
    aside /= np.maximum(np.linalg.norm(aside, axis=1, keepdims=True), 1e-300)
    angle = CONE * np.sqrt(rng.random())
    direction = np.cos(angle) * inward + np.sin(angle) * aside
    lengths[i] = scene.closest_hit(centers, direction, skip_triangle=triangles).t
thickness = np.median(lengths, axis=0)

low, high = np.percentile(thickness[np.isfinite(thickness)], [1, 99])
rgba = np.ones((len(triangles), 4))
rgba[:, :3] = bw.color_map(thickness, low, high)
mesh.colors = bw.Attribute(rgba, "faces")
bw.render(mesh, width=given.width, height=given.height, up=given.up).save(given.picture)
print(f"{given.picture}: thickness from {low:.3f} (black) to {high:.3f} (pale)")
