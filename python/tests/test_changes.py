# SPDX-License-Identifier: Apache-2.0
"""Scenes whose vertices and instances move, but not under a query."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from random_scenes import placement

import boxwood as bw


def rays(n=300):
    rng = np.random.default_rng(2)
    return rng.uniform(-3, 3, (n, 3)), rng.uniform(-1, 1, (n, 3))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_after_a_refit_answers_are_those_of_a_new_scene(ball, dtype):
    rng = np.random.default_rng(1)
    mesh = bw.Mesh(ball.vertices.astype(dtype), ball.faces)
    scene = bw.Scene(mesh)
    inside = scene.signed_distance([[0, 0, 0.0]]).distance
    for _ in range(3):
        mesh.vertices[:] += rng.normal(0, 0.1, mesh.vertices.shape).astype(dtype)
        ratios = scene.refit()
        assert ratios.shape == (1,) and (ratios > 0).all()
        for question in ("closest_hit", "all_hits"):
            one, other = (getattr(s, question)(*rays()) for s in (scene, bw.Scene(mesh)))
            np.testing.assert_array_equal(one.t, other.t)
            np.testing.assert_array_equal(one.triangle, other.triangle)
        signs = [s.signed_distance(rays()[0]).distance for s in (scene, bw.Scene(mesh))]
        np.testing.assert_array_equal(*signs)
    assert scene.signed_distance([[0, 0, 0.0]]).distance != inside


def test_instances_move(ball):
    rng = np.random.default_rng(1)
    small = bw.generate("icosphere", 80)
    scene = bw.Scene([ball, small])
    trees = scene.statistics
    instances = [bw.Instance(mesh, placement(rng), 5) for mesh in (small, ball, ball)]
    scene.set_instances(instances)
    fresh = bw.Scene(instances)
    one, other = (s.closest_hit(*rays(), visibility=4) for s in (scene, fresh))
    np.testing.assert_array_equal(one.t, other.t)
    np.testing.assert_array_equal(one.instance, other.instance)
    assert scene.statistics == trees
    # What is in the array counts at the next call.
    instances[0].transform[:3, 3] += 1
    scene.set_instances(instances)
    np.testing.assert_array_equal(
        scene.closest_hit(*rays()).t, bw.Scene(instances).closest_hit(*rays()).t
    )
    with pytest.raises(ValueError, match="another mesh"):
        scene.set_instances([bw.generate("icosphere", 20)])
    flat = np.diag([1.0, 1, 0, 1])
    with pytest.raises(ValueError, match="instance 0"):
        scene.set_instances([bw.Instance(ball, flat)])
    np.testing.assert_array_equal(
        scene.closest_hit(*rays()).t, bw.Scene(instances).closest_hit(*rays()).t
    )


def test_an_opened_scene_has_no_vertices_to_move(ball, tmp_path):
    bw.Scene(ball).save(tmp_path / "ball.boxwood")
    scene = bw.open(tmp_path / "ball.boxwood")
    expected = scene.closest_hit(*rays()).t
    with pytest.raises(ValueError):
        scene.meshes[0].vertices[:] = 0
    try:
        scene.refit()
    except (ValueError, RuntimeError):
        pass
    np.testing.assert_array_equal(scene.closest_hit(*rays()).t, expected)


@pytest.mark.parametrize(
    "change", [lambda s: s.refit(), lambda s: s.set_instances(s.instances)], ids=["refit", "set"]
)
def test_no_change_under_a_query(ball, change):
    scene = bw.Scene(ball)
    origins = np.tile(rays()[0], (1000, 1))
    seen = []

    def report(part):
        if part == 1:
            return
        with pytest.raises(RuntimeError, match="while queries run"):
            change(scene)
        other = threading.Thread(target=from_another_thread)
        other.start()
        other.join()
        seen.append(part)

    def from_another_thread():
        with pytest.raises(RuntimeError, match="while queries run"):
            change(scene)

    # Until it takes long enough for a report before the last.
    for _ in range(20):
        with bw.thread_limit(1):
            scene.signed_distance(origins, method="winding_number", progress=report)
        if seen:
            break
        origins = np.tile(origins, (2, 1))
    assert seen
    change(scene)


def test_changes_and_queries_of_many_threads_are_let_in_or_turned_away(ball):
    mesh = bw.Mesh(ball.vertices.copy(), ball.faces)
    scene = bw.Scene(mesh)
    expected = scene.closest_hit(*rays()).t
    wrong, done = [], threading.Event()

    def ask():
        while not done.is_set():
            try:
                if not (scene.closest_hit(*rays()).t == expected).all():
                    wrong.append("another answer")
            except RuntimeError:
                pass

    threads = [threading.Thread(target=ask) for _ in range(3)]
    for thread in threads:
        thread.start()
    changes = 0
    for _ in range(300):
        try:
            scene.refit()
            scene.set_instances(scene.instances)
            changes += 1
        except RuntimeError:
            pass
    done.set()
    for thread in threads:
        thread.join()
    assert not wrong
