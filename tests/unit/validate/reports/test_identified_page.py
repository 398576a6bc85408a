"""What is wrong with a robot as page, and as JSON by its schema."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import jsonschema
import msgspec
import pytest

from tests.support_commands import vrts_text
from tests.unit.validate.identify.test_identify import WITHOUT, log_of
from tests.unit.validate.support import EXAMPLE, turning_run
from vrts.report.formats.json_text import json_text
from vrts.validate.identify.identify import Identified, identify_log
from vrts.validate.reports.identified_json import identified_json, identified_schema
from vrts.validate.reports.identified_page import identified_page
from vrts.validate.reports.identified_schema import IdentifiedForm
from vrts.validate.reports.identified_text import sentence


@cache
def identified() -> Identified:
    """Return what is found of a joint whose zero is wrong."""
    wrong = WITHOUT._replace(zero_deg=(0.0, 0.0, 0.5, 0.0, 0.0, 0.0))
    return identify_log(turning_run(), log_of(turning_run(), wrong))


def test_the_page_says_the_sentence_the_numbers_and_what_is_not_known() -> None:
    page = identified_page(replace(identified(), log="<b>log</b>"), "<i>turns</i>.v2")
    said = sentence(identified())
    assert said[0].upper() + said[1:] in page
    (number,) = identified().numbers
    assert "joint 3 [deg]" in page
    assert f"{number.value * 57.29577951308232:+.4f}" in page
    assert "What this log cannot tell" in page
    assert "left over" in page
    assert "<i>turns" not in page
    assert "<b>log" not in page


def test_json_is_as_its_schema_says() -> None:
    document = json.loads(json_text(identified_json(identified())))
    jsonschema.validate(document, identified_schema())
    assert msgspec.convert(document, IdentifiedForm)["causes"][0]["name"] == "joint 3"
    broken = {**document, "causes": [{"name": "joint 3"}]}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(broken, identified_schema())
    printed = vrts_text("schema", "identified")
    assert json.loads(printed.stdout) == json.loads(json_text(identified_schema()))


def test_page_and_lab_belong_to_one_log(tmp_path: Path) -> None:
    log = EXAMPLE / "robot.csv"
    both = ("--log", log, "--log", log, "--identify")
    for option in ("-o", "--html"):
        said = vrts_text("validate", EXAMPLE / "path.v2", *both, option, tmp_path / "out")
        assert said.returncode == 2
        assert "-o and --html take one log" in said.stderr
    fit = ("--log", log, "--fit", "--html", tmp_path / "out.html")
    assert vrts_text("validate", EXAMPLE / "path.v2", *fit).returncode == 2
