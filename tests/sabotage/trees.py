"""Copies of the tree that take one patch after another, and tests run in them."""

import os
import shutil
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import NamedTuple

from tests.sabotage import warm
from tests.sabotage.patches import Patch

COPIED = (
    *("vrts", "tests", "examples", "scenes", "pyproject.toml"),
    *("README.md", "CHANGELOG.md", "CITATION.cff", ".github"),
)
COMPILED = "__pycache__"
SECONDS = 900  # for the tests of a patch, which give way to others
ALL_SECONDS = 1800  # for those of all patches
MOMENTS = count(
    1_000_000_000
)  # [s] one for each patch: what Python compiled of it fits nothing else


class PatchError(ValueError):
    """What a patch replaces does not stand once in its file."""


def copy_tree(root: Path, to: Path) -> Path:
    """Copy what the tests need, and what Python compiled of it."""
    ignore = shutil.ignore_patterns("*.rrd", "bench")
    to.mkdir(parents=True)
    for name in COPIED:
        source = root / name
        if source.is_dir():
            shutil.copytree(source, to / name, ignore=ignore)
        else:
            shutil.copy2(source, to / name)
    return to


class Tree:
    """A copy of the tree that takes one patch after another.

    What Python compiled stays for the next, but for what is patched: to compile takes more than
    a short test. What a test left behind, or took away, goes with the whole copy.
    """

    def __init__(self, untouched: Path, folder: Path) -> None:
        """Copy a tree into a folder that is not there yet."""
        self._untouched = untouched
        self.folder = copy_tree(untouched, folder)
        self._as_copied = self._listed()

    @contextmanager
    def patched(self, patch: Patch) -> Generator[Path]:
        """Lend the tree with a patch.

        Raises:
            PatchError: Its text does not stand once.
        """
        target = self.folder / patch.file
        kept, times = target.read_bytes(), target.stat()
        text = kept.decode("utf-8")
        if text.count(patch.before) != 1:
            raise PatchError(f"its text stands {text.count(patch.before)} times in {patch.file}")
        target.write_text(text.replace(patch.before, patch.after), encoding="utf-8")
        moment = next(MOMENTS)
        os.utime(target, (moment, moment))
        try:
            yield self.folder
        finally:
            target.write_bytes(kept)
            os.utime(target, ns=(times.st_atime_ns, times.st_mtime_ns))
            if self._listed() != self._as_copied:
                shutil.rmtree(self.folder)
                copy_tree(self._untouched, self.folder)

    def _listed(self) -> dict[str, tuple[int, int]]:
        """Return size and time of every file, but for what Python compiled."""
        found: dict[str, tuple[int, int]] = {}
        for folder, below, names in os.walk(self.folder):
            if COMPILED in below:
                below.remove(COMPILED)
            for name in names:
                path = os.path.join(folder, name)
                status = os.lstat(path)
                found[path] = status.st_size, status.st_mtime_ns
        return found


class NoTestError(RuntimeError):
    """No test was run: there is none of these names."""


class NoAnswerError(RuntimeError):
    """Tests did not end in time."""


class DiedError(RuntimeError):
    """Tests ended their process, or somebody else did."""


def run_tests(tree: Path, tests: Sequence[str], *options: str, seconds: float = SECONDS) -> bool:
    """Run tests in a tree; return whether any failed. A run that collects nothing raises."""
    return first_failure(tree, tests, *options, seconds=seconds).test is not None


class Failure(NamedTuple):
    """What tests came to."""

    test: str | None  # that failed first; None: none
    cpu_s: float
    note: str = "no test failed"


def first_failure(
    tree: Path, tests: Sequence[str], *options: str, seconds: float = SECONDS
) -> Failure:
    """Run tests in a tree until one fails.

    Raises:
        NoTestError: There are no such tests.
        NoAnswerError: They took too long.
        DiedError: They took Python with them.
    """
    said = tree.with_name(f"{tree.name}.said")
    words = ["-x", "-q", "-p", "no:randomly", *options, *tests]
    status, failed, cpu_s = warm.run(tree, words, seconds, said)
    if status is None and cpu_s:
        raise NoAnswerError(f"its tests did not end within {seconds:.0f} s")
    if status is None:
        raise DiedError("the process of its tests died")
    if status not in (0, 1, 2):
        raise NoTestError(said.read_text(encoding="utf-8", errors="replace"))
    if status == 0:
        return Failure(None, cpu_s)
    return Failure(failed or tests[0], cpu_s)
