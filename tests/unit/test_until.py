"""A run with a time limit begins nothing later, and says what it left out."""

import math
import time

import pytest

from tests import until
from tests.__main__ import MINUTES, PATCHES_MIN, REST, with_time
from tests.sabotage import __main__ as sabotage

PAST = -1.0


def minutes(end: float | None) -> float:
    (told,) = (word for word in with_time(REST["sabotage"], end) if word.startswith(MINUTES))
    return float(told.removeprefix(MINUTES))


@pytest.mark.parametrize(
    ("left_min", "told_min"),
    [(None, PATCHES_MIN), (500.0, PATCHES_MIN), (10.0, 8.0), (1.0, 0.0), (PAST, 0.0)],
)
def test_patches_get_what_is_left(left_min: float | None, told_min: float) -> None:
    end = None if left_min is None else time.monotonic() + 60.0 * left_min
    assert math.isclose(minutes(end), told_min, abs_tol=0.11)


def test_without_time_no_patch_is_tried(capsys: pytest.CaptureFixture[str]) -> None:
    assert sabotage.main(["--passed", "--minutes=0.0"]) == 0
    said = capsys.readouterr().out
    assert "no time is left" in said
    assert f"{len(sabotage.PATCHES)} patches not tried" in said


def test_a_test_that_comes_too_late_is_skipped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(until.NAME, raising=False)
    until.skip_if_over()
    monkeypatch.setenv(until.NAME, str(time.monotonic() + 1000.0))
    until.skip_if_over()
    monkeypatch.setenv(until.NAME, str(PAST))
    with pytest.raises(pytest.skip.Exception, match=until.REASON):
        until.skip_if_over()


def test_the_order_is_that_of_the_commit() -> None:
    once = until.shuffled(range(40))
    assert once == until.shuffled(range(40))
    assert once != list(range(40))
    assert sorted(once) == list(range(40))
