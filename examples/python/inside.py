# SPDX-License-Identifier: Apache-2.0
"""Inside or outside: signed distances on a plane that cuts a mesh, with a line at every step.

Usage: python examples/python/inside.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

given = begin(__doc__, bw.generate("torus_knot", 20_000))
scene = bw.Scene(given.mesh)
width, height = given.width, given.height
low, high = given.mesh.bounds
middle, size = (low + high) / 2, float((high - low).max()) * 1.25

# A point for each pixel, in the plane z = middle.
x = (np.arange(width) + 0.5 - width / 2) / height * size
y = (height / 2 - np.arange(height) - 0.5) / height * size
points = np.empty((height, width, 3))
points[..., 0], points[..., 1], points[..., 2] = middle[0] + x, middle[1] + y[:, None], middle[2]

# Pseudonormals need a closed mesh; winding numbers bear holes.
method = "pseudonormal" if scene.is_sign_trustworthy() else "winding_number"
distance = scene.signed_distance(points, method=method).distance

# Warm inside, cool outside, lighter away from the surface; lines where the distance is a multiple
# of the step, one pixel wide, and a bold one at the surface.
pixel, step = size / height, size / 60
is_inside = distance < 0
warm = bw.color_map(-distance, low=-0.1 * size, high=0.1 * size)
cool = bw.color_map(distance, low=-0.2 * size, high=0.5 * size)[..., ::-1]
colors = np.where(is_inside[..., None], warm, cool)
to_line = np.abs((distance + step / 2) % step - step / 2)
colors *= 0.75 + 0.25 * np.clip(to_line / pixel, 0, 1)[..., None]
colors *= np.clip(np.abs(distance) / pixel - 0.5, 0, 1)[..., None]
bw.Image(colors).save(given.picture)
print(f"{given.picture}: {is_inside.mean():.1%} of the plane is inside, as told by {method}")
