"""`import vrts` and the commands of the same names answer alike."""

import json
from pathlib import Path
from subprocess import CompletedProcess

import numpy as np
import pytest

import vrts
from tests import support_commands
from tests.places import ROOT

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
HITS = EXAMPLE / "submissions" / "hits-base.v2"
READS = ".PROGRAM go()\nIF SIG(1001) THEN\nDRIVE 1, 900, 100\nEND\n.END\n"


def run_vrts(*words: str) -> CompletedProcess[str]:
    return support_commands.vrts_text(*words)


@pytest.fixture(scope="module")
def hits() -> vrts.Assessment:
    return vrts.verify(HITS)


def test_verify_says_what_the_command_says(hits: vrts.Assessment) -> None:
    said = json.loads(run_vrts("verify", str(HITS), "--format", "json").stdout)
    assert json.loads(json.dumps(hits.to_dict())) == said
    assert (hits.mark, hits.total, hits.status) == (7.0, 10.0, "graded")
    assert sum(loss.points for loss in hits.losses) == pytest.approx(3.0)
    assert [contact[:2] for contact in hits.contacts] == [("can1", "base1")]
    assert (hits.contacts[0].line, hits.contacts[0].depth_mm) == (11, 59.0)
    assert not hits.ok
    assert not hits.ready


def test_why_says_what_the_command_says(hits: vrts.Assessment) -> None:
    found = vrts.why(hits)
    assert str(found) == run_vrts("why", str(HITS), "--color", "never").stdout.rstrip("\n")
    assert found[0].causes[-1].line == 10
    of_can = vrts.why(hits, of="can1")
    asked = run_vrts("why", str(HITS), "--of", "can1", "--color", "never").stdout
    assert str(of_can) == asked.rstrip("\n")


@pytest.mark.thorough
def test_a_certificate_is_taken_by_the_checker(hits: vrts.Assessment, tmp_path: Path) -> None:
    found = vrts.certificate(hits)
    assert found.contacts == 1
    done = run_vrts("check-proof", str(found.save(tmp_path / "run.cert")), str(HITS))
    assert done.returncode == 0
    assert done.stdout.splitlines()[1:] == str(found).splitlines()[1:]


def test_prove_says_what_the_command_says(tmp_path: Path) -> None:
    program = tmp_path / "reads.v2"
    program.write_text(READS)
    found = vrts.prove(program)
    said = run_vrts("prove", str(program), "--color", "never", "--dialect", "auto")
    assert said.returncode == 1
    assert str(found) == said.stdout.rstrip("\n")
    assert (found.answer, found.holds, len(found.futures)) == ("violated", False, 1)
    scenario = found.futures[0].save(tmp_path / "bad.toml")
    again = vrts.run(program, scenario=scenario)
    assert (again.ending, again.ok) == ("error", False)


def test_run_says_what_the_command_says(hits: vrts.Assessment, tmp_path: Path) -> None:
    found = vrts.run(HITS)
    table = run_vrts("run", str(HITS), "--csv", "-", "--rate", "10").stdout
    assert found.to_csv(rate_hz=10.0) == table
    assert str(found.at(4.5)) == run_vrts("run", str(HITS), "--at", "4.5").stdout.rstrip("\n")
    saved = vrts.run(found.save(tmp_path / "out.vrun"))
    assert saved.to_csv(rate_hz=10.0) == table
    assert hits.run.events == found.events
    assert run_vrts("run", str(tmp_path / "out.vrun"), "--check").returncode == 0


def test_mark_says_what_grade_says(tmp_path: Path) -> None:
    programs = sorted((EXAMPLE / "submissions").glob("*.v2"))[:3]
    marks = [found.mark for found in vrts.mark(programs, EXAMPLE)]
    expected = json.loads((EXAMPLE / "expected.json").read_text())
    assert marks == [expected[f"submissions/{path.name}"]["mark"] for path in programs]
    alone = vrts.mark(programs[0], vrts.task("01-cans-on-bases"))
    assert alone.mark == marks[0]


