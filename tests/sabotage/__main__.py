"""Apply each patch to a copy of the tree and demand that the named tests fail.

A patch that no test notices, or that no longer applies, fails this stage. Before anything is
patched the named tests must pass, so that a failure is the patch's doing; `--passed` says that they
did just now, in the stages before this one. Tests are those of the usual run, with its few
examples, but for patches that say that only a `thorough` test notices.
`--list` says which those are; `--chosen` asks what `python -m tests --changed` would have run.
"""

import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tests.places import ROOT
from tests.sabotage import chosen
from tests.sabotage.patches import PATCHES, Patch
from tests.sabotage.trees import ALL_SECONDS, SECONDS, PatchError, copy_tree, patched, run_tests


def main(words: list[str]) -> int:
    """Try every patch whose name holds one of the words (all without words)."""
    names = [word for word in words if not word.startswith("--")]
    wanted = [patch for patch in PATCHES if not names or any(w in patch.name for w in names)]
    if "--list" in words:
        for patch in wanted:
            print(f"{'thorough' if patch.thorough else 'usual':10}{patch.name}")
        return 0
    if "--chosen" in words:
        return chosen.main(wanted)
    with tempfile.TemporaryDirectory() as folder:
        untouched = copy_tree(ROOT, Path(folder) / "untouched")
        for thorough in {patch.thorough for patch in wanted if "--passed" not in words}:
            these = [patch for patch in wanted if patch.thorough is thorough]
            targets = sorted({test for patch in these for test in patch.tests})
            if run_tests(untouched, targets, *selection(thorough), "-n", "2", seconds=ALL_SECONDS):
                print("the named tests fail without any patch")
                return 1
        with ThreadPoolExecutor(max_workers=2) as pool:
            jobs = [pool.submit(verdict, patch, untouched) for patch in wanted]
            verdicts = [job.result() for job in jobs]
    for patch, problem in zip(wanted, verdicts, strict=True):
        print(f"{'noticed ' if problem is None else 'MISSED  '} {patch.name}" + (problem or ""))
    missed = [problem for problem in verdicts if problem is not None]
    print(f"sabotage: {len(wanted) - len(missed)} of {len(wanted)} patches noticed")
    return 1 if missed else 0


def verdict(patch: Patch, untouched: Path) -> str | None:
    """Return None when the tests notice the patch, else what is wrong."""
    try:
        with patched(patch, untouched) as tree:
            noticed = run_tests(tree, patch.tests, *selection(patch.thorough))
    except PatchError as problem:
        return f": {problem}"
    except subprocess.TimeoutExpired:
        return f": its tests did not end within {SECONDS} s"
    return None if noticed else ": no test failed"


def selection(thorough: bool) -> tuple[str, ...]:
    """Return pytest's options for the tests that are to notice."""
    return ("-m", "thorough and not live") if thorough else ()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
