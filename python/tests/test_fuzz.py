# SPDX-License-Identifier: Apache-2.0
"""Whatever is given to whatever is public, it works or raises what is documented."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import boxwood as bw

SEED = 20240607
CALLS = 120  # of each function


class Nasty:
    """Offers an array and fails to give it."""

    def __array__(self, *_args, **_options):
        raise RuntimeError("no")


def values(rng):
    """Something that may come as an argument."""
    shape = [(), (3,), (0,), (0, 3), (5, 3), (2, 4, 3), (3, 3), (4, 4), (3, 5), (1, 1, 1, 3)]
    dtypes = ["f4", "f8", "f2", ">f8", "i4", "u8", "i1", "c16", "?", "O", "U2", "M8[s]", "g"]
    special = [0.0, -1.0, np.nan, np.inf, -np.inf, 1e300, 1e-320, 0.5]

    def an_array():
        size = shape[rng.integers(len(shape))]
        dtype = dtypes[rng.integers(min(len(dtypes), rng.choice([2, 20])))]
        numbers = rng.choice([*special, *rng.normal(size=20)], size)
        with np.errstate(all="ignore"):
            try:
                made = np.asarray(numbers).astype(dtype)
            except (ValueError, TypeError):
                made = np.zeros(size, dtype)
        how = rng.integers(5)
        if how == 0:
            made = np.asfortranarray(made)
        elif how == 1 and made.ndim:
            made = made[::-1]
        elif how == 2:
            made.flags.writeable = False
        elif how == 3:
            made = np.broadcast_to(made, (2, *made.shape))
        return made

    simple = [
        None,
        True,
        False,
        0,
        1,
        -1,
        7,
        2**31,
        2**32,
        2**63,
        10**400,
        0.5,
        np.nan,
        np.inf,
        1e300,
        1j,
        "",
        "x",
        "y",
        "median",
        "weld",
        "a\0b",
        "\udcff.ply",
        b"\xff",
        b"x.png",
        {},
        {"a": 1},
        set(),
        [],
        (),
        [[]],
        [None],
        [[0, 0, 1]],
        [[0, 0], [1]],
        (0.0, 0.0, 1.0),
        [0, 1, 2],
        [[0, 1, 2]],
        [-1, 5, 10**30],
        range(3),
        iter([1.0, 2.0]),
        lambda part: None,
        Nasty(),
        Nasty,
        object(),
        np.float32(1),
        np.int8(-3),
        np.bool_(True),
        memoryview(b"abc"),
        np.zeros(3),
        np.eye(4),
        np.array([], "f4"),
        np.zeros((2, 3)),
        np.ones((4, 3), "f4"),
    ]
    return an_array() if rng.random() < 0.5 else simple[rng.integers(len(simple))]


def everything(ball, folder):
    """Name, function, how many arguments it takes by place, and the names of others."""
    scene = bw.Scene([ball, bw.Instance(ball, np.eye(4), 3)])
    limits = ["t_min", "t_max", "skip_triangle", "skip_instance", "visibility", "progress"]
    size = ["width", "height"]
    camera = bw.PinholeCamera([0, 0, 3], [0, 0, 0], width=4, height=3)
    return [
        ("Mesh", bw.Mesh, 2, []),
        ("Scene", bw.Scene, 1, ["preset", "method", "cull_back_faces"]),
        (
            "Scene of a mesh",
            lambda **given: bw.Scene(ball, **given),
            0,
            ["preset", "method", "cull_back_faces"],
        ),
        ("Instance", bw.Instance, 3, []),
        ("Instance of a mesh", lambda *given: bw.Scene(bw.Instance(ball, *given)), 2, []),
        ("closest_hit", scene.closest_hit, 2, limits),
        ("any_hit", scene.any_hit, 2, limits),
        ("all_hits", scene.all_hits, 2, limits),
        ("count_hits", scene.count_hits, 2, limits),
        ("first_k_hits", scene.first_k_hits, 3, limits),
        ("closest_point", scene.closest_point, 1, ["max_radius", "progress"]),
        (
            "signed_distance",
            scene.signed_distance,
            1,
            ["method", "max_radius", "accuracy", "progress"],
        ),
        ("winding_number", scene.winding_number, 1, ["accuracy", "progress"]),
        ("is_sign_trustworthy", scene.is_sign_trustworthy, 1, []),
        ("box_overlap", scene.box_overlap, 2, ["progress"]),
        ("sphere_overlap", scene.sphere_overlap, 2, ["progress"]),
        ("triangle_overlap", scene.triangle_overlap, 1, ["progress"]),
        ("geometric_normal", scene.geometric_normal, 2, []),
        ("set_instances", scene.set_instances, 1, []),
        ("save", lambda path: scene.save(path), 1, []),
        ("mesh.save", ball.save, 1, []),
        ("repaired", ball.repaired, 2, []),
        ("load", bw.load, 1, ["allow_outside_files"]),
        ("open", bw.open, 1, ["trust"]),
        ("generate", bw.generate, 2, []),
        ("generate a ball", lambda n: bw.generate("icosphere", n), 1, []),
        ("build", bw.build, 2, ["cost"]),
        ("build of a mesh", lambda *given, **more: bw.build(ball, *given, **more), 1, ["cost"]),
        ("boxes", bw.build(ball).boxes, 1, []),
        ("Image", bw.Image, 1, []),
        ("Image.numpy", lambda pixels: bw.Image(pixels).numpy(), 1, []),
        ("of_depth", bw.Image.of_depth, 1, []),
        ("of_normal", bw.Image.of_normal, 1, []),
        ("of_ids", bw.Image.of_ids, 1, []),
        ("Image.save", bw.Image(np.zeros((2, 2))).save, 1, []),
        ("PinholeCamera", bw.PinholeCamera, 3, ["field_of_view", *size]),
        ("OrthographicCamera", bw.OrthographicCamera, 3, ["view_height", *size]),
        ("SphericalCamera", bw.SphericalCamera, 3, ["horizontal", "vertical", *size]),
        ("framing", bw.PinholeCamera.framing, 1, ["up", *size]),
        (
            "framing a mesh",
            lambda **given: bw.PinholeCamera.framing(ball, **given),
            0,
            ["up", *size],
        ),
        ("render", bw.render, 1, ["camera"]),
        (
            "render a mesh",
            lambda **given: bw.render(ball, camera=camera, **given),
            0,
            ["integrator", "bounces", "seed", "up", "progress"],
        ),
        ("thread_limit", lambda threads: bw.thread_limit(threads).__enter__(), 1, []),
    ]


def attributes(rng):
    """A mesh of which everything that can be written to has something in it."""
    mesh = bw.generate("icosphere", 20)
    for name in ("normals", "texture_coordinates", "colors", "groups", "materials"):
        if rng.random() < 0.4:
            kind = bw.Labels if name in ("groups", "materials") else bw.Attribute
            content = values(rng) if rng.random() < 0.2 else kind(values(rng), values(rng))
            setattr(mesh, name, content)
    if rng.random() < 0.4:
        mesh.fields = values(rng)
    elif rng.random() < 0.5:
        mesh.fields["a"] = bw.Attribute(values(rng), rng.choice(["vertices", "faces", "x"]))
    if rng.random() < 0.2:
        mesh.material_files = values(rng)
    return mesh


def attempt(name, call, rng):
    """Calls it; the failures that are documented are fine."""
    state = rng.bit_generator.state
    try:
        call()
    except (ValueError, TypeError, OSError) as error:
        # What the compiled part says of arguments doesn't name the user's.
        assert "incompatible function arguments" not in str(error), (name, str(error), state)
    except Exception as error:
        raise AssertionError(f"{name}: {error!r} with the generator at {state}") from error


@pytest.fixture
def inside(tmp_path, monkeypatch):
    """What is written with a strange name goes there."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_anything_may_come_as_an_argument(ball, inside):
    print(f"seed {SEED}")
    for number, (name, function, places, options) in enumerate(everything(ball, inside)):
        rng = np.random.default_rng([SEED, number])
        for _ in range(CALLS):
            given = [values(rng) for _ in range(places)]
            if places and rng.random() < 0.4:
                # Let it get past the first argument.
                given[0] = [np.zeros((1, 3)), np.ones(3), ball, [[0.0, 0, 5]]][rng.integers(4)]
            more = {option: values(rng) for option in options if rng.random() < 0.3}
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                attempt(name, lambda: function(*given, **more), rng)  # noqa: B023


