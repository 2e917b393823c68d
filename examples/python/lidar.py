# SPDX-License-Identifier: Apache-2.0
"""The sweep of a lidar scanner that goes through a hall, as a cloud of points.

Usage: python examples/python/lidar.py [MESH] [-o PICTURE]
"""

import numpy as np
from _example import begin

import boxwood as bw

given = begin(__doc__, bw.generate("interior", 100_000), up="z")
scene = bw.Scene(given.mesh)
middle, size = given.mesh.bounds.mean(axis=0), np.ptp(given.mesh.bounds, axis=0)
up = np.eye(3)["xyz".index(given.up)]
camera = bw.PinholeCamera.framing(scene, up=given.up, width=given.width, height=given.height)

# The scanner has 64 lasers and stops at twelve places along the longer way through the mesh.
way = np.eye(3)[np.argmax(size * (1 - up))]
points = []
for part in np.linspace(-0.42, 0.42, 12):
    place = middle + part * size * way
    scanner = bw.SphericalCamera(place, way, up, vertical=np.linspace(40, -60, 64), width=1800)
    origin, directions = scanner.rays()
    hits = scene.closest_hit(origin, directions)
    found = (origin + hits.t[..., None] * directions)[hits.hit]
    # The walls between the camera and the points are left out: those it sees from the other side.
    normal, along = hits.normal[hits.hit], directions[hits.hit]
    to_camera = camera.position - found
    sides = (normal * to_camera).sum(axis=1) * (normal * -along).sum(axis=1)
    points.append(found[sides > 0])
cloud = np.concatenate(points)

# The points in the camera's picture, the nearest last.
ahead = camera.target - camera.position
ahead /= np.linalg.norm(ahead)
right = np.cross(ahead, camera.up)
right /= np.linalg.norm(right)
seen = cloud - camera.position
depth = seen @ ahead
scale = given.height / 2 / np.tan(np.radians(camera.field_of_view / 2)) / depth
x = (given.width / 2 + scale * (seen @ right)).astype(int).clip(0, given.width - 1)
y = (given.height / 2 - scale * (seen @ np.cross(right, ahead))).astype(int)
y = y.clip(0, given.height - 1)
order = np.argsort(-depth)
pixels = np.full((given.height, given.width, 3), 0.02)
low, high = (cloud @ up).min(), (cloud @ up).max()
colors = bw.color_map(cloud @ up, low - 0.25 * (high - low), high)
pixels[y[order], x[order]] = colors[order]
bw.Image(pixels).save(given.picture)
print(f"{given.picture}: {len(cloud)} points")
