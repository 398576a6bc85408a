"""`vrts dispatch plan`: what is refused, and what stands in the bundle of what is not."""

import os
import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import MappingProxyType

import pytest
from click.testing import CliRunner, Result

from vrts.cli.main import vrts
from vrts.dispatch.bundle import Bundle, digest_of, read_bundle, rows
from vrts.dispatch.planning.plan import Plan, plan
from vrts.dispatch.planning.reasons.futures import USUAL
from vrts.dispatch.planning.reasons.refusals import Promise, finding_of
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile import Profile, find_profile
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.request import Request
from vrts.pipeline.requesting import request_for
from vrts.pipeline.scenes import load_scene, with_scenario
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.pipeline.where import Where
from vrts.prove.environment.environment import Answers, Environment, Held
from vrts.report.first_screen import first_screen

CANS = CHECKOUT / "examples" / "01-cans-on-bases"
SAFE = ".LOCATIONS\nsafe 900 30 100 90 90 0\n.END\n"


def profile(**other: object) -> Profile:
    return find_profile("mark2-val2")._replace(**other)  # type: ignore[arg-type]


def planned(
    text: str,
    *settings: Setting,
    promises: Sequence[Promise] = (),
    clearance_mm: float = 10.0,
    target: Profile | None = None,
    environment: Environment = USUAL,
) -> Plan:
    """Plan a program in a scene with two cans, or in given settings."""
    first, *further = settings or (load_scene("cans-on-bases"),)
    controller = target or profile()
    request = Request(ProgramFile(text.encode(), "x.v2"), first, Reading("val2+"))
    wish = Wish(request, controller, clearance_mm, tuple(promises), tuple(further), environment)
    return plan(wish)


def codes(found: Plan) -> list[str]:
    return sorted({d.rule.code for d in found.refused})


def main(*steps: str, data: str = SAFE) -> str:
    body = "".join(f"        {step}\n" for step in steps)
    return f".PROGRAM main()\n{body}.END\n{data}"


def scenario(home: Path, name: str, text: str) -> Setting:
    path = home / f"{name}.toml"
    path.write_text(f'title = "{name}"\n{text}', "utf-8")
    return with_scenario(load_scene("cans-on-bases"), path)


@pytest.fixture(scope="module")
def cans() -> Bundle:
    """Return the bundle of the reference solution."""
    data = (CANS / "solution.v2").read_bytes()
    found = plan(Wish(Request(ProgramFile(data, "a/b/solution.v2"), load_task(CANS)), profile()))
    assert found.bundle is not None, found.refused
    return found.bundle


# --- the bundle -----------------------------------------------------------------------------------


@pytest.mark.thorough
def test_the_solution_of_an_example_is_planned(cans: Bundle) -> None:
    manifest = cans.manifest
    assert list(cans.programs) == ["carry", "main"]
    assert manifest.entry == "main"
    assert manifest.title == "solution.v2", "no folder of whoever planned it"
    assert manifest.program.sha256 == digest_of((CANS / "solution.v2").read_bytes())
    assert manifest.scene.sha256 == load_task(CANS).scene.digest
    (only,) = manifest.scenarios
    assert only.ending == "completed"
    assert only.mark == 10.0
    assert only.clearance_mm == 10.0
    assert {v.answer for v in only.verdicts} == {"holds"}
    assert all(e.executed == e.steps and not e.not_executed for e in manifest.executed)
    assert manifest.waivers == ()
    assert dict(rows(cans.locations))["base1_put"] == "950.00 -130.00 -75.00 90.000 90.000 0.000"


def test_margins_hold(cans: Bundle) -> None:
    margins = [m for m in cans.manifest.margins if not m.name.startswith("stopped")]
    assert {m.answer for m in margins} == {"holds"}
    assert ", 10 mm needed" in margins[0].sentence, "cans are carried: twice 3 mm and 2 mm"
    names = {m.name for m in margins}
    assert {"objects ±3 mm", "base ±2 mm", "other corners", "at SPEED 10"} <= names
    assert cans.manifest.first_to_fail.startswith("not looked at")
    assert "Fails first" not in cans.sheet


