"""No output for students tells more of what led to a loss than the task's `[hints]` allow."""

import json
from dataclasses import replace
from functools import cache

import pytest

from tests.places import ROOT
from vrts.check.rules.hints import Hints
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.report.because import because, told_to
from vrts.report.formats.json_form import assessment_json
from vrts.report.formats.json_text import json_text
from vrts.report.formats.why_json import chains_json
from vrts.report.page.page import page
from vrts.report.screen.assessment_text import assessment_text
from vrts.report.screen.causes.why_text import why_text

SAID = "the hand closes on nothing, at X 450 Y 750 Z -225"
TOWARD = "too far in -X and too far in +Y for"
AMOUNT = "300 mm too far in -X"
EXACT = "can be gripped from Z -240"


@cache
def lost(
    name: str = "01-cans-on-bases/submissions/x-and-y-swapped.v2", *, collisions: bool = False
) -> Assessment:
    path = ROOT / "examples" / name
    setting = setting_for(path, Where())
    assert setting is not None
    file = ProgramFile(path.read_bytes(), path.name)
    checks = Checks(collisions=collisions, causes=True)
    return assess(Request(file, setting, checks=checks))


def at(level: Hints, a: Assessment | None = None) -> Assessment:
    a = lost() if a is None else a
    assert a.task is not None
    return replace(a, task=replace(a.task, hints=level))


def plain(text: str) -> str:
    return text.replace("<code>", "").replace("</code>", "").replace("`", "").lower()


def outputs(a: Assessment, audience: Audience) -> dict[str, str]:
    level = told_to(a, audience)
    found = {
        "page": page(a, {}, audience=audience, scripts=()),
        "why": why_text(a, because(a), level, whole=True, color=False),
        "why json": json_text(chains_json(a, because(a), level)),
    }
    if audience is Audience.STUDENT:
        found["verify"] = assessment_text(a, color=False)
        found["verify json"] = json_text(assessment_json(a))
    return {name: plain(text) for name, text in found.items()}


@pytest.mark.parametrize("level", Hints)
@pytest.mark.parametrize("audience", Audience)
def test_each_output_tells_what_the_level_allows_and_no_more(
    level: Hints, audience: Audience
) -> None:
    told = level if audience is Audience.STUDENT else Hints.EDIT
    for name, text in outputs(at(level), audience).items():
        if name == "verify":  # it tells the whole of the first loss only
            assert (AMOUNT.lower() in text or "1250 mm too far" in text) is (told >= Hints.NUMBER)
            assert ("too far in" in text) is (told >= Hints.DIRECTION)
            assert ("at x -450 y 800" in text) is (told >= Hints.PLACE)
            continue
        assert (plain(SAID) in text) is (told >= Hints.PLACE), name
        assert (plain(TOWARD) in text) is (told is Hints.DIRECTION), name
        assert (plain(AMOUNT) in text) is (told >= Hints.NUMBER), name
        assert (plain(EXACT) in text) is (told >= Hints.NUMBER), name
        assert ("too far in" in text) is (told >= Hints.DIRECTION), name


def test_a_loss_in_json_has_its_causes() -> None:
    losses = json.loads(json_text(assessment_json(at(Hints.EDIT))))["losses"]
    first = losses[0]["because"]
    assert [link["line"] for link in first] == [8, 7, 26]
    assert first[-1]["time_s"] is None
    assert losses[-1]["because"] == []


@pytest.mark.thorough
@pytest.mark.parametrize("level", Hints)
def test_the_height_that_would_do_is_told_with_numbers_alone(level: Hints) -> None:
    between = lost("03-around-obstacles/submissions/hits-post.v2", collisions=True)
    for name, text in outputs(at(level, between), Audience.STUDENT).items():
        assert ("post stands between the two places" in text) is (level >= Hints.PLACE), name
        assert ("a point on the way is missing" in text) is (level is Hints.DIRECTION), name
        assert ("with the tool at z 35 or more" in text) is (level >= Hints.NUMBER), name
