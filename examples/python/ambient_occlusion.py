# SPDX-License-Identifier: Apache-2.0
"""Ambient occlusion, baked to the vertices: how much of the sky each of them sees.

Usage: python examples/python/ambient_occlusion.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

SAMPLES = 128


def brain() -> bw.Mesh:
    """A ball with folds."""
    ball = bw.generate("icosphere", 150_000)
    folds = np.abs(np.sin(7 * ball.vertices + 2 * np.sin(3 * ball.vertices[:, [1, 2, 0]])).sum(1))
    return bw.Mesh(ball.vertices * (0.7 + 0.3 * np.sqrt(folds[:, None] / 3)), ball.faces)


given = begin(__doc__, brain())
mesh = given.mesh
scene = bw.Scene(mesh)
size = float(np.ptp(mesh.bounds, axis=0).max())

# The normals of vertices: sums of those of their triangles, by area.
a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
normals = np.zeros((len(mesh.vertices), 3))
for k in range(3):
    np.add.at(normals, mesh.faces[:, k], np.cross(b - a, c - a))
normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)

# A point of the unit sphere, moved along the normal, is a direction with the density of the cosine:
# the part of such rays that gets away is the light of an even sky. Vertices belong to several
# triangles, so rays start a little above all of them.
starts = mesh.vertices + 1e-4 * size * normals
seen = np.zeros(len(mesh.vertices))
for direction in np.random.default_rng(1).normal(size=(SAMPLES, 3)):
    upward = normals + direction / np.linalg.norm(direction)
    seen += ~scene.any_hit(starts, upward, t_max=0.25 * size)
seen /= SAMPLES

mesh.normals = bw.Attribute(normals)
mesh.colors = bw.Attribute(np.column_stack([seen, seen, seen, np.ones_like(seen)]))
bw.render(mesh, width=given.width, height=given.height, up=given.up).save(given.picture)
print(f"{given.picture}: on average, vertices see {seen.mean():.0%} of the sky")
