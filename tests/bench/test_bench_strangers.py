"""Programs of strangers: how many are accepted, detected, and how much damage is noticed.

    python -m pytest tests/bench/test_bench_strangers.py -s -p no:xdist --strangers FOLDER

The folder has a folder of files for each language, named as `--dialect` takes it. Only hashes and
counts of what was measured are kept, in `tests/data/strangers.json`.
"""

import json
import random
from collections import Counter
from pathlib import Path

import pytest

from tests.places import ROOT, TESTS
from tests.strangers.damage import KINDS
from tests.strangers.figures import errors_of, noticed, programs, strangers, warned
from tests.support_mistakes import right
from vrts.base.source import SourceFile
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.detection import detect

DETECTED = 0.98  # of whole files
NOTICED = 0.95  # of the damages that leave a wrong step
DAMAGES = 6  # of each program
KEPT = TESTS / "data" / "strangers.json"


@pytest.fixture(params=sorted(DIALECTS))
def folder(request: pytest.FixtureRequest) -> tuple[Path, Dialect]:
    given = request.config.getoption("--strangers")
    if given is None:
        pytest.skip("no folder of programs was given")
    place = Path(str(given)) / str(request.param)
    if not place.is_dir():
        pytest.skip(f"the folder has no {request.param}")
    return place, DIALECTS[str(request.param)]


def test_programs_of_strangers_are_accepted(folder: tuple[Path, Dialect]) -> None:
    """Prints what was accepted; files that are known by their hash are accepted as before."""
    place, dialect = folder
    found = list(strangers(place, dialect))
    accepted = {stranger.hash[:16] for stranger in found if not stranger.errors}
    causes = Counter(error.rule.code for stranger in found for error in stranger.errors)
    print(f"\n{dialect.name}: {len(accepted)} of {len(found)} files; {causes.most_common(8)}")
    apart = {" ".join(text.split()): text for s in found for text in programs(s.text, dialect)}
    told = {words: warned(text, dialect) for words, text in apart.items()}
    right = [kinds for kinds in told.values() if kinds is not None]
    kinds = Counter(kind for found in right for kind in found)
    print(f"  {len(right)} of {len(told)} programs, each once and alone")
    print(f"  {sum(map(bool, right))} of these are warned of: {kinds.most_common()}")
    known = json.loads(KEPT.read_text("utf-8")).get(dialect.name, {"accepted": []})
    here = {stranger.hash[:16] for stranger in found}
    assert here.intersection(known["accepted"]) - accepted == set()


def test_the_language_is_detected(folder: tuple[Path, Dialect]) -> None:
    """Prints how many files are read as what they are, by their own names and all named alike."""
    place, dialect = folder
    found = list(strangers(place, dialect))
    told: dict[str, Counter[str]] = {}
    for what, ending in (("by their own names", None), ("all named `.pg`", ".pg")):
        names = [ending or Path(stranger.name).suffix for stranger in found]
        read = [
            detect(SourceFile(f"stranger{name}", stranger.text))[0].name
            for name, stranger in zip(names, found, strict=True)
        ]
        told[what] = Counter(read)
        right = told[what][dialect.name]
        print(
            f"\n{dialect.name}, {what}: {right} of {len(found)} files"
            f" ({100 * right / len(found):.1f} %); {told[what].most_common()}",
            end="",
        )
    print()
    assert all(counts[dialect.name] >= DETECTED * len(found) for counts in told.values())


def test_val2_is_detected() -> None:
    """Prints how many of the files of VAL-II in this repository are read as such, named alike.

    No public files of VAL-II are known: these are what students hand in, and right programs.
    """
    texts = [
        decode(path.read_bytes(), path.name) for path in sorted((ROOT / "examples").rglob("*.v2"))
    ]
    sources = [source for source in texts if isinstance(source, SourceFile)]
    programs = [source.text for source in sources] + [case.text for case in right()]
    read = Counter(detect(SourceFile("stranger.pg", text))[0].name for text in programs)
    print(f"\nval2, all named `.pg`: {read['val2']} of {len(programs)} programs")
    assert read["val2"] >= DETECTED * len(programs)


def test_damage_is_noticed_where_it_is(folder: tuple[Path, Dialect]) -> None:
    """Prints how many damages have an error at their place, by kind; few may go unnoticed."""
    place, dialect = folder
    counted: Counter[tuple[str, bool, bool]] = Counter()
    seen: set[str] = set()
    for stranger in strangers(place, dialect):
        for text in programs(stranger.text, dialect):
            words = " ".join(text.split())
            if words in seen or errors_of(text, dialect):
                continue
            seen.add(words)
            for damage, there in noticed(text, dialect, random.Random(words), DAMAGES):
                counted[damage.kind, damage.right, there] += 1
    print(f"\n{dialect.name}: {len(seen)} programs")
    for kind in KINDS:
        wrong, all_ = (_share(counted, kind, right=right) for right in ((False,), (False, True)))
        print(f"  {kind:9} {wrong} of wrong steps, {all_} of all")
    there = sum(n for (_, right, noted), n in counted.items() if noted and not right)
    total = sum(n for (_, right, _), n in counted.items() if not right)
    print(f"  {100 * there / total:.1f} % of {total} damages that leave a wrong step")
    assert there >= NOTICED * total


def _share(counted: Counter[tuple[str, bool, bool]], kind: str, *, right: tuple[bool, ...]) -> str:
    there = sum(counted[kind, r, True] for r in right)
    total = there + sum(counted[kind, r, False] for r in right)
    return f"{there}/{total} ({100 * there / max(total, 1):.1f} %)"