def test_the_sheet_says_what_an_operator_needs(cans: Bundle) -> None:
    sheet = cans.sheet
    for words in (
        "EXECUTE main",
        "takes <code>can1</code>",
        "JT 0.0  -90.0  90.0  0.0",
        "BASE ,,-100",
        "SPEED 10",
        "hand on the stop",
        "not tried on hardware",
        "-450.0",
        "0, 0, 150, 90, -90, 0",
    ):
        assert words in sheet, words
    assert "<script" not in sheet
    assert "http" not in sheet.replace("http-equiv", "")


def test_a_second_run_would_begin_with_other_data(cans: Bundle) -> None:
    assert "send the data again" not in cans.sheet
    found = planned(main("n = n+1", "READY", data=".REALS\nn 1\n.END\n"))
    assert found.bundle is not None
    assert "changes <code>n</code>" in found.bundle.sheet
    assert "DO n = 1" in found.bundle.sheet


# --- refusals -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["hits-base", "releases-in-air"])
def test_a_plan_and_a_mark_agree_about_ready(name: str) -> None:
    program = CANS / "submissions" / f"{name}.v2"
    ready = first_screen(assess(request_for(program, Where(task=CANS)))).ready
    found = plan(Wish(Request(ProgramFile(program.read_bytes(), name), load_task(CANS)), profile()))
    unproven = {"V801", "V802"} & set(codes(found))
    assert ready is not bool(unproven), codes(found)


@pytest.mark.parametrize(
    ("text", "other", "code"),
    [
        (main("OPENI ; öffnen"), {}, "V803"),
        (main(f'TYPE "{"x" * 90}"'), {}, "V804"),
        (main("a_long_name_of_19ch = 1", "READY"), {}, "V805"),
        (main("abcdefgh = 1", "READY"), {"name_length": 6}, "V805"),
        (main("READY"), {"memory_bytes": 60}, "V806"),
        (main("DRAW 0, 0, 10"), {"lacks": ("DRAW",)}, "V807"),
        (main("READY"), {"dialect": "vplus"}, "V808"),
        (main("LMOVE safe"), {}, "V808"),
        (main("MOVE nowhere"), {}, "V801"),
        (main("MOVE safe", "MOVES SHIFT(safe BY 0, 0, -400)"), {}, "V801"),
    ],
)
def test_what_the_controller_or_the_world_does_not_take_is_refused(
    text: str, other: dict[str, object], code: str
) -> None:
    found = planned(text, target=profile(**other))
    assert found.bundle is None
    assert code in codes(found)


@pytest.mark.parametrize(
    ("steps", "words"),
    [
        (("MOVE safe ; MOVES safe", "READY"), "what stands behind `;` is a remark"),
        (("OPENI", "MOVE safe", "CLOSEI", "READY"), "the hand closes on nothing"),
    ],
)
def test_what_makes_a_careful_operator_stop_is_refused(steps: tuple[str, ...], words: str) -> None:
    found = planned(main(*steps))
    assert codes(found) == ["V801"]
    assert words in found.refused[0].headline


def test_a_long_comment_moves_nearer_to_its_step() -> None:
    found = planned(main("READY" + " " * 90 + "; up"))
    assert found.bundle is not None
    assert "READY  ; up\n" in found.bundle.programs["main"]


def test_locations_are_verified_as_the_controller_prints_them() -> None:
    data = ".LOCATIONS\na 900 30 100.004 90 90 0\nb 900 30 100.001 90 90 0\n.END\n"
    found = planned(main("MOVE a", "MOVE b", data=data))
    assert codes(found) == ["V809"]
    assert "differ, and are the same" in found.refused[0].headline


@pytest.mark.thorough
def test_what_holds_only_with_the_decimals_of_the_file_is_refused() -> None:
    """Fingers on the table: two rounded locations, one from the other, press them into it."""
    data = ".LOCATIONS\nf 900 30 -142.55 90 -90 0\ng 0 0 -142.55 90 90 0\n.END\n"
    text = main("APPRO f:g, 100", "MOVES f:g", "BREAK", "DEPARTS 100", data=data)
    found = planned(text, target=profile(length_decimals=0))
    said = [d.headline for d in found.refused if d.rule.code == "V809"]
    assert said, codes(found)
    assert "as the controller prints them" in said[0]
    assert "V809" not in codes(planned(text))


