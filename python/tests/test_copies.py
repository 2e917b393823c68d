# SPDX-License-Identifier: Apache-2.0
"""What isn't copied."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw
from boxwood._rays import rays


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_vertices_are_not_copied(ball, dtype):
    vertices = ball.vertices.astype(dtype)
    mesh = bw.Mesh(vertices, ball.faces)
    assert mesh.vertices is vertices
    assert bw.Scene(mesh).meshes[0].vertices is vertices
    view = np.asfortranarray(vertices)
    assert not np.shares_memory(bw.Mesh(view, ball.faces).vertices, view)


def test_an_opened_scene_shows_the_pages_of_its_file(ball, tmp_path):
    bw.Scene(ball).save(tmp_path / "ball.boxwood")
    mesh = bw.open(tmp_path / "ball.boxwood").meshes[0]
    assert not mesh.vertices.flags.owndata and not mesh.vertices.flags.writeable
    np.testing.assert_array_equal(mesh.vertices, ball.vertices)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_rays_are_read_where_they_are(monkeypatch, dtype):
    """The compiled part sees the caller's memory, and one origin once."""
    seen = []
    for name in ("Rays", "Raysf"):
        monkeypatch.setattr(f"boxwood._core.{name}", lambda *arrays: seen.append(arrays))
    origin, directions = np.zeros(3, dtype), np.ones((20, 30, 3), dtype)
    nearest = np.zeros((20, 30), dtype)
    rays(origin, directions, nearest, np.inf, None, None, None)
    rays(directions[:, ::2], origin, 0.0, 1.0, None, None, None)
    assert seen[0][0].shape == seen[0][1].shape == (600, 3) and seen[0][3].shape == (600,)
    assert np.shares_memory(seen[0][0], origin) and seen[0][0].strides[0] == 0
    assert np.shares_memory(seen[0][1], directions) and np.shares_memory(seen[0][2], nearest)
    assert seen[0][3].strides == (0,)
    assert np.shares_memory(seen[1][0], directions)


def test_trees_are_views(ball):
    tree = bw.build(ball)
    for name in ("lower", "upper", "first", "count", "order"):
        one = getattr(tree, name)
        assert np.shares_memory(one, getattr(tree, name)) and not one.flags.writeable


def test_views_outlive_what_they_were_taken_from(tmp_path):
    order = bw.build(bw.generate("icosphere", 320)).order
    assert sorted(order) == list(range(320))
    bw.Scene(bw.generate("icosphere", 320)).save(tmp_path / "ball.boxwood")
    vertices = bw.open(tmp_path / "ball.boxwood").meshes[0].vertices
    assert np.allclose(np.linalg.norm(vertices, axis=1), 1)
    scene = bw.Scene(bw.generate("icosphere", 320))
    assert scene.any_hit([0, 0, 5], [0, 0, -1])
