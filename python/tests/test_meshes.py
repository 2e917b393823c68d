# SPDX-License-Identifier: Apache-2.0
"""Meshes and their files."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import boxwood as bw


def full_mesh():
    """One with all that may belong to a mesh."""
    mesh = bw.generate("icosphere", 80)
    n, m = len(mesh.vertices), len(mesh.faces)
    rng = np.random.default_rng(1)
    mesh.normals = bw.Attribute(np.float32(mesh.vertices))
    mesh.texture_coordinates = bw.Attribute(rng.random((n, 2), np.float32))
    # As eight bits keep them.
    mesh.colors = bw.Attribute(np.float32(rng.integers(0, 256, (n, 4)) / 255))
    mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
    mesh.fields["area"] = bw.Attribute(rng.random(m), "faces")
    return mesh


@pytest.mark.parametrize("extension", ["obj", "ply", "stl", "off", "gltf", "glb", "ply.gz"])
def test_what_is_saved_is_loaded(tmp_path, extension):
    mesh = full_mesh()
    path = tmp_path / f"mesh.{extension}"
    if extension == "ply.gz":
        import gzip

        mesh.save(tmp_path / "mesh.ply")
        path.write_bytes(gzip.compress((tmp_path / "mesh.ply").read_bytes()))
    else:
        mesh.save(path)
    again = bw.load(path)
    assert again.vertices.dtype == np.float64 and again.faces.dtype == np.int32
    np.testing.assert_allclose(again.vertices[again.faces], mesh.vertices[mesh.faces], atol=1e-6)
    if extension in ("obj", "ply", "gltf", "glb", "ply.gz"):
        for name in ("normals", "texture_coordinates"):
            one, other = getattr(again, name), getattr(mesh, name)
            assert one.of in ("vertices", "corners")
            places = again.faces.reshape(-1) if one.of == "vertices" else slice(None)
            np.testing.assert_allclose(
                one.values[places], other.values[mesh.faces.reshape(-1)], atol=1e-6
            )
    if extension.startswith("ply"):
        np.testing.assert_allclose(again.colors.values, mesh.colors.values, atol=1 / 255)
        for name, field in mesh.fields.items():
            np.testing.assert_array_equal(again.fields[name].values, field.values)
            assert again.fields[name].of == field.of


def test_labels_go_through_obj_files(tmp_path):
    mesh = bw.generate("icosphere", 20)
    mesh.groups = bw.Labels(["left", "right"], np.arange(20) % 2)
    mesh.save(tmp_path / "mesh.obj")
    again = bw.load(tmp_path / "mesh.obj")
    named = [again.groups.names[i] for i in again.groups.of_face]
    assert named == [["left", "right"][i % 2] for i in range(20)]


def test_what_is_tolerated_is_a_warning(tmp_path):
    (tmp_path / "odd.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\nxyzzy 3\n")
    with pytest.warns(bw.MeshWarning) as found:
        bw.load(tmp_path / "odd.obj")
    assert any("xyzzy" in str(w.message) or "nan" in str(w.message).lower() for w in found)
    assert all(w.filename == __file__ for w in found)


def test_what_is_not_tolerated_names_the_place(tmp_path):
    (tmp_path / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
    with pytest.raises(bw.ParseError, match=r"bad\.obj.*2"):
        bw.load(tmp_path / "bad.obj")
    with pytest.raises(OSError, match=r"none\.obj"):
        bw.load(tmp_path / "none.obj")
    with pytest.raises(ValueError, match="xyz"):
        bw.load(tmp_path / "mesh.xyz")
    assert issubclass(bw.ParseError, ValueError)


def test_files_that_are_saved_appear_whole(tmp_path):
    with pytest.raises(OSError):
        bw.generate("icosphere", 20).save(tmp_path / "no" / "mesh.ply")
    assert list(tmp_path.iterdir()) == []


def test_repairs():
    ball = bw.generate("icosphere", 80)
    soup = bw.Mesh(ball.vertices[ball.faces].reshape(-1, 3), np.arange(240).reshape(-1, 3))
    assert soup.inspect()["duplicate_vertices"] == 240 - len(ball.vertices)
    welded = soup.repaired("weld")
    assert welded.inspect()["closed"] and len(welded.vertices) == len(ball.vertices)
    turned = ball.faces.copy()
    turned[::3] = turned[::3, ::-1]
    turned = bw.Mesh(ball.vertices, turned)
    assert turned.inspect()["flipped_edges"] > 0
    assert turned.repaired("orient").inspect()["flipped_edges"] == 0
    flat = bw.Mesh(ball.vertices, np.vstack([ball.faces, [[0, 0, 1]]]))
    assert len(flat.repaired("drop-degenerate").faces) == 80
    assert len(flat.faces) == 81


def test_fields_stay_with_their_faces():
    mesh = bw.generate("icosphere", 20)
    mesh = bw.Mesh(mesh.vertices, np.vstack([[[0, 0, 1]], mesh.faces]))
    mesh.fields["number"] = bw.Attribute(np.arange(21), "faces")
    again = mesh.repaired("drop-degenerate")
    assert again.fields["number"].values.tolist() == list(range(1, 21))


def test_inspect_says_what_numpy_says():
    mesh = bw.generate("icosphere", 1280)
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    report = mesh.inspect()
    assert report["faces"] == 1280 and report["closed"] and report["components"] == 1
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    volume = np.sum(a * np.cross(b, c)) / 6
    np.testing.assert_allclose([report["area"], report["volume"]], [area, volume])
    np.testing.assert_array_equal(report["bounds"], mesh.bounds)
    np.testing.assert_array_equal(mesh.bounds, [mesh.vertices.min(0), mesh.vertices.max(0)])
    assert bw.Mesh([], []).inspect()["bounds"] is None


def test_faulty_triangles_are_reported():
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan, 0, 0]]
    scene = bw.Scene(bw.Mesh(vertices, [[0, 1, 2], [0, 1, 3], [0, 0, 1]]))
    assert scene.report[0]["not_finite"].tolist() == [1]
    assert scene.report[0]["zero_area"].tolist() == [2]
    assert scene.any_hit([0.2, 0.2, 1], [0, 0, -1])


def test_all_shapes_are_generated():
    for shape in ("icosphere", "torus_knot", "gyroid", "terrain", "soup", "stadium", "interior"):
        mesh = bw.generate(shape, 2000)
        assert 500 < len(mesh.faces) < 8000
        assert np.abs(mesh.vertices).max() <= 1 + 1e-9


def test_good_files_give_no_warning(tmp_path):
    bw.generate("icosphere", 80).save(tmp_path / "ball.ply")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bw.load(tmp_path / "ball.ply")
