"""Apply each patch to a copy of the tree and demand that the named tests fail.

A patch that no test notices, or that no longer applies, fails this stage. Before anything is
patched the named tests must pass, so that a failure is the patch's doing; `--passed` says that
other stages look at that, before this one or beside it. Those of the usual run, with its few
examples, are tried before those that are `thorough`. `--list` prints what patches do; `--chosen`
asks what `python -m tests --changed` would have run.

The test that noticed a patch last stands in `first.json` and runs first, alone: mostly that is all
there is to run. `--remember` writes the file again. Verdicts are printed as they come, with the
CPU time of the tests; what nobody noticed is said again at the end.

A patch that opens a race is noticed only where the race is lost. So the named tests run once more
where none of them failed, or their process died, and the verdict says `2nd try`: better to let
such a test wait for an event.

`--minutes=N` begins no patch later than that, and waits a minute more for those that have begun: a
slow machine must not keep everybody waiting. The closing line says how many were not tried. Each
commit begins with others.
"""

import json
import os
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

from tests.places import ROOT
from tests.sabotage import chosen
from tests.sabotage.patches import PATCHES, Patch
from tests.sabotage.trees import (
    ALL_SECONDS,
    SECONDS,
    DiedError,
    Failure,
    NoAnswerError,
    NoTestError,
    PatchError,
    Tree,
    copy_tree,
    first_failure,
    run_tests,
)
from tests.until import REASON, shuffled

FIRST = Path(__file__).with_name("first.json")
TWICE = " (2nd try)"
GRACE_S = 60.0  # for what has begun when the time is over
AT_ONCE = (os.cpu_count() or 1) + 2  # many tests wait
USUAL: tuple[str, ...] = ()  # pytest's options for tests of the usual run
THOROUGH = ("-m", "thorough and not live")
EITHER = ("-m", "not live")


class Verdict(NamedTuple):
    """What the tests say of a patch."""

    patch: Patch
    test: str | None  # that notices
    note: str = ""
    cpu_s: float = 0.0

    def __str__(self) -> str:
        """Return its line."""
        said = "noticed " if self.test else "MISSED  "
        return f"{said}{self.cpu_s:6.1f} s  {self.patch.name}{self.note}"


class _Try(NamedTuple):
    """Tests that run together."""

    targets: Sequence[str]
    options: tuple[str, ...]  # of pytest: which of them
    said: str = ""  # where they notice


def main(words: list[str]) -> int:
    """Try every patch whose name holds one of the words (all without words)."""
    names = [word for word in words if not word.startswith("--")]
    wanted = [patch for patch in PATCHES if not names or any(w in patch.name for w in names)]
    if "--list" in words:
        for patch in wanted:
            print(patch.name)
        return 0
    if "--chosen" in words:
        return chosen.main(wanted)
    minutes = [float(word.partition("=")[2]) for word in words if word.startswith("--minutes=")]
    latest = time.monotonic() + 60.0 * minutes[0] if minutes else float("inf")
    if minutes:
        if minutes[0] <= 0.0:
            print(f"sabotage: {REASON}: {len(wanted)} patches not tried")
            return 0
        wanted = shuffled(wanted)
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # before a child loads it
    with tempfile.TemporaryDirectory() as folder:
        untouched = copy_tree(ROOT, Path(folder) / "untouched")
        targets = sorted({test for patch in wanted for test in patch.tests})
        if "--passed" not in words and run_tests(
            untouched, targets, *EITHER, "-n", "2", seconds=ALL_SECONDS
        ):
            print("the named tests fail without any patch")
            return 1
        free: SimpleQueue[Tree] = SimpleQueue()
        for i in range(AT_ONCE):
            free.put(Tree(untouched, Path(folder) / f"patched-{i}"))
        with ThreadPoolExecutor(max_workers=AT_ONCE) as pool:
            first: dict[str, str] = json.loads(FIRST.read_text(encoding="utf-8"))
            jobs = [pool.submit(verdict, one, free, first.get(one.name), latest) for one in wanted]
            verdicts: list[Verdict] = []
            for job in jobs:
                found = job.result()
                if found is not None:
                    verdicts.append(found)
                    print(found, flush=True)
    missed = [found for found in verdicts if found.test is None]
    for found in [*(found for found in verdicts if found.note == TWICE), *missed]:
        print(found)
    cpu_s = sum(found.cpu_s for found in verdicts)
    print(
        f"sabotage: {len(verdicts) - len(missed)} of {len(verdicts)} patches noticed "
        f"in {cpu_s:.0f} s of CPU time"
    )
    if len(verdicts) < len(wanted):
        print(
            f"{REASON}: {len(wanted) - len(verdicts)} patches not tried in {minutes[0]:g} minutes"
        )
    if "--remember" in words:
        kept = {one.name: first[one.name] for one in PATCHES if one.name in first}
        kept |= {found.patch.name: found.test for found in verdicts if found.test is not None}
        FIRST.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return 1 if missed else 0


def verdict(
    patch: Patch, free: SimpleQueue[Tree], first: str | None, latest: float
) -> Verdict | None:
    """Return which test notices a patch, or what is wrong; None: there was no time to tell.

    Args:
        patch: The patch.
        free: Trees that nobody uses.
        first: The test that noticed it last; None: nobody knows.
        latest: When it may begin at the latest, by the monotonic clock [s].
    """
    if time.monotonic() > latest:
        return None
    tree = free.get()
    cpu_s = 0.0
    note = ""
    try:
        with tree.patched(patch) as folder:
            for tries in _tries(first, patch):
                seconds = min(SECONDS, latest + GRACE_S - time.monotonic())
                found = _first_failure(folder, tries, max(1.0, seconds))
                cpu_s += found.cpu_s
                if found.test is not None:
                    return Verdict(patch, found.test, tries.said, cpu_s)
                note = found.note
    except NoAnswerError as problem:
        if time.monotonic() > latest:
            return None
        note = str(problem)
    except PatchError as problem:
        note = str(problem)
    finally:
        free.put(tree)
    return Verdict(patch, None, f": {note}", cpu_s)


def _tries(first: str | None, patch: Patch) -> list[_Try]:
    """Return which tests run one after another until one fails."""
    alone = [_Try([first], EITHER)] if first is not None and _may_notice(first, patch) else []
    both = [_Try(patch.tests, USUAL), _Try(patch.tests, THOROUGH)]
    return [*alone, *both, _Try(patch.tests, EITHER, TWICE)]


def _may_notice(test: str, patch: Patch) -> bool:
    """Return whether a test is one that a patch names."""
    return any(
        test == named or test.startswith((f"{named}/", f"{named}::", f"{named}["))
        for named in patch.tests
    )


def _first_failure(tree: Path, tries: _Try, seconds: float) -> Failure:
    """Run tests of a patch until one fails, or the time is over."""
    try:
        return first_failure(tree, tries.targets, *tries.options, seconds=seconds)
    except NoTestError:
        if tries.said:
            raise
        return Failure(None, 0.0)  # there are others, or what noticed it last has another name now
    except DiedError as problem:
        return Failure(None, 0.0, str(problem))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
