# SPDX-License-Identifier: Apache-2.0
"""How the tests run: random ones print what to call again, and warnings are errors."""

from __future__ import annotations

import faulthandler

import pytest
from hypothesis import settings

faulthandler.enable()
settings.register_profile("boxwood", deadline=None, max_examples=60, print_blob=True)
settings.load_profile("boxwood")


@pytest.fixture(scope="session")
def ball():
    """A closed mesh about the origin."""
    import boxwood as bw

    return bw.generate("icosphere", 1280)
