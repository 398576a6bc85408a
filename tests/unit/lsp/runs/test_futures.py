"""What an editor is told of futures that the run of a program does not show."""

import tomllib
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.base.diagnostic import Severity
from vrts.lsp.channel.findings import Finding
from vrts.lsp.channel.verification import Answer, Asked, answer_of, line_of
from vrts.lsp.runs.verifying import verify

TASK = (ROOT / "examples" / "01-cans-on-bases" / "task.toml").read_text("utf-8")
LOWERS = """.PROGRAM main
        SPEED 50 ALWAYS
        MOVE #PPOINT(0,-30,90,0,0,0)
        {}
          MOVE #PPOINT(0,10,90,0,0,0)
        END
        READY
.END
"""
IF_INPUT = LOWERS.format("IF SIG(1001) THEN")
PROVE = "\n[prove]\nhidden = {}\n[prove.environment]\n[[prove.environment.inputs]]\n"
NEVER_ON = 'signal = 1001\nis = "held"\nstate = "off"\n'


def futures(text: str, folder: Path, more: str = "") -> list[Finding]:
    (folder / "task.toml").write_text(TASK + more, "utf-8")
    return [f for f in verify(Asked(str(folder / "a.v2"), text)).findings if f.code == "V560"]


def test_what_some_input_does_is_told_where_it_happens_with_its_scenario(tmp_path: Path) -> None:
    (finding,) = futures(IF_INPUT, tmp_path)
    assert finding.severity is Severity.WARNING, "nobody asked for a proof"
    assert IF_INPUT[finding.start : finding.end] == "READY", "deepest in the corner before it"
    first, second, third = finding.message.splitlines()
    assert first.startswith("for some inputs: robot touches base2, ")
    assert second == "note: at 0.000 s, line 4: input 1001 is on"
    assert third == "found in the scene `cans-on-bases`"
    assert tomllib.loads(finding.scenario)["inputs"] == [{"signal": 1001, "on_s": [0]}]
    answer = Answer(findings=(finding,), is_whole=True)
    assert answer_of(line_of(answer)) == answer


def test_a_warning_becomes_an_error_where_a_task_asks(tmp_path: Path) -> None:
    (finding,) = futures(IF_INPUT, tmp_path, "\n[prove]\n")
    assert finding.severity is Severity.ERROR


def test_the_environment_of_the_task_counts(tmp_path: Path) -> None:
    assert futures(IF_INPUT, tmp_path, PROVE.format("false") + NEVER_ON) == []


def test_a_property_that_no_run_checks_is_told_whatever_comes(tmp_path: Path) -> None:
    text = IF_INPUT.replace("        READY", "        SIGNAL 3\n        READY")
    never = '[[prove.environment.never]]\ntitle = "no lamp"\nsignals = [3]\n'
    found = futures(text, tmp_path, PROVE.format("false") + NEVER_ON + never)
    assert [one.message.split(":")[0] for one in found] == ["even if nothing comes from outside"]


@pytest.mark.parametrize("when", ["IF TRUE THEN", "IF TIMER(1) >= 0 THEN", "IF NOT SIG(3) THEN"])
def test_what_the_run_shows_is_told_once(tmp_path: Path, when: str) -> None:
    assert futures(LOWERS.format(when), tmp_path) == []


def test_what_the_run_shows_is_not_told_again_of_other_inputs(tmp_path: Path) -> None:
    assert futures(LOWERS.format("IF NOT SIG(1001) THEN"), tmp_path) == []
