# SPDX-License-Identifier: Apache-2.0
"""Shows how far long work has come."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from ._arguments import describe

Progress = bool | None | Callable[[float], object]


@contextmanager
def reporting(progress: Progress, what: str) -> Iterator[Callable[[float], object] | None]:
    """A function of the part that is done, from 0 to 1; None where nobody wants to know. True shows
    a bar by tqdm, where that is installed."""
    tqdm = _tqdm() if progress is True else None
    if progress is None or (isinstance(progress, bool) and tqdm is None):
        yield None
    elif tqdm is not None:
        with tqdm(total=100, desc=what, unit="%", bar_format="{l_bar}{bar}| {elapsed}") as bar:
            yield lambda part: bar.update(100 * part - bar.n)
    elif callable(progress):
        yield progress
    else:
        raise TypeError(f"progress: found {describe(progress)}, expected True or a function")


def _tqdm() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm
