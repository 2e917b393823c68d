# SPDX-License-Identifier: Apache-2.0
"""boxwood.trimesh in place of trimesh's own ray objects."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import boxwood as bw
from boxwood.trimesh import RayMeshIntersector, from_trimesh, to_trimesh

trimesh = pytest.importorskip("trimesh")


def with_boxwood(mesh):
    mesh.ray = RayMeshIntersector(mesh)
    return mesh


@pytest.fixture
def cube():
    return with_boxwood(trimesh.creation.box(extents=(2, 2, 2)))


@pytest.fixture
def sphere():
    return with_boxwood(trimesh.creation.icosphere(subdivisions=3))


def random_rays(count, seed=1):
    rng = np.random.default_rng(seed)
    origins = rng.uniform(-2, 2, (count, 3))
    return origins, rng.uniform(-0.7, 0.7, (count, 3)) - origins


def pairs(triangles, rays):
    return sorted(zip(rays.tolist(), triangles.tolist(), strict=True))


def test_ids_are_those_of_trimesh(sphere):
    pytest.importorskip("rtree")
    theirs = trimesh.ray.ray_triangle.RayMeshIntersector(sphere)
    rays = random_rays(300)
    for multiple_hits in (True, False):
        triangle, ray = sphere.ray.intersects_id(*rays, multiple_hits=multiple_hits)
        assert triangle.dtype == ray.dtype == np.int64
        expected = theirs.intersects_id(*rays, multiple_hits=multiple_hits)
        assert pairs(triangle, ray) == pairs(*expected)


def test_locations_are_those_of_trimesh(sphere):
    pytest.importorskip("rtree")
    theirs = trimesh.ray.ray_triangle.RayMeshIntersector(sphere)
    rays = random_rays(300)
    location, ray, triangle = sphere.ray.intersects_location(*rays)
    expected, expected_ray, expected_triangle = theirs.intersects_location(*rays)
    order = np.lexsort((triangle, ray))
    expected_order = np.lexsort((expected_triangle, expected_ray))
    assert np.allclose(location[order], expected[expected_order])
    found = sphere.ray.intersects_id(*rays, return_locations=True)
    assert len(found) == 3 and (found[2] == location).all()


def test_first_and_any_are_those_of_embree(sphere):
    pytest.importorskip("embreex")
    theirs = trimesh.ray.ray_pyembree.RayMeshIntersector(sphere)
    rays = random_rays(2000)
    first = sphere.ray.intersects_first(*rays)
    assert first.dtype == np.int64
    assert (first == theirs.intersects_first(*rays)).mean() > 0.998
    assert ((first >= 0) == sphere.ray.intersects_any(*rays)).all()
    assert (first == theirs.intersects_first(*rays))[first < 0].all()


def test_takes_the_arguments_of_either_of_trimeshs_objects(cube):
    origins, directions = [[0, 0, -5]], [[0, 0, 1]]
    cube.ray.intersects_id(origins, directions, True, 5, True)
    cube.ray.intersects_id(ray_origins=origins, ray_directions=directions, max_hits=5)
    cube.ray.intersects_location(origins, directions, multiple_hits=False)
    RayMeshIntersector(geometry=cube, scale_to_box=False)


def test_max_hits_keeps_the_nearest(cube):
    location, ray, _ = cube.ray.intersects_location([[0.3, 0.2, -5]] * 2, [[0, 0, 1]] * 2)
    assert ray.tolist() == [0, 0, 1, 1] and location[:, 2].tolist() == [-1, 1, -1, 1]
    location, ray, _ = cube.ray.intersects_location(
        [[0.3, 0.2, -5]] * 2, [[0, 0, 1]] * 2, max_hits=1
    )
    assert ray.tolist() == [0, 1] and location[:, 2].tolist() == [-1, -1]


def test_rays_that_miss_give_empty_arrays(sphere):
    origins = np.tile([0.0, 0.0, -5.0], (100, 1))
    directions = np.tile([0.0, 1.0, 0.0], (100, 1))
    triangle, ray, location = sphere.ray.intersects_id(origins, directions, return_locations=True)
    assert triangle.shape == ray.shape == (0,) and location.shape == (0, 3)
    assert (sphere.ray.intersects_first(origins, directions) == -1).all()
    assert not sphere.ray.intersects_any(origins, directions).any()


def test_no_rays_give_empty_arrays(sphere):
    assert sphere.ray.intersects_first([], []).shape == (0,)
    assert sphere.ray.intersects_any(np.empty((0, 3)), np.empty((0, 3))).shape == (0,)
    assert sphere.ray.contains_points(np.empty((0, 3))).shape == (0,)


def test_contains_scaled_vertices_and_the_center(cube):
    assert cube.ray.contains_points(cube.vertices / 1.5).all()
    assert not cube.ray.contains_points(cube.vertices * 1.5).any()
    assert cube.ray.contains_points([cube.center_mass]).all()
    far = np.random.default_rng(1).uniform(2, 100, (30, 3))
    assert not cube.ray.contains_points(far).any()
    assert cube.contains([[0, 0, 0], [0, 0, 3]]).tolist() == [True, False]


def test_rays_through_corners_hit_once(cube):
    directions = np.array(cube.vertices)
    origins = np.zeros_like(directions)
    assert cube.ray.intersects_any(origins, directions).all()
    _, ray, _ = cube.ray.intersects_location(origins, directions)
    assert (np.bincount(ray, minlength=len(origins)) == 1).all()


def test_points_in_line_with_edges_are_told_apart():
    box = with_boxwood(trimesh.creation.box(bounds=[[0, 0, 0], [4, 4, 4]]))
    points = [[2, 2, -3], [2, 2, 2], [1e-6, 2, 2], [-1e-6, 2, 2], [4, 4, 9], [0, 0, -1]]
    expected = [False, True, True, False, False, False]
    assert box.ray.contains_points(points).tolist() == expected


def test_a_camera_sees_front_and_back(cube):
    x, y = np.meshgrid(np.arange(-64, 64), np.arange(-64, 64))
    directions = np.stack([x.ravel(), y.ravel(), np.full(x.size, 500)], axis=1) + 0.25
    origins = np.tile([0.0, 0.0, -15.0], (len(directions), 1))
    first, _ = cube.ray.intersects_id(origins, directions, multiple_hits=False)
    assert len(np.unique(first)) == 2
    every, _ = cube.ray.intersects_id(origins, directions, multiple_hits=True)
    assert len(np.unique(every)) > 2


def test_hits_along_an_axis_are_on_the_box(cube):
    side = np.linspace(-1.02, 1.02, 100)
    x, y = np.meshgrid(side, side)
    origins = np.stack([x.ravel(), y.ravel(), np.full(x.size, -100.0)], axis=1)
    location, ray, _ = cube.ray.intersects_location(origins, np.tile([0, 0, 1.0], (x.size, 1)))
    assert (location[:, :2] == origins[ray][:, :2]).all()
    assert np.allclose(np.abs(location[:, 2]), 1)
    is_over = (np.abs(origins[:, :2]) <= 1).all(axis=1)
    assert (np.bincount(ray, minlength=x.size) == 2 * is_over).all()


def test_an_enormous_box_is_left_once():
    box = with_boxwood(trimesh.creation.box(extents=[10000] * 3))
    triangle, _ = box.ray.intersects_id([[0, 0, 5000 - 1e-9]], [[0, 0, -1.0]])
    assert len(triangle) == 1


def test_open_meshes_contain_by_winding_number(sphere):
    bowl = with_boxwood(sphere.submesh([np.arange(len(sphere.faces) - 30)], append=True))
    assert not bowl.is_watertight
    points = np.random.default_rng(2).uniform(-0.8, 0.8, (200, 3))
    inside = np.linalg.norm(points, axis=1) < 0.8
    assert (bowl.ray.contains_points(points) == sphere.contains(points))[inside].mean() > 0.97


def test_directions_need_not_have_unit_length(cube):
    location, _, _ = cube.ray.intersects_location([[0.1, 0.2, -5]], [[0, 0, 0.25]])
    assert location.tolist() == [[0.1, 0.2, -1], [0.1, 0.2, 1]]


def test_follows_a_mesh_that_changes(cube):
    ray = [[0.1, 0.2, -5]], [[0, 0, 1]]
    assert cube.ray.intersects_location(*ray)[0][0, 2] == -1
    assert cube.ray.scene is cube.ray.scene
    cube.apply_scale(2)
    assert cube.ray.intersects_location(*ray)[0][0, 2] == -2
    cube.vertices += [0, 0, 1]
    assert cube.ray.intersects_location(*ray)[0][0, 2] == -1


def test_trimeshs_own_queries_use_it(sphere):
    thickness = trimesh.proximity.thickness(sphere, [[0.9, 0, 0]], exterior=False, method="ray")
    assert thickness.shape == (1,)
    distance = trimesh.proximity.signed_distance(sphere, [[0, 0, 0.2], [0, 0, 2]])
    assert distance[0] > 0 > distance[1]


def test_copies_and_pickles(cube):
    for other in (copy.deepcopy(cube.ray), pickle.loads(pickle.dumps(cube.ray))):
        assert other.intersects_any([[0, 0, -5]], [[0, 0, 1]]).tolist() == [True]


@pytest.mark.parametrize(
    ("origins", "directions"),
    [([[0, 0, 0]], [[0, 0, 1], [0, 0, 1]]), ([0, 0, 0], [0, 0, 1]), ([[0, 0]], [[0, 1]])],
)
def test_refuses_rays_of_other_shapes(cube, origins, directions):
    with pytest.raises(ValueError, match="expected"):
        cube.ray.intersects_first(origins, directions)


def test_meshes_go_to_trimesh_and_back():
    mesh = bw.generate("icosphere", 320)
    rgb = np.random.default_rng(1).integers(0, 256, (len(mesh.vertices), 4)) / 255
    mesh.colors = bw.Attribute(rgb)
    mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
    mesh.fields["number"] = bw.Attribute(np.arange(len(mesh.faces)), "faces")
    back = from_trimesh(to_trimesh(mesh))
    assert (back.vertices == mesh.vertices).all() and (back.faces == mesh.faces).all()
    assert np.allclose(back.colors.values, rgb) and back.colors.of == "vertices"
    assert (back.fields["height"].values == mesh.vertices[:, 2]).all()
    assert back.fields["number"].of == "faces"


def test_colors_of_faces_go_to_trimesh_and_back():
    mesh = bw.generate("icosphere", 320)
    mesh.colors = bw.Attribute(np.tile([0.2, 0.4, 0.6, 1.0], (len(mesh.faces), 1)), "faces")
    back = from_trimesh(to_trimesh(mesh))
    assert back.colors.of == "faces" and np.allclose(back.colors.values, mesh.colors.values)