@pytest.mark.thorough
def test_a_clearance_that_is_too_small_is_refused_where_it_is() -> None:
    low = main("MOVE safe", "MOVES SHIFT(safe BY 0, 0, -380)", "BREAK", "DEPARTS 200")
    found = planned(low)
    assert codes(found) == ["V812"]
    assert "10 mm are asked for" in found.refused[0].headline
    assert planned(low, clearance_mm=3.0).bundle is not None


@pytest.mark.thorough
def test_a_program_that_only_works_in_the_scene_as_it_is_has_no_margin() -> None:
    """The can is grasped 9 mm beside the middle of the pads, along them: 3 mm more lose it."""
    text = (CANS / "solution.v2").read_text("utf-8")
    beside = text.replace(" 800.00  -450.00", " 809.40  -450.00")
    assert beside != text
    found = plan(Wish(Request(ProgramFile(beside.encode(), "x"), load_task(CANS)), profile()))
    assert codes(found) == ["V813"], [d.headline for d in found.refused]
    assert "`can1` 3 mm along" in found.refused[0].headline


# --- what scenarios cover -------------------------------------------------------------------------

DECIDES = main("IF SIG(1001) THEN", "MOVE safe", "END", "READY")


DOWN = ("MOVE SHIFT(safe BY 0, 0, -480)", "BREAK")  # into the table
FAILS = main("READY", "IF SIG(1001) THEN", *DOWN, "END", "READY")


@cache
def failing() -> Plan:
    """Return what speaks against a program that goes wrong in some future."""
    return planned(FAILS)


@pytest.mark.thorough
def test_both_ways_of_an_input_are_looked_at_without_a_scenario() -> None:
    found = planned(DECIDES)
    assert found.bundle is not None, found.refused
    (proof,) = found.bundle.manifest.futures
    assert proof.answer == "holds"
    assert any("input 1001" in words for words in proof.quantified)
    assert "Every future: holds" in found.bundle.sheet
    assert "input 1001: on or off" in found.bundle.sheet


@pytest.mark.thorough
def test_what_goes_wrong_in_some_future_is_refused_with_what_came_from_outside() -> None:
    found = failing()
    assert codes(found) == ["V815"]
    one = found.refused[0]
    assert one.primary is not None
    assert any("input 1001 is on" in note for note in one.notes)


@pytest.mark.thorough
def test_an_environment_says_what_cannot_come() -> None:
    off = MappingProxyType({1001: Held(on=False)})
    never = Environment(title="the guard is shut", inputs=off, digest="0" * 64)
    found = planned(FAILS, environment=never)
    assert codes(found) == ["V810"], "a motion that nothing executes"
    assert planned(DECIDES, environment=never).refused != ()


@pytest.mark.thorough
def test_what_was_executed_before_may_be_executed_again() -> None:
    text = main(
        *("IF NOT DEFINED(n) THEN", "n = 0", "END", "n = n+1"),
        *("IF n == 4 THEN", *DOWN, "END", "READY"),
    )
    found = planned(text)
    one = next(d for d in found.refused if d.rule.code == "V815")
    assert sum("executed again" in note for note in one.notes) == 3


@pytest.mark.thorough
def test_what_nobody_says_of_answers_is_refused(tmp_path: Path) -> None:
    one = scenario(tmp_path, "one", '[prompts]\nanswers = ["1"]\n')
    found = planned(main('PROMPT "how far? ", x', "DRIVE 1, x, 50", "READY"), one)
    assert codes(found) == ["V811", "V816"]
    answers = Answers(("1", "2"))
    told = Environment(title="one or two", answers=answers, digest="0" * 64)
    assert (
        planned(main('PROMPT "?", x', "DRIVE 1, x, 50"), one, environment=told).bundle is not None
    )


def test_answers_that_a_program_tells_apart_itself_need_no_environment(tmp_path: Path) -> None:
    one = scenario(tmp_path, "one", '[prompts]\nanswers = ["y"]\n')
    asks = main('PROMPT "go? ", $a', 'IF $a == "y" THEN', "READY", "END", "READY")
    found = planned(asks, one)
    assert found.bundle is not None, codes(found)
    (proof,) = found.bundle.manifest.futures
    assert 'answers to PROMPT at step 1 of `main`: every text, told apart by "y"' in (
        proof.quantified
    )


