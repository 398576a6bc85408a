"""`python -m vrts.site`: the site built into `vrts/site/built`, as an editable install does it.

`python -m vrts.site HTML MAN` puts site and man pages into two other folders, for a wheel.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from vrts.site.build import NotBuilt, build
from vrts.site.made_of import FIRST, MAN, NOTE, faults_of, is_made_of, made_of, note_down
from vrts.site.placing import put_in_place

ROOT = Path(__file__).parents[2]
BUILT = Path(__file__).parent / "built"


def main(arguments: list[str]) -> int:
    """Build what is not built yet, and copy it where it is wanted."""
    digest = made_of(ROOT)
    with tempfile.TemporaryDirectory() as work:
        site = BUILT
        if not is_made_of(BUILT, digest):
            site = Path(work) / "built"
            try:
                note = build(ROOT, site, site / MAN)
            except NotBuilt as problem:
                sys.stderr.write(f"the manual could not be built:\n{problem}\n")
                return 1
            note_down(site, digest, note)
        if faults_of(site):
            sys.stderr.write(f"the manual has faults:\n{faults_of(site)}\n")
        if arguments:
            html, man = (Path(argument) for argument in arguments)
            shutil.copytree(site, html, ignore=shutil.ignore_patterns(MAN, NOTE))
            shutil.copytree(site / MAN, man)
        elif site != BUILT:
            put_in_place(site, BUILT)
            sys.stdout.write(f"{BUILT / FIRST}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
