# SPDX-License-Identifier: Apache-2.0
"""Who asks how far the work has come is told, and may stop it."""

from __future__ import annotations

import builtins
import threading

import numpy as np
import pytest

import boxwood as bw


@pytest.fixture(scope="module")
def scene():
    return bw.Scene(bw.generate("torus_knot", 5_000))


def work(scene, n=40_000):
    rng = np.random.default_rng(1)
    origins, directions = rng.uniform(-1, 1, (n, 3)), rng.normal(size=(n, 3))
    corners = origins.repeat(3, 0).reshape(-1, 3, 3)
    return {
        "closest_hit": lambda **p: scene.closest_hit(origins, directions, **p),
        "closest_hit in float": lambda **p: scene.closest_hit(
            np.float32(origins), np.float32(directions), **p
        ),
        "any_hit in float": lambda **p: scene.any_hit(
            np.float32(origins), np.float32(directions), **p
        ),
        "any_hit": lambda **p: scene.any_hit(origins, directions, **p),
        "all_hits": lambda **p: scene.all_hits(origins, directions, **p),
        "count_hits": lambda **p: scene.count_hits(origins, directions, **p),
        "first_k_hits": lambda **p: scene.first_k_hits(origins, directions, 3, **p),
        "closest_point": lambda **p: scene.closest_point(origins, **p),
        "signed_distance": lambda **p: scene.signed_distance(origins, **p),
        "winding_number": lambda **p: scene.winding_number(origins, **p),
        "box_overlap": lambda **p: scene.box_overlap(origins, origins + 0.01, **p),
        "sphere_overlap": lambda **p: scene.sphere_overlap(origins, 0.01, **p),
        "triangle_overlap": lambda **p: scene.triangle_overlap(corners, **p),
        "render": lambda **p: bw.render(scene, width=160, height=120, **p),
    }


KINDS = list(work(None, 1))


@pytest.mark.parametrize("kind", KINDS)
def test_progress_grows_to_one_on_the_thread_that_asked(scene, kind):
    parts, threads = [], set()

    def report(part):
        parts.append(part)
        threads.add(threading.get_ident())

    work(scene)[kind](progress=report)
    assert parts == sorted(parts) and 0 <= parts[0] and parts[-1] == 1
    assert threads == {threading.get_ident()}


@pytest.mark.parametrize("kind", KINDS)
def test_what_a_progress_function_raises_is_raised(scene, kind):
    class EnoughError(Exception):
        pass

    def report(part):
        raise EnoughError(part)

    with pytest.raises(EnoughError):
        work(scene)[kind](progress=report)
    assert scene.any_hit([0, 0, 5], [0, 0, -1]) in (True, False)


def test_nothing_to_do_is_all_done(scene):
    parts = []
    scene.any_hit(np.empty((0, 3)), [0, 0, 1], progress=parts.append)
    assert parts == [1]


def test_a_progress_function_may_ask(scene):
    answers = []
    scene.any_hit(
        np.zeros((50_000, 3)),
        [0, 0, 1],
        progress=lambda part: answers.append(scene.closest_hit([0, 0, 5], [0, 0, -1]).t),
    )
    assert answers


def test_there_is_a_bar(scene, capsys):
    pytest.importorskip("tqdm")
    scene.any_hit(np.zeros((1000, 3)), [0, 0, 1], progress=True)
    assert "any hits: 100%" in capsys.readouterr().err


def test_without_tqdm_there_is_none(scene, monkeypatch, capsys):
    real = builtins.__import__

    def without(name, *args, **options):
        if name.startswith("tqdm"):
            raise ImportError(name)
        return real(name, *args, **options)

    monkeypatch.setattr(builtins, "__import__", without)
    assert not scene.any_hit([[9, 9, 9]], [0, 0, 1], progress=True).any()
    assert capsys.readouterr().err == ""
