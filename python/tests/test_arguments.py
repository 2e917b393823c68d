# SPDX-License-Identifier: Apache-2.0
"""What can't be used is refused by name, with what was found and expected; the rest works."""

from __future__ import annotations

import array

import numpy as np
import pytest

import boxwood as bw

ORIGINS = np.array([[0, 0, 5.0], [0.1, 0.2, 5], [0, 3, 5]])
DOWN = np.array([0, 0, -1.0])


@pytest.fixture
def scene(ball):
    return bw.Scene(ball)


@pytest.mark.parametrize(
    ("bad", "kind", "says"),
    [
        (np.zeros((4, 2)), ValueError, "origins: found an array of float64 of shape (4, 2)"),
        (np.zeros(()), ValueError, "origins: found an array of float64 of shape ()"),
        (np.zeros((4, 3), int), TypeError, "origins: found an array of int64 of shape (4, 3)"),
        (np.zeros((4, 3), complex), TypeError, "origins: found an array of complex128"),
        (np.zeros((4, 3), bool), TypeError, "origins: found an array of bool"),
        (np.zeros((4, 3), object), TypeError, "origins: found an array of object"),
        (np.full((4, 3), "x"), TypeError, "origins: found an array of <U1"),
        ([[0, 0, "x"]], TypeError, "origins: found an array of"),
        ([[0, 0, 0], [0, 0]], TypeError, "origins: found list"),
        (None, TypeError, "origins: found an array of object"),
        ({}, TypeError, "origins: found an array of object"),
        (np.zeros((5, 3)), ValueError, "origins and directions: found shapes (5, 3) and (2, 3)"),
    ],
)
def test_bad_rays_are_refused_by_name(scene, bad, kind, says):
    for ask in (scene.closest_hit, scene.any_hit, scene.all_hits, scene.count_hits):
        with pytest.raises(kind) as raised:
            ask(bad, np.zeros((2, 3)))
        assert says in str(raised.value) and "expected" in str(raised.value)


@pytest.mark.parametrize(
    ("options", "kind", "says"),
    [
        ({"t_min": np.zeros(2)}, ValueError, "t_min: found shape (2,), expected one number"),
        ({"t_max": "x"}, TypeError, "t_max: found an array of <U1"),
        ({"t_max": None}, TypeError, "t_max: found an array of object"),
        ({"t_max": True}, TypeError, "t_max: found an array of bool"),
        ({"t_max": 10**400}, TypeError, "t_max: found int"),
        ({"skip_triangle": 0.5}, TypeError, "skip_triangle: found an array of float64"),
        ({"skip_triangle": -2}, ValueError, "skip_triangle: found -2, expected integers from -1"),
        ({"skip_triangle": [0, 2**31, 0]}, ValueError, "skip_triangle: found 2147483648 at (1,)"),
        ({"skip_instance": True}, TypeError, "skip_instance: found an array of bool"),
        ({"visibility": 2**32}, ValueError, "visibility: found 4294967296"),
        ({"visibility": -1}, ValueError, "visibility: found -1"),
        ({"progress": 3}, TypeError, "progress: found int"),
    ],
)
def test_bad_options_are_refused_by_name(scene, options, kind, says):
    with pytest.raises(kind) as raised:
        scene.closest_hit(ORIGINS, DOWN, **options)
    assert says in str(raised.value)


