"""What is told about contacts, doubts and near misses: every fact, up to JSON and mark."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.support_programs import ROOT, cans
from vrts.base.source import SourceFile
from vrts.base.units import mm
from vrts.check.collision import collision
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import plan
from vrts.check.collision.second_opinion import Witness, measured
from vrts.check.curves.timeline_arrays import curves
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer
from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Array, Proposals, Proposer, Questions
from vrts.geometry.proving.prover import Prover
from vrts.geometry.support import bounds
from vrts.pipeline.assess import assess
from vrts.pipeline.request import Checks
from vrts.pipeline.requesting import request_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.formats.json_form import assessment_json
from vrts.report.screen.assessment_text import assessment_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
TASK = (EXAMPLE / "task.toml").read_text("utf-8")
HITS = (EXAMPLE / "submissions" / "hits-base.v2").read_text("utf-8")
LOW = "low 800 150 -285.2 90 90 0\n"  # the fingertips 0.2 mm inside the table, near nothing else


def assessed(
    folder: Path, program: str, task: str = TASK, second: Proposer | None = None
) -> Assessment:
    (folder / "task.toml").write_text(task, encoding="utf-8")
    (folder / "mine.v2").write_text(program, encoding="utf-8")
    where = Where(task=folder / "task.toml")
    return assess(request_for(folder / "mine.v2", where, checks=Checks(second=second)))


def collisions(a: Assessment) -> dict[str, Any]:
    return json.loads(json.dumps(assessment_json(a), allow_nan=False))["collisions"]


def touching(program: str) -> str:
    """A program that begins with a touch at the tolerance."""
    program = program.replace("MOVE safe\n", "MOVE safe\nMOVE low\nBREAK\nMOVE safe\n", 1)
    return program.replace(".LOCATIONS\n", f".LOCATIONS\n{LOW}", 1)


def looked_at(a: Assessment, found: dict[str, Any]) -> tuple[Array, Array]:
    """Return times round an event, every tenth of a millisecond, and how deep its pair is [m]."""
    assert a.run is not None
    assert a.scene is not None
    motion = curves(a.run.timeline.segments)
    todo = plan(a.scene, a.run, motion)
    prober = Prober(a.scene.robot.arm, motion, todo.solids, Prover(todo.solids, here()))
    pairs = todo.pairs
    times = np.arange(found["start_s"] - 0.1, found["end_s"] + 0.1, 1e-4)
    depth = np.full(len(times), -np.inf)
    group = todo.groups.index(("robot", found["bodies"][1]))  # the can moves with it
    for row in np.flatnonzero((pairs.group == group) & pairs.grazes).tolist():
        now = np.flatnonzero((pairs.start_s[row] <= times) & (times <= pairs.end_s[row]))
        first, second = np.full((2, len(now)), [[pairs.first[row]], [pairs.second[row]]])
        by_coal = measured(ByCoal().propose(prober.questions(first, second, times[now])))
        depth[now] = np.maximum(depth[now], -by_coal)
    return times, depth


@pytest.mark.thorough
def test_every_fact_of_a_contact_stands_in_the_json(tmp_path: Path) -> None:
    a = assessed(tmp_path, HITS)
    assert a.run is not None
    assert a.scene is not None
    assert a.source is not None
    (found,) = collisions(a)["contacts"]
    assert found["bodies"] == ["can1", "base1"]
    assert found["parts"] == ["can1", "base1"]
    assert found["held"] == "can1"
    times, depth = looked_at(a, found)
    deep = times[depth > 2e-4]
    assert found["start_s"] == pytest.approx(deep[0], abs=1e-3)
    assert found["end_s"] == pytest.approx(deep[-1], abs=1e-3)
    assert found["depth_mm"] == pytest.approx(mm(float(depth.max())), rel=0.02)
    assert found["start_s"] <= found["deepest_s"] <= found["end_s"]
    base = a.scene.body("base1")
    box = bounds(base.pieces, base.X_WO)
    for low, value, high in zip(box.lower, found["point_mm"], box.upper, strict=True):
        assert mm(low) - found["depth_mm"] <= value <= mm(high) + found["depth_mm"]
    under_way = next(m for m in a.run.motions if m.start_s <= found["start_s"] <= m.end_s)
    assert found["line"] == under_way.cause.span.line
    assert "APPROS base2_put" in HITS.splitlines()[found["line"] - 1]


@pytest.mark.thorough
def test_every_fact_of_a_graze_stands_in_the_json(tmp_path: Path) -> None:
    a = assessed(tmp_path, touching(SOLUTION).replace("-285.2", "-285.1"))
    assert a.grade is not None
    assert (a.grade.mark, a.grade.lowest, a.grade.ready) == (10, None, True)
    told = collisions(a)
    assert told["certified"]
    assert told["contacts"] == told["undetermined"] == []
    (found,) = told["grazes"]
    assert found["bodies"] == ["robot", "table"]
    assert found["parts"][0] in ("left finger", "right finger")
    assert found["depth_mm"] == pytest.approx(0.1, abs=0.01)
    assert found["held"] is None
    assert a.source is not None
    assert a.source.text.splitlines()[int(found["line"]) - 1].strip() == "MOVE low"
    times, depth = looked_at(a, found)
    touching_at = times[depth > 1e-5]
    assert found["start_s"] == pytest.approx(touching_at[0], abs=1.1e-3)
    assert found["end_s"] == pytest.approx(touching_at[-1], abs=1.1e-3)


def test_what_cannot_be_told_costs_nothing_and_is_for_review(tmp_path: Path) -> None:
    a = assessed(tmp_path, touching(SOLUTION))
    assert a.grade is not None
    assert a.judgement is not None
    assert a.judgement.answer is Answer.UNDETERMINED
    told = collisions(a)
    assert not told["certified"]
    assert told["contacts"] == []
    assert {row["bodies"][1] for row in told["undetermined"]} == {"table"}
    assert all(abs(row["depth_mm"] - 0.2) <= 0.01 for row in told["undetermined"])
    count = len(told["undetermined"])
    assert a.grade.mark == 10
    assert a.grade.lowest == 8 - count  # 1.5 for the first, 1 for each other, no time bonus
    assert not a.grade.ready
    review = f"to be reviewed: the mark is between {8.0 - count} and 10.0"
    assert review in a.grade.obstacles


def test_a_doubt_beside_a_contact_is_for_review_too(tmp_path: Path) -> None:
    hit, both = assessed(tmp_path, HITS), assessed(tmp_path, touching(HITS))
    assert hit.grade is not None
    assert both.grade is not None
    assert both.judgement is not None
    assert both.judgement.answer is Answer.VIOLATED
    assert hit.grade.lowest is None
    assert both.grade.mark == hit.grade.mark
    assert both.grade.lowest == hit.grade.mark - 1


def test_a_task_says_how_near_a_near_miss_is(tmp_path: Path) -> None:
    usual = assessed(tmp_path, SOLUTION)
    wide = assessed(tmp_path, SOLUTION, TASK + "\n[collision]\nnear_miss_mm = 12\n")
    assert usual.grade is not None
    assert wide.grade is not None
    assert wide.grade.mark == usual.grade.mark == 10
    assert wide.grade.ready
    before, after = collisions(usual), collisions(wide)
    assert (before["near_miss_mm"], before["near_miss_assumed"]) == (5.0, True)
    assert (after["near_miss_mm"], after["near_miss_assumed"]) == (12.0, False)
    assert before["near_misses"] == []
    # the open fingers stand 10 mm from a can on either side before they close
    for miss, can in zip(after["near_misses"][:2], ("can1", "can2"), strict=True):
        assert miss["bodies"] == ["robot", can]
        assert miss["parts"][0] in ("left finger", "right finger")
        assert miss["distance_mm"] == pytest.approx(10.0, abs=0.1)
        assert miss["start_s"] <= miss["nearest_s"] <= miss["end_s"]
        a, b = np.array(miss["witnesses_mm"])
        assert np.linalg.norm(a - b) == pytest.approx(miss["distance_mm"], abs=0.02)
        assert miss["held"] is None
        assert "MOVES start" in SOLUTION.splitlines()[miss["line"] - 1]
    text = assessment_text(wide, color=False)
    assert "warning[V411 near-miss]" in text
    assert "V411" not in assessment_text(usual, color=False)


@pytest.mark.parametrize("wrong", ["near_miss_mm = 0.1", "near_miss_mm = 80", "near_mis_mm = 5"])
def test_a_wrong_threshold_is_pointed_out(wrong: str) -> None:
    text = f"{TASK}\n[collision]\n{wrong}\n"
    task, (found,) = read_task(SourceFile("task.toml", text), cans())
    assert task is None
    assert found.primary is not None
    assert found.primary.span.line == len(text.splitlines())


def test_contacts_near_misses_and_the_clearance_are_asked_about_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Witness] = []
    really = collision.disagreements

    def noted(ours: Prober, by: Proposer, witnesses: list[Witness]) -> tuple[str, ...]:
        asked.extend(witnesses)
        return really(ours, by, witnesses)

    monkeypatch.setattr(collision, "disagreements", noted)
    hit = collisions(assessed(tmp_path, HITS, second=ByCoal()))
    times = [round(witness.time_s, 3) for witness in asked]
    assert times == [row["deepest_s"] for row in hit["contacts"]]
    asked.clear()
    wider = TASK + "\n[collision]\nnear_miss_mm = 12\n"
    wide = collisions(assessed(tmp_path, SOLUTION, wider, second=ByCoal()))
    times = [round(witness.time_s, 3) for witness in asked]
    assert times[:-1] == [row["nearest_s"] for row in wide["near_misses"]]
    assert times[-1] == wide["clearance"]["time_s"]


class Nearer(ByCoal):
    """Measures a millimetre too near."""

    name = "nearer"

    def propose(self, asked: Questions) -> Proposals:
        found = super().propose(asked)
        return found._replace(second=found.second - 1e-3 * found.normal)


def test_a_disagreement_keeps_the_verdict_and_is_for_review(tmp_path: Path) -> None:
    usual = assessed(tmp_path, SOLUTION)
    disputed = assessed(tmp_path, SOLUTION, second=Nearer())
    assert usual.grade is not None
    assert usual.judgement is not None
    assert disputed.grade is not None
    assert disputed.judgement is not None
    assert collisions(usual)["disagreements"] == []
    (words,) = collisions(disputed)["disagreements"]
    assert "10.00 mm proven, nearer measures 9.00 mm" in words
    assert disputed.judgement.answer is usual.judgement.answer is Answer.HOLDS
    assert replace(disputed.grade, ready=True, obstacles=()) == usual.grade
    assert f"to be reviewed: two engines disagree: {words}" in disputed.grade.obstacles
