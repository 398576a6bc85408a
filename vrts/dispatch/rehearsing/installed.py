"""Whether LinuxCNC can be started here, and what is missing."""

import os
import shutil
from pathlib import Path
from typing import NamedTuple

LIBRARIES = "*/faketime/libfaketime.so.1"
NEEDED = ("linuxcnc", "unshare", "setpriv", "mount")
REMEDY = "on Debian: apt-get install --no-install-recommends linuxcnc-uspace faketime"


class Installed(NamedTuple):
    """What is started."""

    faketime: str  # the library that makes time go faster
    root: bool  # namespaces are made as root, and left for nobody inside


def installed() -> Installed | str:
    """Return what there is, or a sentence about what is missing."""
    missing = [name for name in NEEDED if shutil.which(name) is None]
    if missing:
        return f"{missing[0]} is not installed here"
    found = sorted(Path("/usr/lib").glob(LIBRARIES))
    if not found:
        return "faketime is not installed here"
    return Installed(str(found[0]), os.geteuid() == 0)
