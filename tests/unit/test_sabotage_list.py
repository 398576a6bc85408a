"""The list of patches is right without running them: `python -m tests --all` does."""

from collections import Counter
from functools import cache

from tests.places import ROOT
from tests.sabotage.patches import PATCHES


@cache
def text(file: str) -> str:
    return (ROOT / file).read_text(encoding="utf-8")


def test_what_each_replaces_stands_once() -> None:
    assert len(PATCHES) > 500
    for patch in PATCHES:
        assert text(patch.file).count(patch.before) == 1, patch.name
        assert patch.after != patch.before, patch.name


def test_the_tests_that_notice_are_there() -> None:
    for test in {test for patch in PATCHES for test in patch.tests}:
        path, *name = test.split("::")
        assert (ROOT / path).exists(), test
        for part in name:
            assert f"def {part.split('[')[0]}(" in text(path), test


def test_names_are_different() -> None:
    assert [name for name, n in Counter(patch.name for patch in PATCHES).items() if n > 1] == []
