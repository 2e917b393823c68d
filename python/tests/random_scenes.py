# SPDX-License-Identifier: Apache-2.0
"""Scenes and rays for tests against brute force, from a seed."""

from __future__ import annotations

import brute_force
import numpy as np
from hypothesis import strategies as st

import boxwood as bw

seeds = st.integers(0, 2**32 - 1)
#: Shapes of rays that broadcast: origins, directions and answers.
shapes = st.sampled_from(
    [
        ((), (), ()),
        ((0,), (), (0,)),
        ((7,), (7,), (7,)),
        ((), (9,), (9,)),
        ((6,), (), (6,)),
        ((3, 1), (4,), (3, 4)),
        ((), (4, 5), (4, 5)),
        ((2, 1, 3), (2, 2, 1), (2, 2, 3)),
        ((2, 0), (1, 1), (2, 0)),
    ]
)


def soup(rng, triangles):
    """Triangles anywhere, with vertices that some share."""
    vertices = rng.uniform(-1, 1, (max(3, triangles), 3))
    faces = np.array([rng.choice(len(vertices), 3, replace=False) for _ in range(triangles)])
    return vertices, faces.reshape(-1, 3)


def placement(rng):
    """An affine map that turns, stretches and moves, and mirrors nothing."""
    matrix = np.eye(4)
    while True:
        matrix[:3, :3] = rng.uniform(-1, 1, (3, 3))
        if np.linalg.det(matrix[:3, :3]) > 0.1:
            break
    matrix[:3, 3] = rng.uniform(-1, 1, 3)
    return matrix


def scene(rng, dtype=np.float64):
    """Two meshes, maybe culled, in up to four instances with masks: the scene and its triangles."""
    meshes = [soup(rng, int(rng.integers(1, 25))) for _ in range(2)]
    meshes = [(vertices.astype(dtype), faces) for vertices, faces in meshes]
    given = [bw.Mesh(*mesh) for mesh in meshes]
    culls = rng.random(2) < 0.3
    chosen = [0, 1, *rng.integers(0, 2, rng.integers(0, 3))]
    instances, known = [], []
    for mesh in chosen:
        transform = np.eye(4) if rng.random() < 0.3 else placement(rng)
        mask = int(rng.choice([0xFFFFFFFF, 1, 2, 3, 2**31]))
        instances.append(bw.Instance(given[mesh], transform, mask))
        known.append((*meshes[mesh], transform, mask))
    world = brute_force.in_world(known, culls[chosen])
    return bw.Scene(instances, cull_back_faces=[bool(cull) for cull in culls]), world


def rays(rng, shape):
    """Origins, directions that aim about the scene, and the same as rows."""
    origins = rng.uniform(-2, 2, (*shape[0], 3))
    directions = rng.uniform(-1, 1, (*shape[1], 3))
    rows = [np.broadcast_to(x, (*shape[2], 3)).reshape(-1, 3) for x in (origins, directions)]
    return origins, directions, *rows


def limits(rng, shape):
    """Arguments for some of the rays: one number for all, one a ray, or none; and as rows."""
    given, rows = {}, {}
    draws = {
        "t_min": lambda size: rng.uniform(-1, 1, size),
        "t_max": lambda size: rng.uniform(0, 3, size),
        "skip_triangle": lambda size: rng.integers(-1, 10, size),
        "skip_instance": lambda size: rng.integers(-1, 3, size),
        "visibility": lambda size: rng.integers(0, 2**32, size, dtype=np.uint32),
    }
    for name, draw in draws.items():
        kind = rng.integers(3)
        if kind < 2:
            given[name] = draw(shape if kind == 0 else ())
            rows[name] = np.broadcast_to(given[name], shape).reshape(-1)
    return given, rows
