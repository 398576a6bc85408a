"""Copies of the tree, one with a patch, and tests run in them."""

import os
import shutil
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from pathlib import Path

from tests.sabotage import warm
from tests.sabotage.patches import Patch

COPIED = ("vrts", "tests", "examples", "scenes", "pyproject.toml", "README.md")
SECONDS = 300  # for the tests of a patch
ALL_SECONDS = 1800  # for those of all patches


class PatchError(ValueError):
    """What a patch replaces does not stand once in its file."""


def copy_tree(root: Path, to: Path) -> Path:
    """Copy what the tests need, without what was compiled."""
    ignore = shutil.ignore_patterns("__pycache__", "*.rrd", "bench")
    to.mkdir(parents=True)
    for name in COPIED:
        source = root / name
        if source.is_dir():
            shutil.copytree(source, to / name, ignore=ignore)
        else:
            shutil.copy2(source, to / name)
    return to


@contextmanager
def patched(patch: Patch, untouched: Path) -> Generator[Path]:
    """Lend a tree with a patch.

    The copy is of links, and holds what Python has compiled of the untouched tree: this takes a
    quarter less time.

    Raises:
        PatchError: Its text does not stand once.
    """
    tree = untouched.with_name(patch.name.replace(" ", "-"))
    shutil.copytree(untouched, tree, copy_function=os.link)
    target = tree / patch.file
    text = target.read_text(encoding="utf-8")
    if text.count(patch.before) != 1:
        raise PatchError(f"its text stands {text.count(patch.before)} times in {patch.file}")
    target.unlink()  # a link: the untouched tree stays as it is
    target.write_text(text.replace(patch.before, patch.after), encoding="utf-8")
    yield tree
    shutil.rmtree(tree)


class NoTestError(RuntimeError):
    """No test was run: there is none of these names."""


class NoAnswerError(RuntimeError):
    """Tests did not end in time, or ended their process."""


def run_tests(tree: Path, tests: Sequence[str], *options: str, seconds: float = SECONDS) -> bool:
    """Run tests in a tree; return whether any failed. A run that collects nothing raises."""
    return first_failure(tree, tests, *options, seconds=seconds) is not None


def first_failure(
    tree: Path, tests: Sequence[str], *options: str, seconds: float = SECONDS
) -> str | None:
    """Run tests in a tree until one fails, and return which; None: all pass.

    Raises:
        NoTestError: There are no such tests.
        NoAnswerError: They took too long, or took Python with them.
    """
    said = tree.with_name(f"{tree.name}.said")
    words = ["-x", "-q", "-p", "no:randomly", *options, *tests]
    status, failed = warm.run(tree, words, seconds, said)
    if status is None:
        raise NoAnswerError(f"its tests did not end within {seconds:.0f} s, or died")
    if status not in (0, 1, 2):
        raise NoTestError(said.read_text(encoding="utf-8", errors="replace"))
    if status == 0:
        return None
    return failed or tests[0]
