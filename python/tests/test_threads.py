# SPDX-License-Identifier: Apache-2.0
"""Threads of Python ask side by side, and go on while there is work."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import boxwood as bw


@pytest.fixture(scope="module")
def knot():
    return bw.generate("torus_knot", 20_000)


@pytest.fixture(scope="module")
def asked(knot):
    rng = np.random.default_rng(1)
    return bw.Scene(knot), rng.uniform(-1, 1, (20_000, 3)), rng.normal(size=(20_000, 3))


def questions(asked):
    scene, origins, directions = asked
    return [
        lambda: scene.closest_hit(origins, directions).t,
        lambda: scene.closest_hit(np.float32(origins), np.float32(directions)).t,
        lambda: scene.any_hit(origins, directions),
        lambda: scene.all_hits(origins, directions).t,
        lambda: scene.closest_point(origins).distance,
        lambda: scene.signed_distance(origins).distance,
        lambda: scene.winding_number(origins),
        lambda: scene.sphere_overlap(origins, 0.01).triangle,
    ]


def test_many_threads_get_the_same_answers(asked):
    expected = [ask() for ask in questions(asked)]
    fresh = (bw.Scene(asked[0].meshes[0]), *asked[1:])
    with ThreadPoolExecutor(8) as pool:
        for _ in range(3):
            answers = list(pool.map(lambda ask: ask(), 2 * questions(fresh)))
            for answer, right in zip(answers, 2 * expected, strict=True):
                np.testing.assert_array_equal(answer, right)


def test_one_thread_gets_the_same_answers(asked):
    expected = [ask() for ask in questions(asked)]
    with bw.thread_limit(1):
        for ask, right in zip(questions(asked), expected, strict=True):
            np.testing.assert_array_equal(ask(), right)


@pytest.mark.parametrize("work", ["build", "batch", "tree", "picture", "mesh"])
def test_other_threads_go_on_meanwhile(asked, knot, work):
    """The work takes no longer than it takes the other thread to count, if that can count."""
    scene, origins, directions = asked
    origins, directions = np.tile(origins, (8, 1)), np.tile(directions, (8, 1))
    do = {
        "build": lambda: bw.Scene(knot, method="sweep_sah"),
        "batch": lambda: scene.closest_hit(origins, directions),
        "tree": lambda: bw.build(knot, "sweep_sah"),
        "picture": lambda: bw.render(scene, width=320, height=240),
        "mesh": lambda: bw.generate("torus_knot", 200_000),
    }[work]
    done, counted = threading.Event(), []

    def count():
        # A turn needs the interpreter's lock and lets the others have it.
        while not done.wait(0.0005):
            counted.append(1)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        for _ in range(20):
            before = len(counted)
            do()
            if len(counted) > before + 2:
                break
        else:
            pytest.fail("the other thread stood still")
    finally:
        done.set()
        thread.join()
