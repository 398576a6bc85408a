"""The manual as a built site: built once for all tests, and only when something has changed."""

import fcntl
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

from tests.places import ROOT

BUILT = ROOT / "vrts" / "site" / "built"


@cache
def built_site() -> Path:
    """Return the folder of the built site; whoever comes second waits for the first."""
    name = ROOT.as_posix().replace("/", "-")
    lock = Path(tempfile.gettempdir()) / f"vrts-site{name}.lock"
    with lock.open("w") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        done = subprocess.run(
            [sys.executable, "-m", "vrts.site"],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    return BUILT
