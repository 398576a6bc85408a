"""Apply each patch to a copy of the tree and demand that the named tests fail.

A patch that no test notices, or that no longer applies, fails this stage. Before anything is
patched the named tests must pass, so that a failure is the patch's doing; `--passed` says that they
did just now, in the stages before this one. Tests are those of the usual run, with its few
examples, but for patches that say that only a `thorough` test notices.
`--list` says which those are; `--chosen` asks what `python -m tests --changed` would have run.

The test that noticed a patch last stands in `first.json` and runs first, alone: mostly that is all
there is to run. `--remember` writes the file again. Verdicts are printed as they come, with the
CPU time of the tests.
"""

import json
import os
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

from tests.places import ROOT
from tests.sabotage import chosen
from tests.sabotage.patches import PATCHES, Patch
from tests.sabotage.trees import (
    ALL_SECONDS,
    Failure,
    NoAnswerError,
    NoTestError,
    PatchError,
    Tree,
    copy_tree,
    first_failure,
    run_tests,
)

FIRST = Path(__file__).with_name("first.json")
AT_ONCE = (os.cpu_count() or 1) + 2  # many tests wait


class Verdict(NamedTuple):
    """What the tests say of a patch."""

    patch: Patch
    test: str | None  # that notices
    problem: str = ""
    cpu_s: float = 0.0


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
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # before a child loads it
    with tempfile.TemporaryDirectory() as folder:
        untouched = copy_tree(ROOT, Path(folder) / "untouched")
        for thorough in {patch.thorough for patch in wanted if "--passed" not in words}:
            these = [patch for patch in wanted if patch.thorough is thorough]
            targets = sorted({test for patch in these for test in patch.tests})
            if run_tests(untouched, targets, *selection(thorough), "-n", "2", seconds=ALL_SECONDS):
                print("the named tests fail without any patch")
                return 1
        free: SimpleQueue[Tree] = SimpleQueue()
        for i in range(AT_ONCE):
            free.put(Tree(untouched, Path(folder) / f"patched-{i}"))
        with ThreadPoolExecutor(max_workers=AT_ONCE) as pool:
            first: dict[str, str] = json.loads(FIRST.read_text(encoding="utf-8"))
            jobs = [pool.submit(verdict, one, free, first.get(one.name)) for one in wanted]
            verdicts: list[Verdict] = []
            for job in jobs:
                found = job.result()
                verdicts.append(found)
                said = "MISSED  " if found.test is None else "noticed "
                print(f"{said}{found.cpu_s:6.1f} s  {found.patch.name}{found.problem}", flush=True)
    missed = [found for found in verdicts if found.test is None]
    cpu_s = sum(found.cpu_s for found in verdicts)
    print(
        f"sabotage: {len(wanted) - len(missed)} of {len(wanted)} patches noticed "
        f"in {cpu_s:.0f} s of CPU time"
    )
    if "--remember" in words:
        kept = {one.name: first[one.name] for one in PATCHES if one.name in first}
        kept |= {found.patch.name: found.test for found in verdicts if found.test is not None}
        FIRST.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return 1 if missed else 0


def verdict(patch: Patch, free: SimpleQueue[Tree], first: str | None) -> Verdict:
    """Return which test notices a patch, or what is wrong.

    Args:
        patch: The patch.
        free: Trees that nobody uses.
        first: The test that noticed it last; None: nobody knows.
    """
    tree = free.get()
    cpu_s = 0.0
    try:
        with tree.patched(patch) as folder:
            if first is not None and _may_notice(first, patch):
                found = _alone(folder, first, patch)
                cpu_s += found.cpu_s
                if found.test is not None:
                    return Verdict(patch, found.test, "", cpu_s)
            found = first_failure(folder, patch.tests, *selection(patch.thorough))
            cpu_s += found.cpu_s
    except (PatchError, NoAnswerError) as problem:
        return Verdict(patch, None, f": {problem}", cpu_s)
    finally:
        free.put(tree)
    return Verdict(patch, found.test, "" if found.test else ": no test failed", cpu_s)


def _may_notice(test: str, patch: Patch) -> bool:
    """Return whether a test is one that a patch names."""
    return any(
        test == named or test.startswith((f"{named}/", f"{named}::", f"{named}["))
        for named in patch.tests
    )


def _alone(tree: Path, first: str, patch: Patch) -> Failure:
    """Try the test that noticed a patch last."""
    try:
        return first_failure(tree, [first], *selection(patch.thorough))
    except NoTestError:  # it has another name by now
        return Failure(None, 0.0)


def selection(thorough: bool) -> tuple[str, ...]:
    """Return pytest's options for the tests that are to notice."""
    return ("-m", "thorough and not live") if thorough else ()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