@pytest.mark.thorough
def test_an_analog_input_that_only_decides_needs_no_scenario() -> None:
    decides = main("IF ADC(1) > 500 THEN", "READY", "END", "READY")
    found = planned(decides)
    assert found.bundle is not None, codes(found)
    (proof,) = found.bundle.manifest.futures
    assert any(one.startswith("analog input 1: every count") for one in proof.quantified)
    assert codes(planned(main("x = ADC(1)/100", "DRIVE 1, x, 50", "READY"))) == ["V811"]


@pytest.mark.thorough
def test_what_the_environment_says_is_typed_where_no_scenario_says_anything() -> None:
    asks = main('PROMPT "how far? ", x', "DRIVE 1, x, 50", 'PROMPT "and? ", x, y', "READY")
    told = Environment(title="1 to 2", answers=Answers(least=1, most=2, whole=True))
    bundle = planned(asks, environment=told).bundle
    assert bundle is not None
    (one,) = bundle.manifest.scenarios
    assert one.ending == "completed"


def test_a_motion_that_no_future_executes_is_refused() -> None:
    found = planned(main("GOTO 10", "MOVE safe", "10 READY"))
    assert codes(found) == ["V810"]


@pytest.mark.thorough
def test_scenarios_add_up(tmp_path: Path) -> None:
    on = scenario(tmp_path, "on", "[[inputs]]\nsignal = 1001\non_s = [0.0]\n")
    off = scenario(tmp_path, "off", "")
    both = planned(DECIDES, on, off)
    assert both.bundle is not None, both.refused
    manifest = both.bundle.manifest
    assert [s.scenario for s in manifest.scenarios] == ["on", "off"]
    assert manifest.reads.inputs == ("input 1001",)


@pytest.mark.parametrize(
    ("steps", "what"),
    [
        (("MOVE SHIFT(safe BY RANDOM, 0, 0)",), "RANDOM"),
        (("CALL go(RANDOM)", "READY"), "RANDOM"),
        (("IF DEFINED(part) THEN", "n = 1", "END", "READY"), "whether `part` has a value"),
        (("OPENI", "GRASP 10, 10", "n = 1", "10 READY"), "hand"),
    ],
)
def test_a_path_that_depends_on_what_was_not_tried_is_refused(
    steps: tuple[str, ...], what: str
) -> None:
    more = ".PROGRAM go(x)\n        IF x == 0 THEN\n        SPEED 20\n        END\n.END\n"
    more += ".PROGRAM halted()\n        HALT\n.END\n"
    found = planned(main(*steps, data=more + SAFE))
    said = [d.headline for d in found.refused if d.rule.code == "V811"]
    assert said, codes(found)
    assert what in said[0]


@pytest.mark.thorough
@pytest.mark.parametrize(
    "steps",
    [
        pytest.param(
            ("TIMER 1 = 0", "n = TIMER(1)", "IF n > 100 GOTO 10", "READY", "10 n = 0"),
            marks=pytest.mark.thorough,
        ),
        ("x = SIG(1002)", "SPEED 50+x ALWAYS", "READY"),
        ("CALL go(SIG(1003))", "READY"),
        ("REACT 1004, halted", "READY"),
        ("IF SIG(1001) THEN", "SIGNAL 1", 'TYPE "on"', "END", "READY"),
    ],
)
def test_what_futures_try_in_every_way_is_no_reason_to_refuse(steps: tuple[str, ...]) -> None:
    more = ".PROGRAM go(x)\n        IF x == 0 THEN\n        SPEED 20\n        END\n.END\n"
    more += ".PROGRAM halted()\n        HALT\n.END\n"
    found = planned(main(*steps, data=more + SAFE))
    assert found.bundle is not None, [d.headline for d in found.refused]


