"""Puts a built site where it is read: whoever looks there finds the old one or the new one."""

import shutil
import tempfile
from pathlib import Path

from vrts.site.made_of import NOTE

BESIDE = "built-"  # how names of folders begin that hold a site on its way; Git ignores them


def put_in_place(site: Path, place: Path) -> None:
    """Copy a site to a place, whole or not at all.

    It is copied to a folder beside the place, its note last, and that folder is renamed.
    """
    with tempfile.TemporaryDirectory(prefix=BESIDE, dir=place.parent) as work:
        new, old = (Path(work) / name / place.name for name in ("new", "old"))
        shutil.copytree(site, new, ignore=shutil.ignore_patterns(NOTE))
        shutil.copy(site / NOTE, new)
        if place.exists():
            old.parent.mkdir()
            place.rename(old)
        new.rename(place)
