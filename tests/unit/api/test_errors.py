"""Wrong input is a `VrtsError` that says why, and never an error from inside."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import vrts
from tests.places import ROOT

TURN = ".PROGRAM turn()\nDRIVE 1, 30, 100\n.END\n"
WRONG = ".PROGRAM go()\nSPED 30\n.END\n"
SCENE, TASK = "cans-on-bases", "01-cans-on-bases"
anything: Any = vrts  # callers without types

CALLS: list[tuple[str, Callable[[Path], object], str]] = [
    ("no file", lambda _: vrts.run("nope.v2"), "cannot read `nope.v2`: no such file"),
    ("a folder", lambda path: vrts.run(path), "is a directory"),
    ("no path", lambda _: anything.run(5), "a path is wanted, not int"),
    ("no program", lambda _: vrts.run(WRONG), "`SPED` is not an instruction"),
    ("no such entry", lambda _: vrts.run(TURN, entry="x"), "there is no program `x`"),
    ("no dialect", lambda _: vrts.run(TURN, dialect="basic"), "there is no dialect `basic`"),
    ("no scene", lambda _: vrts.scene("moon"), "there is no scene `moon`"),
    ("no scene said", lambda _: vrts.verify(TURN), "nothing says in which scene"),
    ("no task", lambda _: vrts.task("moon"), "cannot read `moon`"),
    ("no model", lambda _: vrts.scene("cans-on-bases", controller="x"), "no controller model `x`"),
    ("no lab", lambda _: vrts.scene("cans-on-bases", lab="x.toml"), "cannot read `x.toml`"),
    ("lab alone", lambda _: vrts.run(TURN, lab="x.toml"), "a lab is laid over a scene"),
    ("no environment", lambda _: vrts.prove(TURN, environment="x"), "cannot read `x`"),
    ("no states", lambda _: vrts.prove(TURN, states=0), "`states` is a whole number, 1 or more"),
    ("late", lambda _: vrts.run(TURN).at(99), "the run goes from 0 to"),
    ("before", lambda _: vrts.run(TURN).joints([-1.0]), "not to -1 s"),
    ("no time", lambda _: vrts.run(TURN).tool([float("nan")]), "not to nan s"),
    ("no number", lambda _: anything.run(TURN).joints("soon"), "times are numbers, in s"),
    ("two axes", lambda _: vrts.run(TURN).joints([[1.0], [2.0]]), "an array of one axis"),
    ("rate", lambda _: vrts.run(TURN).to_csv(rate_hz=0.0), "`rate_hz` goes from 0.001"),
    ("no place", lambda path: vrts.run(TURN).save(path / "no" / "x"), "cannot write"),
    ("nothing ran", lambda _: vrts.certificate(WRONG, scene="cans-on-bases"), "nothing ran"),
    ("no run", lambda _: vrts.mark(WRONG, "01-cans-on-bases").run, "`SPED` is not an instruction"),
    ("no thing", lambda _: vrts.why(TURN, of="zork", scene="cans-on-bases"), "called `zork`"),
    ("not so long", lambda _: vrts.why(TURN, at_s=99, scene="cans-on-bases"), "the run lasts"),
    ("entry", lambda _: anything.run(TURN, entry=5), "`entry` is text, not int"),
    ("model", lambda _: anything.scene("cans-on-bases", controller=[]), "`controller` is text"),
    ("half", lambda _: anything.prove(TURN, states=1.5), "`states` is a whole number"),
    ("what to mark", lambda _: anything.mark(5, "01-cans-on-bases"), "`programs` is a program"),
    (
        "reader",
        lambda path: vrts.verify(TURN, scene="cans-on-bases").save_html(path, reader="x"),
        "`reader` is student or grader",
    ),
    ("half a sign", lambda _: vrts.run(TURN + "\ud800"), "error["),
    ("no real number", lambda _: anything.run(TURN).joints([1j]), "times are numbers"),
    ("null", lambda _: vrts.run("a\0b"), "without null characters"),
    ("half a name", lambda _: vrts.run("\ud800"), "a path is text that files can be called by"),
    ("long name", lambda _: vrts.task("x" * 300), "file name too long: `xxx"),
    ("long text", lambda _: vrts.verify(TURN, task="x" * 300), "file name too long: `xxx"),
    ("several times", lambda _: anything.run(TURN).at([0.0, 0.5]), "`at` takes one time"),
    ("no time at all", lambda _: anything.run(TURN).at([]), "`at` takes one time"),
    ("rate in words", lambda _: anything.run(TURN).to_csv(rate_hz="x"), "`rate_hz` is a number"),
    ("of what", lambda _: anything.why(TURN, of=5, scene=SCENE), "`of` is text, not int"),
    ("when", lambda _: anything.why(TURN, at_s="x", scene=SCENE), "`at_s` is a number, not str"),
    ("never ran", lambda _: vrts.why(WRONG, of="can1", scene=SCENE), "`SPED` is not an instr"),
    (
        "hidden part",
        lambda _: vrts.mark(TURN, vrts.task(TASK), staff=True),
        "with the hidden part or without it\nhelp: leave out `staff`",
    ),
    (
        "not checked",
        lambda _: vrts.certificate(vrts.verify(TURN, scene=SCENE, collisions=False)),
        "collisions were not checked, so there is nothing to prove",
    ),
]


@pytest.mark.parametrize(("call", "said"), [c[1:] for c in CALLS], ids=[c[0] for c in CALLS])
def test_wrong_input_is_told(call: Callable[[Path], object], said: str, tmp_path: Path) -> None:
    with pytest.raises(vrts.VrtsError) as problem:
        call(tmp_path)
    assert said in str(problem.value)


def test_a_scene_with_errors_says_where(tmp_path: Path) -> None:
    text = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
    place = tmp_path / "scene.toml"
    place.write_text(text.replace("radius_mm", "radius_m"))
    with pytest.raises(vrts.VrtsError, match=r"unknown key `radius_m`") as problem:
        vrts.scene(place)
    assert set(problem.value.codes) == {"V602"}
    assert "did you mean `radius_mm`?" in str(problem.value)


def test_what_was_read_keeps_its_lab() -> None:
    scene = vrts.scene("cans-on-bases")
    with pytest.raises(vrts.VrtsError, match=r"give `lab` and `controller` to `vrts.scene`"):
        vrts.run(TURN, scene=scene, lab="lab.toml")


def test_another_scene_than_that_of_the_task_is_no_matter_of_what_was_read() -> None:
    scene, task = vrts.scene("one-can-ur5"), vrts.task(TASK)
    under = vrts.scene(SCENE, controller="vplus")
    calls: list[Callable[[], object]] = [
        lambda: vrts.verify(TURN, scene=scene, task=TASK),
        lambda: vrts.verify(TURN, scene="one-can-ur5", task=task),
        lambda: vrts.run(TURN, scene=scene, task=task),
        lambda: vrts.prove(TURN, scene=scene, task=TASK),
        lambda: vrts.verify(TURN, scene=under, task=task),
    ]
    for call in calls:
        with pytest.raises(vrts.VrtsError, match="`scene` is not the scene of the task") as problem:
            call()
        assert "which is `cans-on-bases`\nhelp: leave out `scene`, or" in str(problem.value)
    with pytest.raises(vrts.VrtsError, match="there is no scene `moon`"):
        vrts.verify(TURN, scene="moon", task=task)


@pytest.mark.parametrize("name", ["scene", "task", "scenario"])
def test_an_assessment_is_asked_where_it_ran(name: str) -> None:
    found = vrts.verify(TURN, scene=SCENE)
    for ask in (anything.why, anything.certificate):
        with pytest.raises(vrts.VrtsError, match="an assessment has its own") as problem:
            ask(found, **{name: SCENE})
        assert str(problem.value).endswith(f"help: leave out `{name}`")


def test_a_saved_run_takes_nothing_from_outside(tmp_path: Path) -> None:
    place = vrts.run(TURN).save(tmp_path / "run.vrun")
    given: dict[str, object] = dict.fromkeys(
        ("scene", "task", "scenario", "lab", "controller", "entry", "dialect"), "turn"
    )
    for name, value in (given | {"files": ("turn.v2",)}).items():
        with pytest.raises(vrts.VrtsError, match="a saved run has its own") as problem:
            anything.run(place, **{name: value})
        assert str(problem.value).endswith(f"help: leave out `{name}`")
    with pytest.raises(vrts.VrtsError, match="leave out `scenario`, `entry`"):
        vrts.run(place, entry="turn", scenario="none.toml")


def test_damaged_runs_are_told(tmp_path: Path) -> None:
    place = vrts.run(TURN).save(tmp_path / "run.vrun")
    place.write_bytes(place.read_bytes()[:-40])
    with pytest.raises(vrts.VrtsError) as problem:
        vrts.run(place)
    assert problem.value.codes
