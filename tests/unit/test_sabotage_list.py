"""The list of patches is right without running them: `python -m tests --all` does."""

from collections import Counter

import pytest

from tests.places import ROOT
from tests.sabotage.patches import PATCHES, Patch

EACH = pytest.mark.parametrize("patch", PATCHES, ids=lambda patch: patch.name)


@EACH
def test_what_it_replaces_stands_once(patch: Patch) -> None:
    text = (ROOT / patch.file).read_text(encoding="utf-8")
    assert text.count(patch.before) == 1
    assert patch.after != patch.before


@EACH
def test_the_tests_that_notice_are_there(patch: Patch) -> None:
    for test in patch.tests:
        path, *name = test.split("::")
        assert (ROOT / path).exists(), test
        for part in name:
            assert f"def {part.split('[')[0]}(" in (ROOT / path).read_text(encoding="utf-8"), test


def test_names_are_different() -> None:
    assert [name for name, n in Counter(patch.name for patch in PATCHES).items() if n > 1] == []
