# SPDX-License-Identifier: Apache-2.0
"""Numbers as colors."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw


def brightness(values, **limits):
    return bw.color_map(values, **limits).sum(axis=-1)


def test_larger_numbers_are_lighter():
    assert (np.diff(brightness(np.linspace(-3, 7, 100))) > 0).all()


def test_shape_is_that_of_the_numbers():
    assert bw.color_map(np.zeros((2, 5, 7))).shape == (2, 5, 7, 3)
    assert bw.color_map(3).shape == (3,)
    assert bw.color_map([]).shape == (0, 3)


def test_integers_and_truth_values_are_numbers_too():
    assert (bw.color_map(np.arange(3)) == bw.color_map([0.0, 1.0, 2.0])).all()
    assert (bw.color_map([False, True]) == bw.color_map([0.0, 1.0])).all()


def test_limits_hold_what_is_beyond_them():
    found = bw.color_map([-9, 0, 1, 9, np.inf, -np.inf], low=0, high=1)
    assert (found[[0, 5]] == found[1]).all() and (found[[3, 4]] == found[2]).all()


def test_infinite_numbers_set_no_limits():
    assert (bw.color_map([0, 1, np.inf])[:2] == bw.color_map([0, 1])).all()


def test_what_is_not_a_number_is_grey():
    assert bw.color_map([0, np.nan, 1])[1].tolist() == [0.5, 0.5, 0.5]


def test_equal_numbers_have_one_color():
    assert len(np.unique(bw.color_map([4, 4, 4]), axis=0)) == 1


def test_words_are_refused():
    with pytest.raises(TypeError, match="expected numbers"):
        bw.color_map(["a"])
