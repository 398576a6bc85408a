"""A task that asks for every future: what it costs, what is told, and what it leaves alone."""

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from vrts.assignments.pack import student_zip
from vrts.assignments.task_folder import read_folder
from vrts.check.judge import judge
from vrts.check.mark.grade import REVIEW
from vrts.check.verdict import Answer, Verdict
from vrts.dispatch.planning.reasons.futures import USUAL, asked_of
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.environments import usual_environment
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.formats.json_form import assessment_json
from vrts.report.page.page import page

TASK = """\
[task]
title = "Through the gate"
scene = "cans-on-bases"

[[via]]
name = "behind the gate"
at_mm = [900, -300, 100]

[time]
reference_s = 5
"""
ASKS = '\n[prove]\nenvironment = "cell.toml"\n'
EXAMPLE = "[[inputs]]\nsignal = 1001\non_s = [2.0]\n"
CELL = """\
title = "a gate <b>"

[[inputs]]
signal = 1001
is = "pulsed"
off_s = [0.5, 10.0]
on_s = [5.0]

[[never]]
title = "in the <b>gate</b> while it is shut"
signals = [-1001]
region_mm = { from = [800, -100, 0], to = [1000, 100, 300] }
"""
PROGRAM = """\
.PROGRAM main()
        MOVE before
{waits}        MOVES behind
.END
.LOCATIONS
before 900 300 100 90 90 0
behind 900 -300 100 90 90 0
.END
"""
WAITS = PROGRAM.format(waits="        WAIT SIG(1001)\n")
FITS = PROGRAM.format(waits="        BREAK\n        DELAY 2.5\n")
CHECK = "demand every future"


def written(folder: Path, asks: str = ASKS, cell: str = CELL) -> Path:
    (folder / "task.toml").write_text(TASK + asks)
    (folder / "scenario.toml").write_text(EXAMPLE)
    (folder / "cell.toml").write_text(cell)
    return folder


def assessed(setting: Setting, text: str) -> Assessment:
    return assess(Request(ProgramFile(text.encode(), "prog.v2"), setting))


def verdict_of(a: Assessment) -> Verdict:
    assert a.judgement is not None
    (found,) = (one for one in a.judgement.verdicts if one.check == CHECK)
    return found


def test_a_program_that_fits_the_example_alone_loses_points_and_is_told_why(tmp_path: Path) -> None:
    setting = load_task(written(tmp_path))
    assert setting.task is not None
    without = assessed(replace(setting, task=replace(setting.task, proof=None)), FITS)
    assert without.grade is not None
    assert without.grade.mark == 10, "it fits the example"

    a = assessed(setting, FITS)
    assert a.grade is not None
    assert (a.grade.demands, a.grade.ready) == (3, False)
    loss = next(loss for loss in a.grade.losses if loss.kind == "demand")
    assert loss.points == 3
    assert loss.sentence.startswith("even if nothing comes from outside, at 4.")
    assert "line 5 `MOVES behind`, never: in the <b>gate</b> while it is shut" in loss.sentence
    assert loss.span is not None
    assert loss.span.line == 5
    (finding,) = verdict_of(a).findings
    assert finding.rule.code == "V560"
    scenario = finding.data["scenario"]
    assert isinstance(scenario, str)
    assert '"never: in the <b>gate</b> while it is shut"' in scenario


@pytest.mark.thorough
def test_a_program_that_waits_loses_nothing(tmp_path: Path) -> None:
    a = assessed(load_task(written(tmp_path)), WAITS)
    assert a.grade is not None
    assert (a.grade.mark, a.grade.ready) == (10, True)
    found = verdict_of(a)
    assert found.answer is Answer.HOLDS
    assert found.summary.startswith("nothing goes wrong, in any future: 456 states, 359 decisions")
    earned = next(row for row in a.grade.earned if row.check == CHECK)
    assert (earned.title, earned.kind, earned.points) == ("every future", "demand", 0)


def test_what_cannot_be_told_costs_nothing_and_is_to_be_reviewed(tmp_path: Path) -> None:
    a = assessed(load_task(written(tmp_path, f"{ASKS}states = 5\n")), WAITS)
    found = verdict_of(a)
    assert found.answer is Answer.UNDETERMINED
    assert [d.rule.code for d in found.findings] == ["V564"]
    assert "futures were left after" in found.summary
    assert a.grade is not None
    assert (a.grade.mark, a.grade.lowest) == (10, Fraction(11, 2))
    assert a.grade.obstacles[0].startswith(f"{REVIEW}: {CHECK}: nothing went wrong as far as")


def test_nobody_proves_anything_where_no_task_asks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[object] = []

    def noted(setting: Setting, *_: object, **__: object) -> None:
        asked.append(setting)

    monkeypatch.setattr("vrts.pipeline.futures.prove", noted)
    a = assessed(load_task(written(tmp_path, asks="")), FITS)
    assert asked == []
    assert a.proof is None
    assert a.grade is not None
    assert a.grade.mark == 10


@pytest.mark.thorough
def test_a_run_without_a_proof_cannot_tell(tmp_path: Path) -> None:
    setting = load_task(written(tmp_path))
    a = assessed(setting, WAITS)
    assert a.run is not None
    (*_, last) = judge(setting.scene, a.run, setting.task).verdicts
    assert (last.check, last.answer) == (CHECK, Answer.UNDETERMINED)
    assert last.summary == "the futures of the program were not looked at"


