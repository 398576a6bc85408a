"""Every field of a model says what it rests on, and no time or choice stands outside the models."""

import ast
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.cli.shared.options import CONTROLLERS
from vrts.controllers.model import NoLength
from vrts.controllers.models import FIRST, MODELS, USUAL, VAL2, VPLUS, VRTS_1
from vrts.controllers.readings import BEFORE, READINGS, Reading, value_text
from vrts.controllers.values import differing, digest, values, with_value

MANUAL = ROOT / "vrts" / "manual"
MOTION = sorted((ROOT / "vrts" / "engine" / "motion").rglob("*.py"))
STEPS = sorted((ROOT / "vrts" / "engine" / "code" / "steps").glob("*.py"))
PLAIN = {0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 100.0}  # of formulas and of percent
ROUNDING = 1e-6  # less is a matter of rounding
KNOWN = {
    ("passage.py", 0.1),  # radians: how finely a way is looked at
    ("remarks.py", 179.5),  # degrees: what is told of a line, not how it goes
    ("frame_steps.py", 90.0),  # angles of BASE, as VAL counts them
    ("terminal_steps.py", 90.0),  # the same, listed
    ("setting_steps.py", 1000.0),  # the largest ACCEL that is no slip
}


@pytest.mark.parametrize("reading", READINGS, ids=lambda r: r.field)
def test_a_reading_has_a_source_and_a_rule_of_the_manual(reading: Reading) -> None:
    page, _, anchor = reading.rule.partition("#")
    text = (MANUAL / f"{page}.md").read_text("utf-8")
    assert f"({page.replace('/', '-')}-{anchor})=" in text
    for ground in (reading.ground, *reading.others.values()):
        assert ground.status in ("documented", "inferred", "assumed")
        assert ground.source
        assert "no document" in ground.source or BEFORE in ground.source or "[" in ground.source
    assert reading.about


def test_there_is_one_reading_for_every_field() -> None:
    assert [reading.field for reading in READINGS] == [name for name, _ in values(USUAL)]


def test_models_that_differ_say_why() -> None:
    for model in MODELS.values():
        said = {reading.field for reading in READINGS if model.name in reading.others}
        assert said == set(differing(model, USUAL)), model.name


def test_the_first_model_never_changes() -> None:
    assert VRTS_1 is FIRST
    assert digest(VRTS_1) == "ae011754b2aca1369ab5ce344e16f5f5ce661baf0251da31b5af3abf107219aa"
    assert (
        digest(VAL2) == "db6e0a672fd19007dec751ccc1ccb478dce30f26161bb709d2b7812b6969ff19"
    )  # a change makes another model: give it another name
    assert digest(VPLUS) == "2f110e4d68ab98a0c1865fa81dafbdfd952574723065490c1700b90e8b5fc979"


def test_a_digest_is_of_what_a_model_says() -> None:
    assert len({digest(model) for model in MODELS.values()}) == len(MODELS)
    changed = with_value(VAL2, "pace.no_length", NoLength.BY_KIND)
    assert digest(changed) != digest(VAL2)
    assert digest(with_value(changed, "pace.no_length", NoLength.NO_TIME)) == digest(VAL2)
    assert list(differing(changed, VAL2)) == ["pace.no_length"]


def test_a_field_that_is_not_there_is_not_made() -> None:
    with pytest.raises(AttributeError):
        with_value(VAL2, "pace.height", 1.0)


def test_commands_offer_every_model() -> None:
    assert tuple(MODELS) == CONTROLLERS


def test_values_are_told_in_words() -> None:
    assert value_text(None) == "none"
    assert value_text(True) == "yes"
    assert value_text(0.016, "s") == "0.016 s"


def odd_numbers(name: str, text: str) -> list[float]:
    """Return the numbers of a module that may decide about time."""
    found = [
        node.value
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Constant) and isinstance(node.value, float)
    ]
    return [v for v in found if v not in PLAIN and v > ROUNDING and (name, v) not in KNOWN]


@pytest.mark.parametrize("path", [*MOTION, *STEPS], ids=lambda p: p.name)
def test_no_number_of_time_stands_outside_the_models(path: Path) -> None:
    assert odd_numbers(path.name, path.read_text("utf-8")) == []


def test_a_number_of_time_is_noticed() -> None:
    assert odd_numbers("profile.py", "TACC = 0.224\n\ndef f():\n    return 2.0 * 1e-9") == [0.224]
