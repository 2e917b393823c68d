# SPDX-License-Identifier: Apache-2.0
"""Depth, normals and triangles as a camera sees them, side by side.

Usage: python examples/python/depth_normals.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

given = begin(__doc__, bw.generate("torus_knot", 6000))
scene = bw.Scene(given.mesh)

# One ray through the middle of each pixel: origin (3,), directions (height, width, 3).
size = given.width // 3
camera = bw.PinholeCamera.framing(given.mesh, up=given.up, width=size, height=size)
origin, directions = camera.rays()
hits = scene.closest_hit(origin, directions)

# t is a distance along the ray, as directions have unit length; depth is along the view.
ahead = camera.target - camera.position
depth = hits.t * (directions @ (ahead / np.linalg.norm(ahead)))

# Triangles may be seen from behind, so turn their normals to the camera.
is_behind = (hits.normal * directions).sum(axis=-1, keepdims=True) > 0
normal = np.where(is_behind, -hits.normal, hits.normal)

parts = [bw.Image.of_depth(depth), bw.Image.of_normal(normal), bw.Image.of_ids(hits.triangle)]
bw.Image(np.concatenate([part.numpy() for part in parts], axis=1)).save(given.picture)
print(f"{given.picture}: {hits.hit.mean():.0%} of the rays hit, from {depth.min():.2f} on")
