# SPDX-License-Identifier: Apache-2.0
"""Rays of cameras are those of the formulas."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from random_scenes import seeds

import boxwood as bw


def view(rng):
    """A place, a target, a direction upward; and the axes that they make."""
    position, target, up = rng.uniform(-2, 2, (3, 3))
    ahead = (target - position) / np.linalg.norm(target - position)
    right = np.cross(ahead, up)
    right /= np.linalg.norm(right)
    return (position, target, up), (right, np.cross(right, ahead), ahead)


def film(width, height):
    """The middles of pixels, from -1 at the left and bottom to 1, for square pixels."""
    x = ((np.arange(width) + 0.5) / width * 2 - 1) * (width / height)
    y = 1 - (np.arange(height) + 0.5) / height * 2
    return np.meshgrid(x, y)


@given(seeds)
def test_pinhole_cameras(seed):
    rng = np.random.default_rng(seed)
    place, (right, up, ahead) = view(rng)
    width, height, angle = int(rng.integers(1, 20)), int(rng.integers(1, 20)), rng.uniform(1, 120)
    camera = bw.PinholeCamera(*place, field_of_view=angle, width=width, height=height)
    origin, directions = camera.rays()
    x, y = (np.tan(np.radians(angle) / 2) * c[..., None] for c in film(width, height))
    expected = ahead + x * right + y * up
    expected /= np.linalg.norm(expected, axis=-1, keepdims=True)
    np.testing.assert_array_equal(origin, place[0])
    np.testing.assert_allclose(directions, expected, atol=1e-12)


@given(seeds)
def test_orthographic_cameras(seed):
    rng = np.random.default_rng(seed)
    place, (right, up, ahead) = view(rng)
    width, height, high = int(rng.integers(1, 20)), int(rng.integers(1, 20)), rng.uniform(0.1, 9)
    camera = bw.OrthographicCamera(*place, view_height=high, width=width, height=height)
    origins, direction = camera.rays()
    x, y = (high / 2 * c[..., None] for c in film(width, height))
    np.testing.assert_allclose(origins, place[0] + x * right + y * up, atol=1e-9)
    np.testing.assert_allclose(direction, ahead, atol=1e-12)


def test_spherical_cameras_look_all_around():
    camera = bw.SphericalCamera([1, 2, 3], width=8)
    origin, directions = camera.rays()
    assert directions.shape == (4, 8, 3) and origin.tolist() == [1, 2, 3]
    np.testing.assert_allclose(np.linalg.norm(directions, axis=2), 1)
    azimuth = np.degrees(np.arctan2(directions[..., 1], directions[..., 0]))
    elevation = np.degrees(np.arcsin(directions[..., 2]))
    # From the left, which is the side of +y when one looks along +x, to the right.
    np.testing.assert_allclose(azimuth[0], 180 - 45 * (np.arange(8) + 0.5))
    np.testing.assert_allclose(elevation[:, 0], 90 - 45 * (np.arange(4) + 0.5))


def test_a_scanner_has_a_row_for_each_laser():
    angles = np.array([15.0, 5, -5, -15])
    camera = bw.SphericalCamera([0, 0, 0], vertical=angles, horizontal=(-90, 90), width=5)
    _, directions = camera.rays()
    assert (camera.width, camera.height) == (5, 4)
    np.testing.assert_allclose(np.degrees(np.arcsin(directions[..., 2]))[:, 0], angles)
    np.testing.assert_allclose(directions[1, 2], [np.cos(np.radians(5)), 0, np.sin(np.radians(5))])
    np.testing.assert_array_equal(
        bw.SphericalCamera([0, 0, 0], vertical=iter(angles), width=5).rays()[1].shape, (4, 5, 3)
    )


@pytest.mark.parametrize("up", ["y", "z"])
def test_framing_shows_all_of_it(ball, up):
    moved = bw.Scene(bw.Instance(ball, np.diag([3.0, 1, 2, 1])))
    for what in (ball, moved):
        camera = bw.PinholeCamera.framing(what, up=up, width=80, height=60)
        hit = bw.Scene(what).closest_hit(*camera.rays()).hit if what is ball else None
        hit = what.closest_hit(*camera.rays()).hit if hit is None else hit
        assert 0.1 < hit.mean() < 0.9
        assert not (hit[0].any() or hit[-1].any() or hit[:, 0].any() or hit[:, -1].any())
    assert np.argmax(np.abs(camera.up)) == {"y": 1, "z": 2}[up]