@pytest.mark.thorough
def test_waiting_for_an_input_is_no_decision(tmp_path: Path) -> None:
    comes = scenario(tmp_path, "comes", "[[inputs]]\nsignal = 1001\non_s = [0.5]\n")
    found = planned(main("MOVE safe", "WAIT SIG(1001)", "READY"), comes)
    assert found.bundle is not None, found.refused
    assert found.bundle.manifest.reads.inputs == ("input 1001",)
    said = {margin.name: margin.sentence for margin in found.bundle.manifest.margins}
    assert said["objects ±3 mm"] == "there is nothing to try"  # the hand takes nothing
    assert said["base ±2 mm"] == "holds in all of 4 cases"


# --- waivers --------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_a_waiver_stands_in_manifest_and_sheet_and_an_idle_one_does_not() -> None:
    refused = failing().refused
    names = [finding_of(one) for one in refused]
    for name, one in zip(names, refused, strict=True):
        assert any(f"--waive {name} " in words for words in one.help), "it says how to answer"
    why = [Promise(name, "the guard <b>is</b> shut", "R. Huber") for name in names]
    found = planned(FAILS, promises=(*why, Promise("V812-123456", "x", "y")))
    assert found.bundle is not None
    assert found.idle == ("V812-123456",)
    waivers = found.bundle.manifest.waivers
    assert {f"{w.code}-{w.finding}" for w in waivers} == set(names)
    assert {(w.who, *w.refused) for w in waivers} == {("R. Huber", d.headline) for d in refused}
    sheet = found.bundle.sheet
    assert "NOT ALL PROVEN" in sheet
    assert all(name in sheet for name in names)
    assert "the guard &lt;b&gt;is&lt;/b&gt; shut" in sheet


DEEPER = ("MOVE SHIFT(safe BY 0, 0, -500)", "BREAK")


@pytest.mark.thorough
@pytest.mark.parametrize(
    "other",
    [
        main("READY", "IF SIG(1001) THEN", *DEEPER, "END", "READY"),  # another step
        *(
            pytest.param(main("READY", *steps, *DOWN, "END", "READY"), marks=pytest.mark.thorough)
            for steps in (
                ("OPENI", "IF SIG(1001) THEN"),  # another place
                ("IF SIG(1001) THEN", "SPEED 50"),
            )
        ),
    ],
)
def test_a_waiver_covers_one_finding_at_one_place(other: str) -> None:
    names = [finding_of(one) for one in failing().refused]
    promises = [Promise(name, "measured", "R. Huber") for name in names]
    found = planned(other, promises=promises)
    assert codes(found) == ["V815"]
    assert found.idle == tuple(sorted(names))


@pytest.mark.thorough
def test_of_two_findings_of_one_kind_one_is_waived_alone() -> None:
    first, second = failing().refused
    promise = Promise(finding_of(first), "measured", "R. Huber")
    left = planned(FAILS, promises=(promise,))
    assert left.bundle is None
    assert [d.headline for d in left.refused] == [second.headline]
    assert [d.headline for d in left.waived] == [first.headline]


def test_what_leaves_nothing_to_send_cannot_be_waived(tmp_path: Path) -> None:
    (tmp_path / "x.v2").write_text(main("OPENI ; ö"), "utf-8")
    found = call(tmp_path, "--waive", "V803-123456", "--reason", "no", "--who", "me")
    assert found.exit_code == 1
    assert "V814" in found.output
    assert call(tmp_path, "--waive", "V812-123456", "--who", "me").exit_code == 1


def test_a_code_alone_says_not_which_finding(tmp_path: Path) -> None:
    (tmp_path / "x.v2").write_text(FAILS, "utf-8")
    found = call(tmp_path, "--waive", "V815", "--reason", "no", "--who", "me")
    assert found.exit_code == 1
    assert "V814" in found.output
    assert "for one at one place" in found.output


# --- other worlds ---------------------------------------------------------------------------------


@pytest.mark.thorough
def test_a_target_that_only_a_rounded_corner_avoids_has_no_margin() -> None:
    """The target of the corner is some mm below the table's top: rounded, the arm stays above."""
    data = ".LOCATIONS\nfrom 700 -60 0 90 90 0\nlow 700 150 -295 90 90 0\n"
    data += "to 700 360 0 90 90 0\n.END\n"
    found = planned(main("MOVE from", "MOVES low", "MOVES to", "READY", data=data), clearance_mm=1)
    (only,) = found.refused
    assert only.rule.code == "V813"
    assert only.headline.startswith("with no corner rounded: ")
    assert "hits `table`" in only.headline


