"""What messages say in V+ and AS is what V+ and AS have."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.lang.dialect import AS, VAL2, VPLUS, Dialect


def told(body: str, dialect: Dialect) -> list[Diagnostic]:
    """Return what is said of a program, and another that it may call."""
    text = (
        f".PROGRAM main()\n{body}\n.END\n.PROGRAM watch()\n WHILE busy DO\n  SIGNAL 1\n END\n.END\n"
    )
    return said(compiled(text, dialect))


@pytest.mark.parametrize(
    ("step", "dialect", "instead"),
    [
        ("SPEED 200 MMS ALWAYS", AS, "SPEED 200 MM/S ALWAYS"),
        ("SPEED 200 MMS", VPLUS, "SPEED 200 MMPS"),
        ("FOR i = 1 TO 3\nCONTINUE\nEND", VPLUS, "FOR i = 1 TO 3\nNEXT\nEND"),
        ("MOVE READY", VAL2, "READY"),
    ],
)
def test_edits_are_of_the_dialect(step: str, dialect: Dialect, instead: str) -> None:
    found = told(f"busy = 1\n{step}", dialect)[0]
    assert found.primary is not None
    text = found.primary.span.source.text
    assert f"\n{instead}\n" in with_edits(text, edits_of([found]))


def test_a_task_beside_may_end_a_loop() -> None:
    """Also where the step that begins it is wrong."""
    for step in ("EXECUTE 1 watch()", "EXECUTE 1, watch()"):
        found = told(f"busy = 1\n{step}\nbusy = 0", VPLUS)
        assert [d.headline for d in found if "never ends" in d.headline] == []
    assert "never ends" in told("busy = 1\nCALL watch()", VPLUS)[0].headline


def test_home_of_as_is_a_place_of_its_own() -> None:
    """A straight line may leave it, as it may not leave READY."""
    assert "V228" not in {d.rule.code for d in told("busy = 1\nHOME\nLMOVE a", AS)}
    assert "V228" in {d.rule.code for d in told("busy = 1\nREADY\nMOVES a", VAL2)}
