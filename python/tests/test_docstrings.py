# SPDX-License-Identifier: Apache-2.0
"""All that is public says what it is, and its examples run."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import warnings

import pytest

import boxwood as bw

MODULES = ["boxwood", *(f"boxwood.{m.name}" for m in pkgutil.iter_modules(bw.__path__))]


def public():
    for name in bw.__all__:
        thing = getattr(bw, name)
        yield name, thing
        if inspect.isclass(thing):
            for member, value in inspect.getmembers(thing):
                is_ours = str(getattr(inspect.unwrap(value), "__module__", "")).startswith(
                    "boxwood"
                )
                is_described = isinstance(value, property) or (inspect.isroutine(value) and is_ours)
                if not member.startswith("_") and is_described:
                    yield f"{name}.{member}", value


@pytest.mark.parametrize(
    ("name", "thing"), list(public()), ids=lambda x: x if isinstance(x, str) else ""
)
def test_there_is_a_docstring(name, thing):
    assert inspect.getdoc(thing), name
    assert inspect.getdoc(thing) != inspect.getdoc(object), name


@pytest.mark.parametrize("module", [m for m in MODULES if m != "boxwood._core"])
def test_examples_run(module):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = doctest.testmod(importlib.import_module(module))
    assert result.failed == 0


def test_questions_have_examples():
    for name in ("closest_hit", "any_hit", "all_hits", "signed_distance", "refit"):
        assert ">>>" in inspect.getdoc(getattr(bw.Scene, name))
