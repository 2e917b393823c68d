# SPDX-License-Identifier: Apache-2.0
"""Numbers as colors."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core


def color_map(
    values: ArrayLike, low: float | None = None, high: float | None = None
) -> NDArray[np.float64]:
    """Colors (..., 3) from 0 to 1 for numbers (...): from black over violet, red and orange to pale
    yellow, ever lighter. What is not a number is grey.

    low, high: the numbers that become black and pale yellow; without, the least and the greatest
        finite ones. What is beyond them looks like them.

    >>> import boxwood as bw
    >>> bw.color_map([0.0, 0.5, 2.0, float("inf")], high=1).round(2).tolist()
    [[0.0, 0.0, 0.02], [0.76, 0.23, 0.3], [0.99, 1.0, 0.72], [0.99, 1.0, 0.72]]
    """
    given = arguments.array(values, "values")
    if given.dtype.kind not in "biuf":
        raise TypeError(f"values: found {arguments.describe(given)}, expected numbers")
    given = given.astype(np.float64)
    finite = given[np.isfinite(given)]
    if finite.size == 0:
        finite = np.zeros(1)
    least = float(finite.min()) if low is None else arguments.number(low, "low")
    most = float(finite.max()) if high is None else arguments.number(high, "high")
    parts = (given - least) / (most - least if most > least else 1.0)
    is_number = ~np.isnan(parts)
    colors = np.empty((given.size, 3))
    _core.heat_colors(np.where(is_number, parts, 0.0).reshape(-1), colors)
    colors = colors.reshape(*given.shape, 3)
    colors[~is_number] = 0.5
    return colors