def test_anything_may_be_in_an_attribute(inside):
    print(f"seed {SEED}")
    rng = np.random.default_rng(SEED)
    for _ in range(CALLS * 3):
        mesh = attributes(rng)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for name in ("x.ply", "x.obj", "x.glb"):
                attempt(name, lambda: mesh.save(name), rng)  # noqa: B023
            attempt("repaired", lambda: mesh.repaired("weld", "orient"), rng)  # noqa: B023
            attempt("inspect", mesh.inspect, rng)
            attempt("render", lambda: bw.render(mesh, width=4, height=3), rng)  # noqa: B023


def test_attributes_of_another_size_are_refused(ball):
    """Nobody reads beyond their end."""
    for name, columns in (("normals", 3), ("texture_coordinates", 2), ("colors", 4)):
        for of in ("vertices", "faces", "corners"):
            mesh = bw.Mesh(ball.vertices, ball.faces)
            setattr(mesh, name, bw.Attribute(np.zeros((2, columns)), of))
            for use in (mesh.repaired, lambda: bw.render(mesh, width=4, height=3)):  # noqa: B023
                with pytest.raises(ValueError, match=r"found 2 values, expected \d+"):
                    use()
    mesh = bw.Mesh(ball.vertices, ball.faces)
    mesh.materials = bw.Labels(["one"], np.ones(len(ball.faces), int))
    with pytest.raises(ValueError, match="found 1, expected less than 1"):
        mesh.repaired()


def test_a_damaged_file_is_refused_or_opened(ball, tmp_path):
    bw.Scene(bw.generate("icosphere", 80)).save(tmp_path / "good.boxwood")
    content = (tmp_path / "good.boxwood").read_bytes()
    rng = np.random.default_rng(SEED)
    bad = tmp_path / "bad.boxwood"
    for _ in range(200):
        damaged = bytearray(content)
        for place in rng.integers(0, len(content), rng.integers(1, 4)):
            damaged[place] = rng.integers(256)
        bad.write_bytes(damaged[: rng.choice([len(content), rng.integers(len(content))])])
        try:
            bw.open(bad).closest_hit(np.zeros(3), rng.normal(size=(20, 3)))
        except (bw.ParseError, OSError):
            pass
