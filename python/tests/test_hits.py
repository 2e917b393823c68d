# SPDX-License-Identifier: Apache-2.0
"""What rays hit is what brute force finds."""

from __future__ import annotations

import brute_force
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from random_scenes import limits, rays, scene, seeds, shapes, soup

import boxwood as bw


def first(found, world):
    """t, triangle, instance and uv of each ray's first meeting."""
    n = len(found.t)
    best = found.t.argmin(axis=1)
    t = found.t[np.arange(n), best]
    is_hit = np.isfinite(t)
    return (
        t,
        np.where(is_hit, world.triangle[best], -1),
        np.where(is_hit, world.instance[best], -1),
        np.where(is_hit[:, None], found.uv[np.arange(n), best], 0),
    )


@given(seeds, shapes)
def test_closest_and_any_hits_equal_brute_force(seed, shape):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    origins, directions, *rows = rays(rng, shape)
    options, option_rows = limits(rng, shape[2])
    found = brute_force.meetings(world, *rows, **option_rows)
    t, triangle, instance, uv = first(found, world)
    sure = ~found.is_unsure
    hits = asked.closest_hit(origins, directions, **options)
    assert hits.t.shape == hits.triangle.shape == hits.instance.shape == shape[2]
    assert hits.uv.shape == (*shape[2], 2) and hits.normal.shape == (*shape[2], 3)
    assert hits.t.dtype == hits.uv.dtype == hits.normal.dtype == np.float64
    assert hits.triangle.dtype == hits.instance.dtype == np.int32
    np.testing.assert_array_equal(hits.triangle.reshape(-1)[sure], triangle[sure])
    np.testing.assert_array_equal(hits.instance.reshape(-1)[sure], instance[sure])
    np.testing.assert_allclose(hits.t.reshape(-1)[sure], t[sure], rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(hits.uv.reshape(-1, 2)[sure], uv[sure], atol=1e-8)
    any_hit = asked.any_hit(origins, directions, **options)
    assert any_hit.dtype == np.bool_
    np.testing.assert_array_equal(any_hit.reshape(-1)[sure], triangle[sure] >= 0)
    np.testing.assert_array_equal(any_hit, hits.hit)


@given(seeds, shapes, st.integers(0, 5))
def test_lists_of_hits_equal_brute_force(seed, shape, k):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    origins, directions, *rows = rays(rng, shape)
    options, option_rows = limits(rng, shape[2])
    found = brute_force.meetings(world, *rows, **option_rows)
    counts = asked.count_hits(origins, directions, **options)
    lists = asked.all_hits(origins, directions, **options)
    firsts = asked.first_k_hits(origins, directions, k, **options)
    assert counts.shape == shape[2] and counts.dtype == np.int64
    assert firsts.t.shape == (*shape[2], k) and firsts.uv.shape == (*shape[2], k, 2)
    assert lists.offsets.shape == (len(rows[0]) + 1,) and lists.offsets.dtype == np.int64
    np.testing.assert_array_equal(lists.counts, counts.reshape(-1))
    for i in np.flatnonzero(~found.is_unsure):
        order = np.argsort(found.t[i])[: np.isfinite(found.t[i]).sum()]
        here = lists.of_ray(i)
        np.testing.assert_array_equal(lists.ray[here], i)
        np.testing.assert_allclose(lists.t[here], found.t[i][order], rtol=1e-9, atol=1e-12)
        np.testing.assert_array_equal(lists.triangle[here], world.triangle[order])
        np.testing.assert_array_equal(lists.instance[here], world.instance[order])
        np.testing.assert_allclose(lists.uv[here], found.uv[i][order], atol=1e-8)
        some = min(k, len(order))
        t = firsts.t.reshape(-1)[i * k : i * k + k]
        np.testing.assert_array_equal(t[:some], lists.t[here][:some])
        assert (t[some:] == np.inf).all()
        triangle = firsts.triangle.reshape(-1)[i * k : i * k + k]
        np.testing.assert_array_equal(triangle[:some], world.triangle[order][:some])
        assert (triangle[some:] == -1).all()


@given(seeds, shapes, st.booleans())
def test_rays_in_float_answer_in_float(seed, shape, skips):
    rng = np.random.default_rng(seed)
    vertices, faces = soup(rng, 20)
    asked = bw.Scene(bw.Mesh(vertices.astype(np.float32), faces))
    world = brute_force.in_world([(vertices.astype(np.float32), faces, np.eye(4), 0xFFFFFFFF)])
    origins, directions = (x.astype(np.float32) for x in rays(rng, shape)[:2])
    rows = [np.broadcast_to(x, (*shape[2], 3)).reshape(-1, 3) for x in (origins, directions)]
    # Those that know what to skip are decided in double.
    options = {"skip_triangle": 3} if skips else {}
    found = brute_force.meetings(world, *rows, **options, unsure=1e-3)
    t, triangle, _, uv = first(found, world)
    hits = asked.closest_hit(origins, directions, **options)
    assert hits.t.dtype == hits.uv.dtype == hits.normal.dtype == np.float32
    sure = ~found.is_unsure
    np.testing.assert_array_equal(hits.triangle.reshape(-1)[sure], triangle[sure])
    np.testing.assert_allclose(hits.t.reshape(-1)[sure], t[sure], rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(hits.uv.reshape(-1, 2)[sure], uv[sure], atol=1e-2)
    np.testing.assert_array_equal(
        asked.any_hit(origins, directions, **options).reshape(-1)[sure], triangle[sure] >= 0
    )


@given(seeds)
def test_normals_are_those_of_the_triangles_in_the_world(seed):
    rng = np.random.default_rng(seed)
    asked, world = scene(rng)
    origins, directions, *_ = rays(rng, ((50,), (50,), (50,)))
    hits = asked.closest_hit(origins, directions)
    seen = np.flatnonzero(hits.hit)
    which = [
        np.flatnonzero((world.instance == i) & (world.triangle == f))[0]
        for i, f in zip(hits.instance[seen], hits.triangle[seen], strict=True)
    ]
    a, b, c = (world.corners[which, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    np.testing.assert_allclose(hits.normal[seen], normal, atol=1e-9)
    assert (hits.normal[~hits.hit] == 0).all()
    np.testing.assert_array_equal(asked.geometric_normal(hits.triangle, hits.instance), hits.normal)
    places = origins[seen] + hits.t[seen, None] * directions[seen]
    u, v = hits.uv[seen].T[..., None]
    np.testing.assert_allclose((1 - u - v) * a + u * b + v * c, places, atol=1e-9)


small = st.integers(-3, 3)
corner = st.tuples(small, small, small)


@given(
    st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=12),
    st.lists(st.tuples(small, small), min_size=1, max_size=8),
)
def test_rays_through_edges_and_corners_are_decided_exactly(triangles, places):
    """Along z, over whole numbers, doubles don't round: edges belong to triangles, ties go to the
    first."""
    corners = np.array(triangles, np.float64)
    mesh = bw.Mesh(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
    origins = np.array([(x, y, 10) for x, y in places], np.float64)
    hits = bw.Scene(mesh).closest_hit(origins, [0.0, 0.0, -1.0])
    for i, (x, y, z) in enumerate(origins):
        best = (np.inf, -1)
        for triangle, (a, b, c) in enumerate(corners - [x, y, 0]):
            weights = [b[0] * c[1] - b[1] * c[0], c[0] * a[1] - c[1] * a[0]]
            weights.append(a[0] * b[1] - a[1] * b[0])
            total = sum(weights)
            if total != 0 and (min(weights) >= 0 or max(weights) <= 0):
                height = (weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]) / total
                # The same arithmetic from the ray's origin, so that no rounding differs.
                t = (
                    weights[0] * (z - a[2]) + weights[1] * (z - b[2]) + weights[2] * (z - c[2])
                ) / total
                assert abs(z - height - t) < 1e-12
                best = min(best, (t, triangle))
        assert (hits.t[i], hits.triangle[i]) == best


def test_rays_that_make_no_sense_miss(ball):
    asked = bw.Scene(ball)
    for dtype in (np.float32, np.float64):
        good = np.array([[0, 0, 5.0]], dtype), np.array([[0, 0, -1.0]], dtype)
        assert asked.any_hit(*good).all()
        for bad in (np.nan, np.inf, -np.inf):
            broken = np.array([[bad, 0, 5]], dtype)
            assert not asked.any_hit(broken, good[1]).any()
            assert not asked.any_hit(good[0], broken).any()
            assert np.isinf(asked.closest_hit(broken, good[1]).t).all()
        assert not asked.any_hit(good[0], np.zeros(3, dtype)).any()
        assert not asked.any_hit(*good, t_min=np.nan).any()
        assert not asked.any_hit(*good, t_max=np.nan).any()
        assert not asked.any_hit(*good, t_min=2, t_max=1).any()
        assert asked.any_hit(*good, t_max=1e300).all()
        assert asked.any_hit(*good, t_max=10**30).all()


def test_a_scene_of_nothing_answers():
    for empty in (bw.Scene([]), bw.Scene(bw.Mesh([], [])), bw.Scene(bw.Mesh(np.eye(3), []))):
        assert not empty.any_hit([[0, 0, 5]], [0, 0, -1]).any()
        assert empty.closest_hit([0, 0, 5], [0, 0, -1]).triangle == -1
        assert empty.all_hits([[0, 0, 5]], [0, 0, -1]).offsets.tolist() == [0, 0]
        assert not empty.closest_point([[0, 0, 5]]).found.any()
        assert np.isinf(empty.signed_distance([[0, 0, 5]]).distance).all()
        assert empty.winding_number([[0, 0, 5]]).tolist() == [0]
        assert empty.box_overlap([[-1, -1, -1]], [[1, 1, 1]]).counts.tolist() == [0]


def test_many_more_places_than_hits(ball):
    firsts = bw.Scene(ball).first_k_hits([[0, 0, 5], [0, 3, 5]], [0, 0, -1], 2**18)
    assert firsts.hit.sum(axis=1).tolist() == [2, 0]