def test_the_environment_may_stand_in_the_task_or_nowhere(tmp_path: Path) -> None:
    inner = "\n[[prove.environment.inputs]]\nsignal = 1001\nis = 'held'\nstate = 'on'\n"
    held = load_task(written(tmp_path, inner))
    environment = usual_environment(held)
    assert list(environment.inputs) == [1001]
    assert environment.scenario.inputs == (), "when inputs come in the example does not count"
    free = usual_environment(load_task(written(tmp_path, "\n[prove]\n")))
    assert (dict(free.inputs), free.scenario.inputs) == ({}, ())
    wrong = inner.replace("'held'", "'hold'")
    with pytest.raises(Refused) as refused:
        load_task(written(tmp_path, wrong))
    finding = refused.value.diagnostics[0]
    assert finding.primary is not None
    assert (finding.primary.span.source.name[-9:], finding.primary.span.text) == (
        "task.toml",
        "'hold'",
    )


def test_marks_depend_on_the_environment(tmp_path: Path) -> None:
    before = load_task(written(tmp_path)).task
    after = load_task(written(tmp_path, cell=CELL.replace("5.0", "6.0"))).task
    assert before is not None
    assert after is not None
    assert before.digest != after.digest


def test_an_environment_lies_in_the_folder_of_its_task(tmp_path: Path) -> None:
    folder = tmp_path / "task"
    folder.mkdir()
    (tmp_path / "cell.toml").write_text(CELL)
    with pytest.raises(CannotRead, match="outside the task's folder"):
        load_task(written(folder, '\n[prove]\nenvironment = "../cell.toml"\n'))
    with pytest.raises(CannotRead, match="cannot read"):
        load_task(written(folder, '\n[prove]\nenvironment = "other.toml"\n'))


def test_what_is_hidden_does_not_stand_where_students_read(tmp_path: Path) -> None:
    told = "\n[prove]\nhidden = true\n[[prove.environment.inputs]]\nsignal = 1001\nis = 'free'\n"
    for staff in (True, False):
        with pytest.raises(Refused) as refused:
            load_task(written(tmp_path, told), staff=staff)
        assert [d.rule.code for d in refused.value.diagnostics] == ["V683"]


def test_it_may_be_hidden_as_anything_else_that_a_task_asks_for(tmp_path: Path) -> None:
    (tmp_path / "staff").mkdir()
    (tmp_path / "staff" / "task.toml").write_text('[prove]\nenvironment = "cell.toml"\n')
    folder = written(tmp_path, asks="")
    public, whole = load_task(folder), load_task(folder, staff=True)
    assert public.task is not None
    assert whole.task is not None
    assert (public.task.proof, whole.hidden) == (None, 1)
    assert whole.task.proof is not None
    assert whole.task.proof.hidden
    files = read_folder(folder)
    assert "cell.toml" in files.staff
    assert "cell.toml" not in files.public


def test_an_environment_that_is_public_is_handed_out(tmp_path: Path) -> None:
    files = read_folder(written(tmp_path))
    assert files.public["cell.toml"] == CELL.encode()
    assert b"cell.toml" in student_zip(files, 0)


def test_a_controller_is_sent_what_is_proven_in_the_task_s_environment(tmp_path: Path) -> None:
    setting = load_task(written(tmp_path))
    found = asked_of(setting)
    assert (found.title, list(found.inputs)) == ("a gate <b>", [1001])
    assert found.again == USUAL.again, "a controller keeps its memory"
    assert asked_of(replace(setting, environment=None)) is USUAL


def test_text_json_and_page_tell_it(tmp_path: Path) -> None:
    (written(tmp_path) / "prog.v2").write_text(FITS)
    done = vrts_text("verify", tmp_path / "prog.v2", "--html", "page.html", cwd=tmp_path)
    assert done.returncode == 1
    assert done.stdout.startswith("5.5 / 10")
    assert "error[V560 in-some-future]" in done.stdout
    a = assessed(load_task(tmp_path), FITS)
    told = json.loads(json.dumps(assessment_json(a)))
    (row,) = (one for one in told["verdicts"] if one["check"] == CHECK)
    assert (row["answer"], row["evidence"]["environment"]) == ("violated", "a gate <b>")
    (finding,) = (one for one in told["findings"] if one["code"] == "V560")
    assert "[limits]" in finding["data"]["scenario"]
    text = page(a, {})
    assert text == page(a, {})
    section = text[text.index('id="futures"') :]
    assert "The scenario in which it happens" in section
    assert "in the &lt;b&gt;gate&lt;/b&gt;" in section
    assert "<b>gate" not in text
    assert 'href="#futures"' in text


def test_the_mark_is_the_same_again(tmp_path: Path) -> None:
    setting = load_task(written(tmp_path))
    first, again = (assessed(setting, FITS) for _ in range(2))
    assert assessment_json(first) == assessment_json(again)


@pytest.mark.thorough
def test_every_future_comes_last_among_the_verdicts(tmp_path: Path) -> None:
    asks = f'{ASKS}\n[[rule]]\nmust_use = "MOVES"\n'
    a = assessed(load_task(written(tmp_path, asks)), WAITS)
    assert a.judgement is not None
    assert [one.check for one in a.judgement.verdicts][-2:] == ["demand must use MOVES", CHECK]
