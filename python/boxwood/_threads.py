# SPDX-License-Identifier: Apache-2.0
"""How many threads work, and what becomes of them when the process forks."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from . import _arguments as arguments
from . import _core


@contextmanager
def thread_limit(threads: int) -> Iterator[None]:
    """While it lasts, builds and queries of the whole process use at most so many threads.

    >>> import boxwood as bw
    >>> with bw.thread_limit(1):
    ...     scene = bw.Scene(bw.generate("icosphere", 1280))
    """
    limit = _core.ThreadLimit(arguments.count(threads, "threads", 1, 2**16))
    try:
        yield
    finally:
        limit.end()


# A forked child has only the thread that forked. So the compiled part's own threads end before, and
# come back when there is work; and what other threads of Python are at is waited for.
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_core.before_fork,
        after_in_parent=_core.after_fork_in_parent,
        after_in_child=_core.after_fork_in_child,
    )
