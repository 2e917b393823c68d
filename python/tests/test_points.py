# SPDX-License-Identifier: Apache-2.0
"""What is near to points, and around them, is what brute force finds."""

from __future__ import annotations

import brute_force
import numpy as np
import pytest
from hypothesis import given
from random_scenes import placement, scene, seeds, shapes

import boxwood as bw


@given(seeds, shapes)
def test_closest_points_equal_brute_force(seed, shape):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    points = rng.uniform(-2, 2, (*shape[2], 3))
    radius = rng.choice([np.inf, 0.3, 0.8])
    distances, places = brute_force.closest_points(world, points.reshape(-1, 3))
    best = distances.argmin(axis=1)
    rows = np.arange(len(best))
    distance = distances[rows, best]
    found = asked.closest_point(points, max_radius=radius)
    assert found.distance.shape == found.triangle.shape == found.instance.shape == shape[2]
    assert found.point.shape == (*shape[2], 3) and found.uv.shape == (*shape[2], 2)
    assert found.distance.dtype == found.point.dtype == found.uv.dtype == np.float64
    near = distance <= radius
    np.testing.assert_array_equal(found.found.reshape(-1), near)
    np.testing.assert_allclose(found.distance.reshape(-1)[near], distance[near], atol=1e-12)
    np.testing.assert_allclose(
        found.point.reshape(-1, 3)[near], places[rows, best][near], atol=1e-7
    )
    assert np.isinf(found.distance.reshape(-1)[~near]).all()
    assert (found.triangle.reshape(-1)[~near] == -1).all()
    # Where one triangle alone is nearest, that is it.
    alone = near & ((distances <= distance[:, None] + 1e-9).sum(axis=1) == 1)
    np.testing.assert_array_equal(found.triangle.reshape(-1)[alone], world.triangle[best][alone])
    np.testing.assert_array_equal(found.instance.reshape(-1)[alone], world.instance[best][alone])


@given(seeds)
def test_winding_numbers_equal_sums_of_solid_angles(seed):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    points = rng.uniform(-2, 2, (40, 3))
    expected = brute_force.winding_numbers(world, points)
    found = asked.winding_number(points, accuracy=1e6)
    np.testing.assert_allclose(found, expected, atol=1e-6)
    assert asked.winding_number(points[0]).shape == ()
    assert asked.winding_number(np.empty((0, 3))).shape == (0,)


@given(seeds)
@pytest.mark.parametrize("method", ["pseudonormal", "winding_number", "ray_parity"])
def test_distances_are_negative_inside(method, seed):
    rng = np.random.default_rng(seed)
    ball, transform = bw.generate("icosphere", 80), placement(rng)
    asked = bw.Scene(bw.Instance(ball, transform))
    world = brute_force.in_world([(ball.vertices, ball.faces, transform, 1)])
    points = rng.uniform(-2, 2, (4, 10, 3))
    distance = brute_force.closest_points(world, points.reshape(-1, 3))[0].min(axis=1)
    inside = brute_force.winding_numbers(world, points.reshape(-1, 3)) > 0.5
    found = asked.signed_distance(points, method=method)
    assert found.distance.shape == found.is_undefined.shape == (4, 10)
    assert found.is_undefined.dtype == np.bool_ and not found.is_undefined.any()
    np.testing.assert_allclose(
        found.distance.reshape(-1), np.where(inside, -distance, distance), atol=1e-9
    )
    assert asked.is_sign_trustworthy(method)


@given(seeds)
def test_overlaps_equal_brute_force(seed):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    middle, size = rng.uniform(-1, 1, (2, 12, 3))
    lower, upper = middle - np.abs(size) / 2, middle + np.abs(size) / 2
    radii = rng.uniform(0, 0.7, 12)
    for found, touched in (
        (asked.box_overlap(lower, upper), brute_force.boxes_touched(world, lower, upper)),
        (
            asked.sphere_overlap(middle, radii),
            brute_force.closest_points(world, middle)[0] <= radii[:, None],
        ),
    ):
        assert found.offsets.dtype == np.int64
        np.testing.assert_array_equal(found.counts, touched.sum(axis=1))
        which = np.nonzero(touched)[1]
        np.testing.assert_array_equal(found.triangle, world.triangle[which])
        np.testing.assert_array_equal(found.instance, world.instance[which])
    triangles = middle[:, None] + rng.uniform(-0.5, 0.5, (12, 3, 3))
    np.testing.assert_array_equal(
        asked.triangle_overlap(triangles), brute_force.triangles_touched(world, triangles)
    )
    assert asked.triangle_overlap(triangles.reshape(3, 4, 3, 3)).shape == (3, 4)


def test_points_that_make_no_sense_find_nothing(ball):
    asked = bw.Scene(ball)
    bad = [[np.nan, 0, 0], [np.inf, 0, 0]]
    assert not asked.closest_point(bad).found.any()
    assert not asked.closest_point([[0, 0, 3]], max_radius=np.nan).found.any()
    assert not asked.closest_point([[0, 0, 3]], max_radius=-1).found.any()
    assert np.isinf(asked.signed_distance(bad).distance).all()
    assert asked.winding_number(bad).tolist() == [0, 0]
    assert asked.sphere_overlap(bad, 1).counts.tolist() == [0, 0]
    assert asked.sphere_overlap([[0, 0, 1]], -1).counts.tolist() == [0]
    assert asked.box_overlap(bad, bad).counts.tolist() == [0, 0]
    assert not asked.triangle_overlap(np.full((3, 3), np.nan))


def test_an_open_mesh_says_that_signs_are_guesses():
    sheet = bw.Scene(bw.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    assert sheet.signed_distance([[0.2, 0.2, 1]]).is_undefined.all()
    assert not sheet.is_sign_trustworthy()
