# SPDX-License-Identifier: Apache-2.0
"""Tensors of torch in the processor's memory are arrays like others. Torch is too large to be set
up for this; the test runs where it is."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw

torch = pytest.importorskip("torch")


@pytest.fixture(scope="module")
def ball():
    return bw.generate("icosphere", 320)


@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_tensors_give_the_answers_of_arrays(ball, dtype):
    rays = 4 * torch.rand((2, 500, 3), generator=torch.Generator().manual_seed(1), dtype=dtype) - 2
    scene = bw.Scene(ball)
    found = scene.closest_hit(rays[0], -rays[1])
    expected = scene.closest_hit(rays[0].numpy(), -rays[1].numpy())
    assert 0 < expected.hit.sum() < 500
    assert found.t.dtype == expected.t.dtype
    np.testing.assert_array_equal(found.t, expected.t)
    np.testing.assert_array_equal(found.triangle, expected.triangle)
    assert torch.from_numpy(found.t).dtype == dtype


def test_tensors_make_meshes(ball):
    vertices, faces = torch.tensor(ball.vertices), torch.tensor(ball.faces)
    mesh = bw.Mesh(vertices, faces)
    np.testing.assert_array_equal(mesh.vertices, ball.vertices)
    np.testing.assert_array_equal(mesh.faces, ball.faces)


def test_a_tensor_that_keeps_gradients_is_refused_and_torch_says_what_to_do(ball):
    origins = torch.zeros((4, 3), requires_grad=True)
    with pytest.raises(TypeError, match="origins: found Tensor") as caught:
        bw.Scene(ball).closest_hit(origins, torch.ones(4, 3))
    assert "detach" in str(caught.value.__cause__)
