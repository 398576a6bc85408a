"""What the changes since the last commit can affect: stages, and tests, the nearest first.

How near a test is, is how many files lie between (`uses`); a test in the room of a file is near to
it, and so are those that show all of the language by example, which cost little, and those that are
known to notice a fault in the file (`sabotage`). Files are taken while the seconds last that
somebody waits for; what is left out is said.
"""

import subprocess
from collections.abc import Iterable
from pathlib import PurePosixPath
from typing import NamedTuple

from tests import uses
from tests.places import ROOT
from tests.sabotage.patches import PATCHES
from tests.times import seconds

LASTS_S = 60.0  # together, by what was measured; four at a time on two cores
DEAR_S = 10.0  # what lasts so long is put off as if one more file lay between
USUAL_S = 0.3  # of a file that `seconds.txt` does not name
SHOWS_ALL = {  # by examples, and quickly
    "tests/spec/test_spec_lang.py",
    "tests/spec/test_spec_run.py",
    "tests/spec/test_spec_monitor.py",
    "tests/golden/test_example_01.py",
}
EVERYTHING = {"pyproject.toml", "tests/conftest.py", ".ci/constraints.txt"}


class Choice(NamedTuple):
    """Files of tests, the nearest first."""

    taken: list[str]
    left_out: list[str]


def changes() -> list[str]:
    """Return the files that differ from the last commit, those that nobody added among them."""
    command = ["git", "diff", "--name-only", "HEAD"]
    said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    new = subprocess.run(
        ["git", "ls-files", "-o", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    return sorted({*said.splitlines(), *new.splitlines()})


def choose(
    files: Iterable[str], lasts_s: float = LASTS_S, *, by_nearness_alone: bool = False
) -> Choice:
    """Choose the tests that show whether changed files are right."""
    known = seconds()
    taken: list[str] = []
    left_out: list[str] = []
    for name in ranked(list(files), by_nearness_alone=by_nearness_alone):
        cost = known.get(name, USUAL_S)
        if cost <= lasts_s or name in files:
            taken.append(name)
            lasts_s -= cost
        else:
            left_out.append(name)
    return Choice(taken, left_out)


def ranked(files: list[str], *, by_nearness_alone: bool = False) -> list[str]:
    """Return every test that changes can affect, the nearest first."""
    known = seconds()
    near: dict[str, float] = {}
    for file in files:
        found = distances(file)
        if not by_nearness_alone:
            found |= {name: min(1.0, found.get(name, 1.0)) for name in noticing(file)}
        for name, far in found.items():
            near[name] = min(far, near.get(name, far))
    return sorted(near, key=lambda name: (near[name] + known.get(name, USUAL_S) / DEAR_S, name))


def noticing(file: str) -> set[str]:
    """Return the tests that are known to notice a fault in a file."""
    named = {test.split("::")[0] for patch in PATCHES if patch.file == file for test in patch.tests}
    return {name for name in named if is_test(name)}


def distances(file: str) -> dict[str, float]:
    """Return how far each test is that a file can affect."""
    users = uses.used_by()
    if file in EVERYTHING:
        return {name: 1.0 for name in uses.uses() if is_test(name)}
    far = {file: 0}
    layer = [file]
    while layer:
        later: list[str] = []
        for name in layer:
            # what uses a test's own file is not shown by it, but for what it lends
            for user in users.get(name, ()):
                if user not in far:
                    far[user] = far[name] + 1
                    later.append(user)
        layer = later
    return {name: nearer(name, file, steps) for name, steps in far.items() if is_test(name)}


def nearer(test: str, file: str, steps: float) -> float:
    """Return how far a test is, by its name and place too."""
    mine, its = PurePosixPath(test), PurePosixPath(file)
    room = PurePosixPath("tests/unit", *its.parent.parts[1:])
    if mine.stem.removeprefix("test_") == its.stem:
        return min(steps, 0.5)
    if mine.parent == room:
        return min(steps, 1.5)
    if test in SHOWS_ALL:
        return min(steps, 1.7)
    if mine.parts[:4] == room.parts[:4]:  # tests/unit/engine/code: a part of the room
        return min(steps, 1.8)
    if mine.parts[:3] == room.parts[:3]:
        return min(steps, 2.2)
    return steps


def is_test(name: str) -> bool:
    """Return whether a file holds tests of the usual run."""
    path = PurePosixPath(name)
    return (
        path.parts[0] == "tests"
        and path.name.startswith("test_")
        and path.suffix == ".py"
        and path.parts[1] not in ("bench", "sabotage")
    )


def stages(fixed: dict[str, list[str]], pytest: list[str]) -> dict[str, list[str]]:
    """Return the stages that the changes can affect."""
    files = changes()
    python = [name for name in files if name.endswith(".py") and (ROOT / name).is_file()]
    found: dict[str, list[str]] = {}
    if python:
        found |= {name: fixed[name] for name in ("format", "lint")}
        users = uses.used_by()
        typed = sorted({*python, *(u for name in python for u in users.get(name, ()))})
        found["types"] = [*fixed["types"], *(n for n in typed if n.endswith(".py"))]
    if any(name.startswith("vrts/") and imports_changed(name) for name in files):
        found["imports"] = fixed["imports"]
    if any(name.startswith(("vrts/web/", "vrts/stubs/browser/")) for name in files):
        found["browser-types"] = fixed["browser-types"]
    choice = choose(files)
    print(f"{len(files)} files changed; {len(choice.taken)} files of tests can tell")
    if choice.left_out:
        nearest = ", ".join(choice.left_out[:3])
        print(f"left out are {len(choice.left_out)} that are further away: {nearest} …")
    if choice.taken:
        found["tests"] = [*pytest, *choice.taken]
    return found


def imports_changed(name: str) -> bool:
    """Return whether a module imports other names than at the last commit."""
    if not name.endswith(".py"):
        return False
    told = subprocess.run(
        ["git", "show", f"HEAD:{name}"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    before = uses.imports_of(told.stdout) if told.returncode == 0 else set[str]()
    path = ROOT / name
    now = uses.imports_of(path.read_text(encoding="utf-8")) if path.is_file() else set[str]()
    return before != now
