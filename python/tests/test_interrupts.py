# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C ends long work."""

from __future__ import annotations

import signal
import threading
import time

import numpy as np
import pytest

import boxwood as bw


@pytest.fixture(scope="module")
def scene():
    return bw.Scene(bw.generate("torus_knot", 20_000))


@pytest.mark.parametrize(
    "kind",
    ["closest_hit", "float", "all_hits", "closest_point", "signed_distance", "winding", "render"],
)
def test_ctrl_c_ends_it(scene, kind):
    n = 3_000_000
    one = np.array([0.3, 0.2, 0.1])
    points = np.random.default_rng(1).normal(size=(n, 3))
    single = np.float32(points)
    work = {
        "closest_hit": lambda: scene.closest_hit(one, points),
        "float": lambda: [scene.closest_hit(np.float32(one), single) for _ in range(9)],
        "all_hits": lambda: scene.all_hits(one, points),
        "closest_point": lambda: scene.closest_point(points),
        "signed_distance": lambda: scene.signed_distance(points),
        "winding": lambda: scene.winding_number(points),
        "render": lambda: bw.render(scene, width=4000, height=3000, samples=16),
    }[kind]
    pressed = []

    def press():
        pressed.append(time.perf_counter())
        signal.raise_signal(signal.SIGINT)

    timer = threading.Timer(0.1, press)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
        # 0.2 s where nothing else runs; all of the work takes seconds.
        assert time.perf_counter() - pressed[0] < 1
    finally:
        timer.join()
    # All goes on.
    assert scene.closest_hit(one, points[:1000]).t.shape == (1000,)
