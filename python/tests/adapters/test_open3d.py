# SPDX-License-Identifier: Apache-2.0
"""boxwood.open3d against Open3D's own RaycastingScene, where that is installed."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw
from boxwood.open3d import RaycastingScene, from_open3d, to_open3d


@pytest.fixture(scope="module")
def open3d():
    # Open3D may be installed, and a library of the system that it needs not.
    return pytest.importorskip("open3d", exc_type=ImportError)


def two_balls():
    ball = bw.generate("icosphere", 1280)
    return ball, bw.Mesh(0.5 * ball.vertices + np.array([2, 0, 0]), ball.faces)


@pytest.fixture
def scene():
    result = RaycastingScene()
    assert [result.add_triangles(mesh) for mesh in two_balls()] == [0, 1]
    return result


@pytest.fixture
def theirs(open3d):
    result = open3d.t.geometry.RaycastingScene()
    for mesh in two_balls():
        result.add_triangles(to_open3d(mesh))
    return result


def random_rays(count=2000):
    rng = np.random.default_rng(1)
    origins = rng.uniform(-3, 3, (count, 3))
    targets = rng.uniform([-1, -1, -1], [3, 1, 1], (count, 3))
    return np.concatenate([origins, targets - origins], axis=1).astype(np.float32)


def random_points(count=2000):
    points = np.random.default_rng(2).uniform([-2, -2, -2], [3, 2, 2], (count, 3))
    return points.astype(np.float32)


def same(found, expected, part=1.0):
    expected = expected.numpy()
    assert found.shape == expected.shape and found.dtype == expected.dtype
    agree = np.isclose(found, expected, atol=1e-4)
    return agree.mean() >= part


def test_answers_are_shaped_as_the_rays_are(scene):
    answers = scene.cast_rays(random_rays(24).reshape(2, 3, 4, 6))
    assert {key: (value.shape, value.dtype.name) for key, value in answers.items()} == {
        "t_hit": ((2, 3, 4), "float32"),
        "geometry_ids": ((2, 3, 4), "uint32"),
        "primitive_ids": ((2, 3, 4), "uint32"),
        "primitive_uvs": ((2, 3, 4, 2), "float32"),
        "primitive_normals": ((2, 3, 4, 3), "float32"),
    }


def test_misses_are_marked(scene):
    answers = scene.cast_rays([[0, 5, 5, 0, 0, -1]])
    assert answers["t_hit"].tolist() == [np.inf]
    assert answers["geometry_ids"][0] == answers["primitive_ids"][0] == RaycastingScene.INVALID_ID
    assert not answers["primitive_uvs"].any() and not answers["primitive_normals"].any()


def test_double_stays_double(scene):
    rays = random_rays().astype(np.float64)
    assert scene.cast_rays(rays)["t_hit"].dtype == np.float64
    assert scene.compute_distance(rays[:, :3]).dtype == np.float64


def test_geometries_may_be_added_between_questions():
    ray = [[0, 0, 9, 0, 0, -1]]
    ball = bw.generate("icosphere", 1280)
    scene = RaycastingScene(nthreads=1)
    assert scene.cast_rays(ray)["t_hit"].tolist() == [np.inf]
    scene.add_triangles(ball)
    assert scene.cast_rays(ray)["t_hit"].tolist() == [8]
    assert scene.add_triangles(ball.vertices + np.array([0, 0, 3]), ball.faces) == 1
    assert scene.cast_rays(ray)["geometry_ids"].tolist() == [1]


def test_rays_of_six_numbers_are_wanted(scene):
    with pytest.raises(ValueError, match=r"expected shape \(\.\.\., 6\)"):
        scene.cast_rays(np.zeros((4, 3)))


def test_casts_rays_as_open3d_does(scene, theirs):
    rays = random_rays()
    expected = theirs.cast_rays(rays)
    found = scene.cast_rays(rays)
    assert found.keys() == set(expected)
    for key, values in found.items():
        assert same(values, expected[key], 0.998), key


def test_tests_occlusion_as_open3d_does(scene, theirs):
    rays = random_rays()
    assert same(scene.test_occlusions(rays), theirs.test_occlusions(rays), 0.998)
    found = scene.test_occlusions(rays, tnear=0.5, tfar=1.0)
    assert same(found, theirs.test_occlusions(rays, tnear=0.5, tfar=1.0), 0.998)


def test_lists_intersections_as_open3d_does(scene, theirs):
    rays = random_rays(300)
    assert same(scene.count_intersections(rays), theirs.count_intersections(rays))
    expected = theirs.list_intersections(rays)
    found = scene.list_intersections(rays)
    assert found.keys() == set(expected)
    for key, values in found.items():
        assert same(values, expected[key]), key


def test_finds_closest_points_as_open3d_does(scene, theirs):
    points = random_points()
    assert same(scene.compute_distance(points), theirs.compute_distance(points))
    expected = theirs.compute_closest_points(points)
    found = scene.compute_closest_points(points)
    assert found.keys() == set(expected)
    assert same(found["points"], expected["points"], 0.99)
    assert same(found["geometry_ids"], expected["geometry_ids"])
    # Of triangles that are equally near either will do.
    assert same(found["primitive_ids"], expected["primitive_ids"], 0.5)


def test_knows_the_inside_as_open3d_does(scene, theirs):
    points = random_points().reshape(20, 100, 3)
    found = scene.compute_signed_distance(points)
    assert same(found, theirs.compute_signed_distance(points, nsamples=5))
    occupancy = scene.compute_occupancy(points)
    assert same(occupancy, theirs.compute_occupancy(points, nsamples=5))
    assert 0 < occupancy.mean() < 1


def test_makes_the_rays_of_a_pinhole_camera_as_open3d_does(scene, theirs):
    camera = dict(fov_deg=60, center=[0.5, 0, 0], eye=[-1, -4, 3], up=[0, 0, 1])
    rays = scene.create_rays_pinhole(**camera, width_px=32, height_px=24)
    assert same(rays, theirs.create_rays_pinhole(**camera, width_px=32, height_px=24))


def test_meshes_go_to_open3d_and_back(open3d):
    mesh = bw.generate("icosphere", 320)
    rgb = np.random.default_rng(1).uniform(0, 1, (len(mesh.vertices), 4)).astype(np.float32)
    mesh.colors = bw.Attribute(rgb)
    tensors = to_open3d(mesh)
    for back in (from_open3d(tensors), from_open3d(tensors.to_legacy())):
        assert (back.faces == mesh.faces).all()
        assert np.allclose(back.vertices, mesh.vertices)
        assert np.allclose(back.colors.values[:, :3], rgb[:, :3], atol=1e-6)


def test_tensors_are_taken_as_rays(open3d, scene):
    rays = open3d.core.Tensor(random_rays())
    assert scene.cast_rays(rays)["t_hit"].shape == (2000,)