@pytest.mark.parametrize(
    ("call", "kind", "says"),
    [
        (lambda s: s.first_k_hits(ORIGINS, DOWN, -1), ValueError, "k: found -1"),
        (lambda s: s.first_k_hits(ORIGINS, DOWN, 10**5000), ValueError, "k: found one of more"),
        (lambda s: s.first_k_hits(ORIGINS, DOWN, 1.0), TypeError, "k: found float"),
        (lambda s: s.first_k_hits(ORIGINS, DOWN, True), TypeError, "k: found bool"),
        (lambda s: s.closest_point(np.zeros((3, 3), int)), TypeError, "points: found an array of"),
        (lambda s: s.closest_point(ORIGINS, max_radius="x"), TypeError, "max_radius: found str"),
        (lambda s: s.signed_distance(ORIGINS, method="x"), ValueError, "method: found 'x'"),
        (lambda s: s.signed_distance(ORIGINS, method=None), TypeError, "method: found NoneType"),
        (lambda s: s.winding_number(ORIGINS, accuracy=0.5), ValueError, "accuracy: found 0.5"),
        (lambda s: s.box_overlap(ORIGINS, DOWN), ValueError, "lower and upper: found shapes"),
        (lambda s: s.sphere_overlap(ORIGINS, np.ones(2)), ValueError, "radii: found shape (2,)"),
        (lambda s: s.triangle_overlap(ORIGINS[:2]), ValueError, "corners: found an array of"),
        (lambda s: s.geometric_normal(5000), ValueError, "triangle: found 5000"),
        (lambda s: s.geometric_normal(0, 1), ValueError, "instance: found 1"),
        (lambda s: bw.Scene(5), TypeError, "meshes: found int"),
        (lambda s: bw.Scene([s]), TypeError, "meshes: found Scene"),
        (lambda s: bw.Scene(s.meshes, preset="x"), ValueError, "preset: found 'x'"),
        (lambda s: bw.Scene(s.meshes, cull_back_faces=1), TypeError, "cull_back_faces: found int"),
        (lambda s: bw.Scene(s.meshes, cull_back_faces=[]), ValueError, "cull_back_faces: found 0"),
        (lambda s: bw.Instance(s.meshes[0], np.eye(3)), ValueError, "transform: found an array"),
        (
            lambda s: bw.Instance(s.meshes[0], 2 * np.eye(4)),
            ValueError,
            "transform: found the",
        ),
        (lambda s: bw.Instance(s.meshes[0], None, -1), ValueError, "visibility: found -1"),
        (lambda s: bw.Mesh(np.eye(3), [[0, 1, 3]]), ValueError, "faces: found [0, 1, 3] in face 0"),
        (lambda s: bw.Mesh(np.eye(3), [[0, 1, -1]]), ValueError, "faces: found -1 at (0, 2)"),
        (
            lambda s: bw.Mesh(np.eye(3), [[0, 1.0, 2]]),
            TypeError,
            "faces: found an array",
        ),
        (lambda s: bw.Mesh(np.eye(3), [[0, 1]]), ValueError, "faces: found an array of int64"),
        (lambda s: bw.Mesh(np.eye(2), [[0, 1, 1]]), ValueError, "vertices: found an array of"),
        (lambda s: bw.generate("ball", 3), ValueError, "ball"),
        (lambda s: bw.generate("soup", 10**12), ValueError, "triangles: found 1000000000000"),
        (lambda s: bw.build(s), TypeError, "mesh: found Scene"),
        (lambda s: bw.build(s.meshes[0], "x"), ValueError, "method: found 'x'"),
        (lambda s: bw.load(3), TypeError, "path: found int"),
        (lambda s: bw.load("a\0b.ply"), ValueError, "path: found a zero byte"),
        (lambda s: bw.load("x.ply", allow_outside_files="no"), TypeError, "allow_outside_files"),
        (lambda s: s.meshes[0].repaired("glue"), ValueError, "steps: found 'glue'"),
        (lambda s: s.meshes[0].save("x.xyz"), ValueError, "xyz"),
        (lambda s: bw.Image(np.zeros(4)), ValueError, "pixels: found an array of float64"),
        (lambda s: bw.Image.of_ids([1, 2, 3]), ValueError, "ids: found an array of int64"),
        (lambda s: bw.Image.of_depth(np.zeros((2, 2, 3))), ValueError, "t: found an array"),
        (lambda s: bw.Image.of_normal(np.zeros((2, 3))), ValueError, "normal: found an array"),
        (lambda s: bw.PinholeCamera([0, 0, 1], [0, 0, 0], [0, 0, 1]), ValueError, "target and up"),
        (lambda s: bw.PinholeCamera([0, 0], [0, 0, 0]), ValueError, "position: found an array"),
        (lambda s: bw.PinholeCamera([0, 0, 1], [0, 0, 0], width=0), ValueError, "width: found 0"),
        (lambda s: bw.SphericalCamera([0, 0, 0], vertical=3), ValueError, "vertical: found"),
        (lambda s: bw.SphericalCamera([0, 0, 0], width="x"), TypeError, "width: found str"),
        (lambda s: bw.SphericalCamera([0, 0, 0], vertical=[1], height=2), ValueError, "height: "),
        (lambda s: bw.render(s, integrator="x"), ValueError, "integrator: found 'x'"),
        (lambda s: bw.render(s, camera=3), TypeError, "camera: found int"),
        (lambda s: bw.render(s, up="x"), ValueError, "up: found 'x'"),
        (lambda s: bw.thread_limit(0).__enter__(), ValueError, "threads: found 0"),
    ],
)
def test_bad_arguments_are_refused_by_name(scene, call, kind, says):
    with pytest.raises(kind) as raised:
        call(scene)
    assert says in str(raised.value)


class Arrays:
    """The ways in which arrays come that aren't of numpy, or not as numpy makes them."""

    class Interface:
        def __init__(self, values):
            self.values = values

        def __array__(self, dtype=None, copy=None):
            return self.values

    class Dlpack:
        def __init__(self, values):
            self.values = values

        def __dlpack__(self, **options):
            return self.values.__dlpack__(**options)

        def __dlpack_device__(self):
            return self.values.__dlpack_device__()

    @staticmethod
    def buffer(values):
        return memoryview(np.ascontiguousarray(values))

    @staticmethod
    def read_only(values):
        result = values.copy()
        result.flags.writeable = False
        return result

    @staticmethod
    def columns(values):
        return np.asfortranarray(values)

    @staticmethod
    def every_second(values):
        return np.repeat(values, 2, axis=0)[::2]

    @staticmethod
    def backward(values):
        return values[::-1].copy()[::-1]

    @staticmethod
    def records(values):
        result = np.zeros(len(values), [("position", values.dtype, 3), ("number", "i1")])
        result["position"] = values
        return result["position"]

    @staticmethod
    def unaligned(values):
        return np.ndarray(values.shape, values.dtype, b"?" + values.tobytes(), 1)

    @staticmethod
    def swapped_bytes(values):
        return values.astype(values.dtype.newbyteorder())

    @staticmethod
    def matrix(values):
        with pytest.warns(PendingDeprecationWarning):
            return np.matrix(values)

    @staticmethod
    def lists(values):
        return values.tolist()


