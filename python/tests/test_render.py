# SPDX-License-Identifier: Apache-2.0
"""Pictures of meshes, scenes and files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import boxwood as bw

EXAMPLES = Path(__file__).parents[2] / "examples"
SMALL = {"width": 64, "height": 48}


def test_a_mesh_is_framed_and_lit(ball):
    image = bw.render(ball, **SMALL)
    assert image.pixels.shape == (48, 64, 3)
    assert np.isfinite(image.pixels).all()
    middle, corner = image.numpy()[24, 32], image.numpy()[0, 0]
    assert np.abs(middle.astype(int) - corner).max() > 20


def test_a_camera_says_what_is_seen_and_how_large(ball):
    for camera in (
        bw.PinholeCamera([0, 0, 4], [0, 0, 0], width=40, height=30),
        bw.OrthographicCamera([0, 0, 4], [0, 0, 0], view_height=3, width=40, height=30),
    ):
        hits = bw.Scene(ball).closest_hit(*camera.rays())
        image = bw.render(ball, camera=camera, integrator="normal", samples=1)
        assert (image.width, image.height) == (40, 30)
        seen = (image.pixels != image.pixels[0, 0]).any(axis=2)
        assert np.mean(seen == hits.hit) > 0.95
    assert bw.render(ball, camera=camera, width=20).pixels.shape == (30, 20, 3)


def test_a_scene_of_instances_is_the_mesh_of_all_of_them(ball):
    aside = np.eye(4)
    aside[0, 3] = 2.5
    scene = bw.Scene([ball, bw.Instance(ball, aside), bw.Instance(ball, aside @ aside, 0)])
    camera = bw.PinholeCamera([1, 2, 6], [1, 0, 0], **SMALL)
    both = bw.Mesh(
        np.vstack([ball.vertices, ball.vertices + aside[:3, 3]]),
        np.vstack([ball.faces, ball.faces + len(ball.vertices)]),
    )
    for integrator in ("phong", "whitted", "normal", "depth"):
        one, other = (
            bw.render(what, camera=camera, integrator=integrator, samples=1)
            for what in (scene, both)
        )
        # Lights stand by the bounds of what is there.
        assert np.abs(one.pixels - other.pixels).mean() < 0.05


def test_culled_meshes_show_their_backs_to_nobody(ball):
    inside_out = bw.Mesh(ball.vertices, ball.faces[:, ::-1])
    camera = bw.PinholeCamera([0, 0, 4], [0, 0, 0], **SMALL)
    pictures = [
        bw.render(bw.Scene(mesh, cull_back_faces=culls), camera=camera, integrator="depth")
        for mesh, culls in ((ball, True), (inside_out, True), (inside_out, False))
    ]
    assert (pictures[0].pixels != pictures[1].pixels).any()
    np.testing.assert_allclose(pictures[0].pixels, pictures[2].pixels, atol=1e-9)


def test_scene_files_are_rendered_as_they_say():
    file = EXAMPLES / "scene" / "scene.json"
    if not file.exists():
        pytest.skip("the examples are beside the sources only")
    image = bw.render(file, width=32, height=24)
    assert image.pixels.shape == (24, 32, 3) and image.pixels.max() > image.pixels.min()


def test_mesh_files_are_rendered(ball, tmp_path):
    ball.save(tmp_path / "ball.ply")
    for up in ("y", "z"):
        np.testing.assert_array_equal(
            bw.render(tmp_path / "ball.ply", up=up, **SMALL).numpy(),
            bw.render(str(tmp_path / "ball.ply"), up=up, **SMALL).numpy(),
        )
    with pytest.raises(OSError):
        bw.render(tmp_path / "none.ply")


def test_the_same_seed_makes_the_same_picture(ball):
    pictures = [bw.render(ball, samples=4, seed=seed, **SMALL).pixels for seed in (1, 1, 2)]
    np.testing.assert_array_equal(pictures[0], pictures[1])
    with bw.thread_limit(1):
        np.testing.assert_array_equal(
            bw.render(ball, samples=4, seed=1, **SMALL).pixels, pictures[0]
        )
    assert (pictures[0] != pictures[2]).any()


def test_colors_of_a_mesh_are_its_own(ball):
    mesh = bw.Mesh(ball.vertices, ball.faces)
    mesh.colors = bw.Attribute(np.tile(np.float32([1, 0, 0, 1]), (len(mesh.vertices), 1)))
    pixel = bw.render(mesh, **SMALL).numpy()[24, 32].astype(int)
    assert pixel[0] > pixel[1] + 30 and pixel[0] > pixel[2] + 30