def test_many_times_at_once_are_what_single_times_are(hits: vrts.Assessment) -> None:
    run = hits.run
    times = np.linspace(0.0, run.duration_s, 23)
    joints, tool = run.joints(times), run.tool(times)
    assert joints.deg.shape == joints.rad.shape == joints.deg_s.shape == (23, 6)
    assert (tool.mm.shape, tool.oat_deg.shape, tool.rotation.shape) == (
        (23, 3),
        (23, 3),
        (23, 3, 3),
    )
    assert np.rad2deg(joints.rad) == pytest.approx(joints.deg)
    for k, time_s in enumerate(times.tolist()):
        there = run.at(time_s)
        assert there.joints_deg == pytest.approx(joints.deg[k].tolist(), abs=1e-9)
        assert there.tool[:3] == pytest.approx(tool.mm[k].tolist(), abs=1e-6)
        turn = np.deg2rad(np.array(there.tool[3:]) - tool.oat_deg[k])
        assert np.cos(turn) == pytest.approx(1.0, abs=1e-6)
    step = 1e-5
    near = run.joints([3.0, 3.0 + step])
    assert (near.deg[1] - near.deg[0]) / step == pytest.approx(near.deg_s[0], abs=0.5)
    assert run.joints([]).deg.shape == (0, 6)
    assert run.tool(1.0).mm.shape == (1, 3)


def test_a_scene_and_a_task_that_were_read_serve_many_programs() -> None:
    task = vrts.task(EXAMPLE)
    assert (task.title, task.points, task.good_time_s > 0.0) == ("Cans on bases", 10.0, True)
    assert vrts.verify(HITS, task=task).mark == 7.0
    bare = vrts.verify(HITS, scene=task.scene)
    assert (bare.mark, bare.status) == (None, "violated")
    assert vrts.run(HITS, scene=vrts.scene("cans-on-bases")).duration_s == pytest.approx(12.264)
    grip = vrts.scene("cans-on-bases").locations["can1_grip"]
    assert (grip.x_mm, grip.y_mm, grip.o_deg) == (800.0, -450.0, 90.0)


def test_a_scene_and_a_task_go_together_whether_read_or_named() -> None:
    lazy = ".PROGRAM lazy()\nDELAY 1\n.END\n"
    named = vrts.verify(lazy, scene="cans-on-bases", task=EXAMPLE)
    assert (named.mark, named.total) == (0.0, 10.0)
    scene, task = vrts.scene("cans-on-bases"), vrts.task(EXAMPLE)
    for found in (
        vrts.verify(lazy, scene=scene, task=EXAMPLE),
        vrts.verify(lazy, scene="cans-on-bases", task=task),
        vrts.verify(lazy, scene=scene, task=task),
    ):
        assert found.to_dict() == named.to_dict()


def test_a_scene_beside_a_program_never_stands_for_one_of_the_library(tmp_path: Path) -> None:
    """Whoever hands a program in may hand in a scene, too."""
    program = tmp_path / "lazy.v2"
    program.write_text(".PROGRAM lazy()\nDELAY 1\n.END\n")
    (tmp_path / "cans-on-bases").mkdir()
    (tmp_path / "cans-on-bases" / "scene.toml").write_text("nonsense")
    found = vrts.verify(program, scene="cans-on-bases", task=vrts.task(EXAMPLE))
    assert (found.mark, found.total) == (0.0, 10.0)


def test_a_program_that_does_not_compile_is_an_answer() -> None:
    wrong = ".PROGRAM go()\nSPED 30\n.END\n"
    found = vrts.compile(wrong)
    assert not found.ok
    assert found.codes == ("V120",)
    assert "did you mean `SPEED`?" in found.problems[0]
    marked = vrts.mark(wrong, "01-cans-on-bases")
    assert (marked.mark, marked.status, marked.codes) == (0.0, "does not compile", ("V120",))
    right = vrts.compile(".PROGRAM go()\nDRIVE 1, 30, 100\n.END\n")
    assert right.ok
    assert right.names == ("go",)
    assert right.store().startswith(".PROGRAM go")
    assert "DRIVE" in right.ir().upper()