KINDS = [name for name in vars(Arrays) if not name.startswith("_")]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_all_kinds_of_arrays_are_taken(scene, ball, kind, dtype):
    make = getattr(Arrays, kind)
    origins, down = ORIGINS.astype(dtype), DOWN.astype(dtype)
    expected = scene.closest_hit(origins, down)
    hits = scene.closest_hit(make(origins), down)
    np.testing.assert_array_equal(hits.triangle, expected.triangle)
    np.testing.assert_allclose(hits.t, expected.t, rtol=1e-6)
    assert hits.t.dtype == (np.float64 if kind == "lists" else dtype)
    np.testing.assert_allclose(
        scene.closest_point(make(origins)).distance, scene.closest_point(origins).distance
    )
    moved = bw.Mesh(make(ball.vertices.astype(dtype)), ball.faces)
    np.testing.assert_array_equal(
        bw.Scene(moved).any_hit(origins, down), scene.any_hit(origins, down)
    )
    np.testing.assert_allclose(moved.vertices, ball.vertices, atol=1e-6)


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "lists"])
def test_many_rays_are_read_from_all_kinds_of_arrays(scene, kind):
    make = getattr(Arrays, kind)
    rng = np.random.default_rng(1)
    camera = bw.PinholeCamera([3, 0, 0], [0, 0, 0], width=100, height=90).rays()
    many = rng.uniform(-2, 2, (2, 700, 3)).astype(np.float32)
    # Of no camera, many from each of a few points, and row by row.
    for origins, directions in (
        many,
        (many[0, :3].repeat(240, 0)[:700], many[1]),
        (np.broadcast_to(camera[0], (9000, 3)), camera[1].reshape(-1, 3)),
    ):
        origins, directions = np.float32(origins), np.float32(directions)
        t_max = rng.uniform(0, 3, len(origins)).astype(np.float32)
        expected = scene.closest_hit(origins, directions, t_max=t_max)
        assert 0 < expected.hit.sum() < len(origins)
        hits = scene.closest_hit(make(origins), make(directions), t_max=t_max[::-1][::-1])
        for name in ("t", "triangle", "instance", "uv", "normal"):
            np.testing.assert_array_equal(getattr(hits, name), getattr(expected, name))
        found = scene.any_hit(make(origins), make(directions), t_max=t_max)
        np.testing.assert_array_equal(found, expected.hit)
        alone = scene.closest_hit(origins[5], directions[5], t_max=t_max[5])
        assert alone.t == expected.t[5] and alone.triangle == expected.triangle[5]


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "lists"])
@pytest.mark.parametrize("dtype", [np.int32, np.uint32, np.int64, np.uint64, np.int16])
def test_all_kinds_of_integers_are_taken(ball, kind, dtype):
    faces = getattr(Arrays, kind)(ball.faces.astype(dtype))
    mesh = bw.Mesh(ball.vertices, faces)
    np.testing.assert_array_equal(mesh.faces, ball.faces)
    assert mesh.faces.dtype == np.int32


def test_python_s_own_arrays_are_taken(scene):
    assert scene.any_hit(array.array("d", [0, 0, 5]), array.array("f", [0, 0, -1]))


def test_nothing_is_an_empty_batch(scene):
    for nothing in ([], np.empty((0, 3)), np.empty((0, 3), np.float32), np.empty((4, 0, 3))):
        shape = np.shape(nothing)[:-1] if np.size(np.shape(nothing)) > 1 else (0,)
        assert scene.closest_hit(nothing, DOWN).t.shape == shape
        assert scene.any_hit(nothing, DOWN).shape == shape
        assert scene.first_k_hits(nothing, DOWN, 2).t.shape == (*shape, 2)
        assert scene.all_hits(nothing, DOWN).offsets.tolist() == [0]
        assert scene.closest_point(nothing).point.shape == (*shape, 3)
        assert scene.signed_distance(nothing).distance.shape == shape
        assert scene.box_overlap(nothing, nothing).counts.tolist() == []


def test_faces_can_not_be_written_to(ball, tmp_path):
    """A query trusts the indices."""
    ball.save(tmp_path / "ball.ply")
    bw.Scene(ball).save(tmp_path / "ball.boxwood")
    for mesh in (
        bw.Mesh(ball.vertices, ball.faces),
        bw.load(tmp_path / "ball.ply"),
        bw.open(tmp_path / "ball.boxwood").meshes[0],
    ):
        with pytest.raises(ValueError, match="read-only"):
            mesh.faces[0, 0] = 1
        with pytest.raises(ValueError, match="WRITEABLE"):
            mesh.faces.flags.writeable = True
