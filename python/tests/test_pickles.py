# SPDX-License-Identifier: Apache-2.0
"""Scenes go through pickles and files and answer as before."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
from random_scenes import placement, soup

import boxwood as bw


def scene_of_instances(dtype=np.float64):
    """Culled and not, in float or double, several instances with masks, one mesh without any."""
    rng = np.random.default_rng(3)
    first, second, third = (
        bw.Mesh(vertices.astype(dtype), faces)
        for vertices, faces in (soup(rng, 30), soup(rng, 10), soup(rng, 20))
    )
    scene = bw.Scene([first, second, third], cull_back_faces=[True, False, True], preset="fast")
    # In another order than the meshes, so that culling could go to the wrong one.
    scene.set_instances(
        [
            bw.Instance(third, placement(rng), 6),
            bw.Instance(first, placement(rng), 3),
            bw.Instance(third),
        ]
    )
    return scene


def answers(scene):
    rng = np.random.default_rng(4)
    origins, directions = rng.uniform(-2, 2, (500, 3)), rng.uniform(-1, 1, (500, 3))
    hits = scene.closest_hit(origins, directions, visibility=rng.integers(0, 8, 500))
    points = scene.closest_point(origins)
    return [hits.t, hits.triangle, hits.instance, hits.uv, points.distance, points.instance]


def same(one, other):
    return all((a == b).all() for a, b in zip(answers(one), answers(other), strict=True))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_pickle_holds_the_scene(dtype):
    scene = scene_of_instances(dtype)
    for again in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene), copy.copy(scene)):
        assert same(again, scene)
        assert len(again.meshes) == len(scene.meshes) == 3
        assert again.meshes[0].vertices.dtype == dtype
        assert again.instances[0].mesh is again.meshes[2]
        assert again.instances[0].visibility == 6


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_file_holds_the_scene(dtype, tmp_path):
    scene = scene_of_instances(dtype)
    path = tmp_path / "scene.boxwood"
    scene.save(path)
    for trust in (False, True):
        opened = bw.open(path, trust=trust)
        assert same(opened, scene)
        assert opened.meshes[0].vertices.dtype == np.float64
        np.testing.assert_array_equal(opened.meshes[0].vertices, scene.meshes[0].vertices)
        np.testing.assert_array_equal(opened.instances[0].transform, scene.instances[0].transform)
        assert [i.visibility for i in opened.instances] == [i.visibility for i in scene.instances]


def test_rays_in_float_find_the_same_in_a_file(ball, tmp_path):
    rng = np.random.default_rng(5)
    scene = bw.Scene(bw.Mesh(np.float32(ball.vertices), ball.faces))
    scene.save(tmp_path / "ball.boxwood")
    directions = rng.standard_normal((1000, 3), np.float32)
    one, other = (
        s.closest_hit(np.float32([0.1, 0.2, 0.3]), directions)
        for s in (scene, bw.open(tmp_path / "ball.boxwood"))
    )
    np.testing.assert_array_equal(one.t, other.t)
    np.testing.assert_array_equal(one.triangle, other.triangle)


def test_a_pickle_of_an_opened_scene_holds_the_path_alone(tmp_path):
    scene = scene_of_instances()
    scene.save(tmp_path / "scene.boxwood")
    opened = bw.open(tmp_path / "scene.boxwood")
    content = pickle.dumps(opened)
    assert len(content) < 1000 and str(tmp_path).encode() in content
    assert same(pickle.loads(content), scene)
    # Once it differs from the file, it goes by value.
    opened.set_instances(opened.instances[1:])
    again = pickle.loads(pickle.dumps(opened))
    assert same(again, opened) and not same(again, scene)


def test_a_pickle_of_a_mesh_holds_what_belongs_to_it(ball):
    mesh = bw.Mesh(np.float32(ball.vertices), ball.faces)
    mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
    mesh.groups = bw.Labels(["all"], np.zeros(len(mesh.faces), np.uint32))
    again = pickle.loads(pickle.dumps(mesh))
    np.testing.assert_array_equal(again.vertices, mesh.vertices)
    np.testing.assert_array_equal(again.faces, mesh.faces)
    np.testing.assert_array_equal(again.fields["height"].values, mesh.fields["height"].values)
    assert again.vertices.dtype == np.float32 and again.groups.names == ["all"]


def test_answers_pickle(ball):
    hits = bw.Scene(ball).closest_hit([[0, 0, 5.0]], [0, 0, -1.0])
    again = pickle.loads(pickle.dumps(hits))
    assert (again.t == hits.t).all() and (again.triangle == hits.triangle).all()


def test_names_of_files_may_be_any_bytes(ball, tmp_path):
    for name in ("gr\u00f6\u00dfe", "\udcff"):
        ball.save(tmp_path / f"{name}.ply")
        assert len(bw.load(tmp_path / f"{name}.ply").faces) == len(ball.faces)
        bw.Scene(ball).save(tmp_path / f"{name}.boxwood")
        assert bw.open(tmp_path / f"{name}.boxwood").any_hit([0, 0, 5], [0, 0, -1])
        bw.Image(np.zeros((2, 2))).save(tmp_path / f"{name}.png")


def test_what_is_no_scene_is_refused(ball, tmp_path):
    with pytest.raises(OSError, match="nothing"):
        bw.open(tmp_path / "nothing.boxwood")
    (tmp_path / "text.boxwood").write_text("hello")
    with pytest.raises(bw.ParseError):
        bw.open(tmp_path / "text.boxwood")
    with pytest.raises(OSError):
        bw.Scene(ball).save(tmp_path / "no" / "folder.boxwood")
