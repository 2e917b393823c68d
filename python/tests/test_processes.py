# SPDX-License-Identifier: Apache-2.0
"""Processes that fork or spawn after a scene was built and asked."""

from __future__ import annotations

import multiprocessing
import os
import threading
import time
import warnings

import numpy as np
import pytest

import boxwood as bw

RAYS = 20_000
pytestmark = pytest.mark.filterwarnings("ignore:.*multi-threaded:DeprecationWarning")


def rays():
    rng = np.random.default_rng(1)
    return rng.uniform(-1, 1, (RAYS, 3)), rng.normal(size=(RAYS, 3))


def answer(scene):
    """By several threads, after a build."""
    again = bw.Scene(scene.meshes[0])
    results = [None] * 4

    def ask(i):
        results[i] = (again if i % 2 else scene).closest_hit(*rays()).t

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((result == results[0]).all() for result in results)
    return results[0]


@pytest.fixture(scope="module")
def scene():
    return bw.Scene(bw.generate("torus_knot", 20_000))


def in_child(work):
    """Whether work() in a forked child ends well, within a minute."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            status = 0 if work() else 2
        finally:
            os._exit(status)
    for _ in range(6000):
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return status == 0
        time.sleep(0.01)
    os.kill(child, 9)
    os.waitpid(child, 0)
    pytest.fail("the child hangs")


needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")


@needs_fork
def test_a_forked_child_asks_and_builds_and_so_does_its_parent(scene):
    expected = answer(scene)
    for _ in range(3):
        assert in_child(lambda: (answer(scene) == expected).all())
        assert (answer(scene) == expected).all()


@needs_fork
@pytest.mark.parametrize("meanwhile", ["asks", "has asked"])
def test_fork_while_another_thread_lives(scene, meanwhile):
    expected = answer(scene)
    done, started = threading.Event(), threading.Event()
    origins, directions = (np.tile(x, (10, 1)) for x in rays())

    def other():
        scene.any_hit(origins, directions)
        started.set()
        while not done.is_set():
            if meanwhile == "asks":
                scene.any_hit(origins, directions)
            else:
                done.wait()

    thread = threading.Thread(target=other)
    thread.start()
    try:
        started.wait()
        for _ in range(3):
            # The child's child, too: it has what its parent has of threads.
            assert in_child(
                lambda: (
                    (answer(scene) == expected).all()
                    and in_child(lambda: (answer(scene) == expected).all())
                )
            )
            assert (answer(scene) == expected).all()
    finally:
        done.set()
        thread.join()


@pytest.mark.parametrize(
    "method", [m for m in ("fork", "spawn") if m in multiprocessing.get_all_start_methods()]
)
def test_a_pool_of_processes_answers(scene, method, tmp_path):
    expected = answer(scene)
    scene.save(tmp_path / "knot.boxwood")
    with multiprocessing.get_context(method).Pool(2) as pool:
        for result in pool.map(answer, [scene, bw.open(tmp_path / "knot.boxwood")], chunksize=1):
            np.testing.assert_array_equal(result, expected)
    with warnings.catch_warnings():
        warnings.simplefilter("error", ResourceWarning)
        assert (answer(scene) == expected).all()


@needs_fork
def test_fork_from_a_progress_function(scene):
    """It doesn't wait for the query that it is part of."""
    expected, children = answer(scene), []

    def report(part):
        if not children:
            children.append(in_child(lambda: (answer(scene) == expected).all()))

    scene.any_hit(*rays(), progress=report)
    assert children == [True]


@needs_fork
def test_fork_while_another_thread_builds(scene):
    expected, done = answer(scene), threading.Event()

    def build():
        while not done.is_set():
            bw.Scene(scene.meshes[0])

    thread = threading.Thread(target=build)
    thread.start()
    try:
        for _ in range(3):
            assert in_child(lambda: (answer(scene) == expected).all())
    finally:
        done.set()
        thread.join()