@pytest.mark.thorough
def test_what_may_be_typed_after_a_stop_stands_on_the_sheet(cans: Bundle) -> None:
    answers = {m.name: m for m in cans.manifest.margins if m.name.startswith("stopped")}
    assert set(answers) == {"stopped in any tick, then PROCEED", "stopped in any tick, then RETRY"}
    proceed = answers["stopped in any tick, then PROCEED"]
    assert proceed.answer == "violated", "it would go down beside the can"
    assert "stopped at step" in proceed.sentence
    assert "After a stop never <code>PROCEED</code>: stopped at step" in cans.sheet
    still = planned(main("MOVE safe", "READY")).bundle
    assert still is not None
    assert "After a stop: <code>PROCEED</code> or <code>RETRY</code> may be typed" in still.sheet


@pytest.mark.thorough
def test_which_margin_fails_first_is_told_where_it_is_asked_for() -> None:
    data = (CANS / "solution.v2").read_bytes()
    request = Request(ProgramFile(data, "solution.v2"), load_task(CANS))
    found = plan(Wish(request, profile(), fails_first=True))
    assert found.bundle is not None
    assert "3 times" in found.bundle.manifest.first_to_fail
    assert "finger hits `can1`" in found.bundle.manifest.first_to_fail
    assert "Fails first" in found.bundle.sheet


@pytest.mark.thorough
def test_several_processes_write_the_same_bundle(tmp_path: Path) -> None:
    """In processes of their own, without other threads: there children are forks."""
    (tmp_path / "x.v2").write_text(main("MOVE safe", "OPENI", "READY"), "utf-8")
    written: list[bytes] = []
    for jobs in ("1", "2"):
        target = tmp_path / f"{jobs}.bundle"
        words = ["dispatch", "plan", "x.v2", "--scene", "cans-on-bases", "--profile", "mark2-val2"]
        command = [sys.executable, "-m", "vrts.cli.main", *words, "-o", target.name, "--jobs", jobs]
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
        written.append(target.read_bytes())
    assert written[0] == written[1]


# --- command line ---------------------------------------------------------------------------------


def call(home: Path, *words: str) -> Result:
    target = str(home / "x.bundle")
    options = ["--scene", "cans-on-bases", "--profile", "mark2-val2", "-o", target]
    return CliRunner().invoke(vrts, ["dispatch", "plan", str(home / "x.v2"), *options, *words])


@pytest.mark.thorough
def test_a_bundle_is_written_and_a_refused_one_is_not(tmp_path: Path) -> None:
    (tmp_path / "x.v2").write_text(main("MOVE safe", "READY"), "utf-8")
    page = tmp_path / "sheet.html"
    done = call(tmp_path, "--sheet", str(page))
    assert done.exit_code == 0, done.output
    bundle = read_bundle((tmp_path / "x.bundle").read_bytes())
    assert page.read_text("utf-8") == bundle.sheet
    (tmp_path / "x.bundle").unlink()
    (tmp_path / "x.v2").write_text(main("MOVE nowhere"), "utf-8")
    refused = call(tmp_path)
    assert refused.exit_code == 1
    assert "refused: no bundle was written" in refused.output
    assert not (tmp_path / "x.bundle").exists()
    (tmp_path / "x.v2").write_text(".PROGRAM main()\n  MVOE x\n.END\n", "utf-8")
    assert call(tmp_path).exit_code == 1


@pytest.mark.thorough
def test_two_processes_write_the_same_bytes(tmp_path: Path) -> None:
    (tmp_path / "x.v2").write_text(main("MOVE safe", "n = 2", "READY"), "utf-8")
    found: set[bytes] = set()
    for seed in ("0", "1"):
        target = tmp_path / f"{seed}.bundle"
        words = ["--scene", "cans-on-bases", "--profile", "mark2-val2", "-o", str(target)]
        subprocess.run(
            [
                sys.executable,
                "-m",
                "vrts.cli.main",
                "dispatch",
                "plan",
                str(tmp_path / "x.v2"),
                *words,
            ],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
            capture_output=True,
            timeout=300,
        )
        found.add(target.read_bytes())
    assert len(found) == 1
