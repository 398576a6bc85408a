"""Tests that fork, each in a process of its own."""

import subprocess
import sys
from collections.abc import Callable
from functools import wraps

from tests.places import ROOT


def in_a_process(test: Callable[[], None]) -> Callable[[], None]:
    """Run a test in a process of its own: where tests before it left threads, nothing is forked."""

    @wraps(test)
    def run() -> None:
        code = f"from {test.__module__} import {test.__name__} as test; test.__wrapped__()"
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr

    return run
