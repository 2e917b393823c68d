# SPDX-License-Identifier: Apache-2.0
"""Trees as arrays."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import boxwood as bw

METHODS = ["median", "binned_sah", "block_sah", "morton", "ploc", "sweep_sah", "reinsertion"]
METHODS += ["agglomerative", "spatial_split"]


@pytest.mark.parametrize("method", METHODS)
def test_children_lie_in_their_parents_and_leaves_hold_all_triangles(method):
    mesh = bw.generate("torus_knot", 1000)
    tree = bw.build(mesh, method)
    inner = np.flatnonzero(tree.count == 0)
    leaves = np.flatnonzero(tree.count)
    if method == "spatial_split":
        # A triangle may stand in several leaves.
        assert set(tree.order) == set(range(len(mesh.faces)))
    else:
        assert sorted(tree.order) == list(range(len(mesh.faces)))
    for child in (tree.first[inner], tree.first[inner] + 1):
        assert (tree.lower[child] >= tree.lower[inner]).all()
        assert (tree.upper[child] <= tree.upper[inner]).all()
        np.testing.assert_array_equal(tree.depths[child], tree.depths[inner] + 1)
    children = np.concatenate([tree.first[inner], tree.first[inner] + 1])
    assert sorted(children) == list(range(1, len(tree.count)))
    ranges = [np.arange(tree.first[i], tree.first[i] + tree.count[i]) for i in leaves]
    assert sorted(np.concatenate(ranges)) == list(range(len(tree.order)))
    for leaf, places in zip(leaves, ranges, strict=True):
        corners = mesh.vertices[mesh.faces[tree.order[places]]]
        low, high = corners.min(axis=1), corners.max(axis=1)
        if method != "spatial_split":
            assert (tree.lower[leaf] <= low).all() and (high <= tree.upper[leaf]).all()
        else:
            assert (tree.lower[leaf] <= high).all() and (low <= tree.upper[leaf]).all()


@pytest.mark.parametrize("method", METHODS)
def test_scenes_of_all_builders_agree(method):
    mesh = bw.generate("torus_knot", 1000)
    rng = np.random.default_rng(1)
    origins, directions = rng.uniform(-1, 1, (200, 3)), rng.normal(size=(200, 3))
    expected = bw.Scene(mesh).closest_hit(origins, directions)
    found = bw.Scene(mesh, method=method).closest_hit(origins, directions)
    np.testing.assert_array_equal(found.t, expected.t)
    np.testing.assert_array_equal(found.triangle, expected.triangle)


def test_statistics_are_those_of_the_arrays():
    tree = bw.build(bw.generate("torus_knot", 1000), "sweep_sah")
    found = tree.statistics
    assert found["nodes"] == len(tree.count) and found["leaves"] == np.sum(tree.count > 0)
    assert found["depth"] >= tree.depths.max() and found["largest_leaf"] == tree.count.max()
    assert found["sah_cost"] > 0
    assert sum(len(tree.boxes(d)) for d in range(found["depth"] + 1)) == len(tree.count)


@pytest.mark.parametrize("preset", ["fast", "balanced", "compact", "best"])
def test_presets_differ_in_their_trees_alone(preset):
    mesh = bw.generate("torus_knot", 2000)
    scene = bw.Scene(mesh, preset=preset)
    rng = np.random.default_rng(1)
    origins, directions = rng.uniform(-1, 1, (200, 3)), rng.normal(size=(200, 3))
    np.testing.assert_array_equal(
        scene.closest_hit(origins, directions).t, bw.Scene(mesh).closest_hit(origins, directions).t
    )
    (found,) = scene.statistics
    assert found["is_compact"] == (preset == "compact") and found["bytes"] > 0


@pytest.mark.parametrize("cost", ["centroid_distance", "volume_increase", "surface_area"])
def test_merges_have_a_cost(cost):
    tree = bw.build(bw.generate("icosphere", 80), "agglomerative", cost=cost)
    assert tree.statistics["leaves"] == 80


def test_slow_builds_warn_before():
    """The warning, as an error, comes instead of the build."""
    with pytest.raises(UserWarning, match="agglomerative"), warnings.catch_warnings():
        warnings.simplefilter("error")
        bw.build(bw.generate("icosphere", 300_000), "agglomerative")


def test_a_tree_of_nothing_has_no_triangles():
    assert bw.build(bw.Mesh([], [])).order.tolist() == []
