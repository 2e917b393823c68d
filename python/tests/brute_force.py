# SPDX-License-Identifier: Apache-2.0
"""What queries should answer, by numpy and every triangle: nothing of it is boxwood's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

# Nearer to an edge than that, or to another answer, rounding may decide.
UNSURE = 1e-9


@dataclass
class Triangles:
    """Triangles of a scene as they stand in the world, by instance and then by face."""

    corners: np.ndarray  # (m, 3, 3)
    instance: np.ndarray  # (m)
    triangle: np.ndarray  # (m)
    visibility: np.ndarray  # (m) uint32
    culls: np.ndarray  # (m) bool


def in_world(instances, culls=None) -> Triangles:
    """Of instances (vertices, faces, transform (4, 4), visibility)."""
    parts = []
    for i, (vertices, faces, transform, visibility) in enumerate(instances):
        placed = np.float64(vertices) @ transform[:3, :3].T + transform[:3, 3]
        m = len(faces)
        parts.append(
            (
                placed[np.asarray(faces, int).reshape(-1, 3)],
                np.full(m, i),
                np.arange(m),
                np.full(m, visibility, np.uint32),
                np.full(m, bool(culls[i]) if culls is not None else False),
            )
        )
    return Triangles(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


@dataclass
class Meetings:
    """Of each ray (n) with each triangle (m)."""

    t: np.ndarray  # inf where they don't meet
    uv: np.ndarray  # (n, m, 2)
    is_unsure: np.ndarray  # (n) whether rounding may decide about the ray


def meetings(
    world: Triangles,
    origins,
    directions,
    t_min=0.0,
    t_max=np.inf,
    skip_triangle=-1,
    skip_instance=0,
    visibility=0xFFFFFFFF,
    unsure=UNSURE,
) -> Meetings:
    """By Moeller and Trumbore; origins and directions are (n, 3), the others numbers or (n)."""
    origins, directions = np.float64(origins)[:, None], np.float64(directions)[:, None]
    n = origins.shape[0]

    def column(value):
        return np.broadcast_to(value, (n,))[:, None]

    a, b, c = (world.corners[None, :, k] for k in range(3))
    across = np.cross(directions, c - a)
    determinant = np.sum(across * (b - a), axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.sum(across * (origins - a), axis=2) / determinant
        around = np.cross(origins - a, b - a)
        v = np.sum(around * directions, axis=2) / determinant
        t = np.sum(around * (c - a), axis=2) / determinant
    margin = np.min([u, v, 1 - u - v], axis=0)
    low, high = column(t_min), column(t_max)
    is_hit = (determinant != 0) & (margin >= 0) & (low <= t) & (t <= high)
    is_hit &= (column(visibility).astype(np.uint32) & world.visibility) != 0
    is_hit &= ~(
        (column(skip_triangle) == world.triangle) & (column(skip_instance) == world.instance)
    )
    # From the front, directions go against the normal.
    is_hit &= ~world.culls | (determinant > 0)
    t = np.where(is_hit, t, np.inf)
    close = np.sort(t, axis=1)
    with np.errstate(invalid="ignore"):
        ties = (np.diff(close, axis=1) < unsure).any(axis=1)
        at_limit = np.minimum(np.abs(t - low), np.abs(t - high)) < unsure
    is_unsure = ((np.abs(margin) < unsure) | at_limit).any(axis=1) | ties
    return Meetings(t, np.stack([u, v], axis=2), is_unsure)


def closest_points(world: Triangles, points):
    """Distance and place (n, m, 3) of each triangle's nearest point to each point."""
    points = np.float64(points)[:, None]
    corners = [world.corners[None, :, k] for k in range(3)]
    a, b, c = corners
    normal = np.cross(b - a, c - a)
    with np.errstate(divide="ignore", invalid="ignore"):
        height = np.sum((points - a) * normal, axis=2) / np.sum(normal * normal, axis=2)
    best_place = points - height[..., None] * normal
    is_above = np.isfinite(height)
    for p, q in ((a, b), (b, c), (c, a)):
        is_above = is_above & (np.sum(np.cross(q - p, best_place - p) * normal, axis=2) >= 0)
    best = np.where(is_above, np.linalg.norm(points - best_place, axis=2), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        squared = np.sum((q - p) ** 2, axis=2)
        along = np.sum((points - p) * (q - p), axis=2) / np.where(squared > 0, squared, 1)
        place = p + np.clip(along, 0, 1)[..., None] * (q - p)
        distance = np.linalg.norm(points - place, axis=2)
        is_nearer = distance < best
        best = np.where(is_nearer, distance, best)
        best_place = np.where(is_nearer[..., None], place, best_place)
    return best, best_place


def winding_numbers(world: Triangles, points):
    """The sum of solid angles over 4 pi; van Oosterom and Strackee."""
    a, b, c = (world.corners[None, :, k] - np.float64(points)[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(x, axis=2) for x in (a, b, c))
    above = np.sum(a * np.cross(b, c), axis=2)
    below = la * lb * lc + lc * np.sum(a * b, axis=2)
    below += la * np.sum(b * c, axis=2) + lb * np.sum(c * a, axis=2)
    return np.arctan2(above, below).sum(axis=1) / (2 * np.pi)


def boxes_touched(world: Triangles, lower, upper):
    """(n, m) whether each triangle touches each box, by separating axes."""
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    corners = world.corners[None] - middle[:, None, None]
    edges = np.roll(corners, -1, axis=2) - corners
    axes = [np.broadcast_to(axis, corners[:, :, 0].shape) for axis in np.eye(3)]
    axes.append(np.cross(edges[:, :, 0], edges[:, :, 1]))
    axes += [np.cross(axis, edges[:, :, k]) for axis in np.eye(3) for k in range(3)]
    touched = np.ones(corners.shape[:2], bool)
    for axis in axes:
        shadow = np.einsum("nmkx,nmx->nmk", corners, axis)
        reach = np.sum(half[:, None] * np.abs(axis), axis=2)
        touched &= (shadow.min(axis=2) <= reach) & (shadow.max(axis=2) >= -reach)
    return touched


def triangles_touched(world: Triangles, corners):
    """(n) whether each triangle touches any other: an edge of one goes through the other. Those in
    one plane aren't seen."""
    touched = np.zeros(len(corners), bool)
    for k in range(3):
        start, along = corners[:, k], corners[:, (k + 1) % 3] - corners[:, k]
        touched |= np.isfinite(meetings(world, start, along, 0, 1).t).any(axis=1)
        there = world.corners
        for i in range(len(corners)):
            one = Triangles(
                corners[i : i + 1],
                np.zeros(1),
                np.zeros(1),
                world.visibility[:1] | 1,
                np.zeros(1, bool),
            )
            edge = there[:, (k + 1) % 3] - there[:, k]
            touched[i] |= np.isfinite(meetings(one, there[:, k], edge, 0, 1).t).any()
    return touched
