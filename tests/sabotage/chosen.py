"""Does `python -m tests --changed` choose a test that fails? `python -m tests.sabotage --chosen`.

For each patch its file counts as changed. Where a test that the patch names is chosen, that is the
answer: `python -m tests.sabotage` has it fail; so it is told too how many are chosen without what
the patches tell. Where none is, and for a sample of the others, what was
chosen is run in a patched tree, the nearest first, until a test fails.
"""

import statistics
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from tests import changed
from tests.places import ROOT
from tests.sabotage.patches import Patch
from tests.sabotage.trees import Tree, copy_tree, run_tests

EVERY = 15  # one of so many is run although it is named


class Tried(NamedTuple):
    """A patch whose chosen tests were run."""

    patch: Patch
    noticed: bool
    took_s: float


def is_named(patch: Patch, taken: list[str]) -> bool:
    """Return whether a test is chosen that the patch names."""
    files = [test.split("::")[0] for test in patch.tests]
    return any(name == file or name.startswith(f"{file}/") for name in taken for file in files)


def main(patches: list[Patch]) -> int:
    """Print for how many patches a test is chosen that fails."""
    taken = {patch: changed.choose([patch.file]).taken for patch in patches}
    named = [patch for patch in patches if is_named(patch, taken[patch])]
    near = {patch: changed.choose([patch.file], by_nearness_alone=True).taken for patch in patches}
    by_nearness = sum(is_named(patch, near[patch]) for patch in patches)
    others = [patch for patch in patches if patch not in named]
    with tempfile.TemporaryDirectory() as folder:
        untouched = copy_tree(ROOT, Path(folder) / "untouched")
        tree = Tree(untouched, Path(folder) / "patched")
        tried = [try_one(patch, tree, taken[patch]) for patch in [*others, *named[::EVERY]]]
    for one in tried:
        said = "noticed" if one.noticed else "MISSED"
        print(f"{said:8}{one.took_s:6.1f} s  {one.patch.name} ({len(taken[one.patch])} files)")
    missed = [one for one in tried if not one.noticed]
    print(
        f"chosen: a test that fails for {len(patches) - len(missed)} of {len(patches)} patches, "
        f"{len(named)} of them by name ({by_nearness} by nearness alone); {len(tried)} were run, "
        f"until a test failed in {statistics.median(one.took_s for one in tried):.1f} s (median)"
    )
    return 1 if missed else 0


def try_one(patch: Patch, lent: Tree, taken: list[str]) -> Tried:
    """Run what is chosen in a patched tree."""
    with lent.patched(patch) as tree:
        start = time.perf_counter()
        noticed = run_tests(tree, [name for name in taken if (tree / name).exists()])
        return Tried(patch, noticed, time.perf_counter() - start)
