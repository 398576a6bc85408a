"""Saved runs answer what they answered before; damaged ones say so, in one diagnostic."""

import io
import json
import struct
import zipfile
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vrts.engine.storage.container as container
from tests.laws import first
from tests.support_programs import program
from tests.support_saved import (
    answers,
    ask_everything,
    busy,
    carrying,
    file_of,
    loaded,
    members,
    packed,
    plain,
    state_answers,
    with_manifest,
    with_table,
)
from vrts.base.diagnostic import Diagnostic
from vrts.engine.controller import Controller, advance, truncate
from vrts.engine.memory.records import Ending
from vrts.engine.storage.recognise import is_saved_run
from vrts.engine.storage.save import run_bytes
from vrts.ir.commands import Abort, Execute, Load, TimedCommand
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import scene_names
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.run_files.loading import check_again, executed_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate

RUNS = (busy, carrying)


def refusal(data: bytes) -> Diagnostic:
    """Return the one diagnostic of a file that is not taken."""
    with pytest.raises(Refused) as refused:
        ask_everything(loaded(data))
    assert len(refused.value.diagnostics) == 1
    return refused.value.diagnostics[0]


def simulated(body: str) -> Simulated:
    """Return the run of a program of these lines."""
    found = simulate(Request(ProgramFile(program(body).encode(), "main.v2"), robot_alone()))
    assert found.run is not None, found.diagnostics
    return found


# --- what is kept ---------------------------------------------------------------------------------


@pytest.mark.parametrize("which", RUNS)
def test_a_loaded_run_answers_everything_as_before(which: Callable[[], Simulated]) -> None:
    before = which().run
    assert before is not None
    after = loaded(file_of(which))
    assert answers(after) == answers(before)
    for k in range(41):
        time_s = min(before.horizon_s * k / 40, before.horizon_s)
        assert state_answers(after.at(time_s)) == state_answers(before.at(time_s))
    for finished in range(before.statements + 1):
        assert state_answers(after.at_statement(finished)) == state_answers(
            before.at_statement(finished)
        )


@pytest.mark.parametrize("count", [22, 300])
def test_motions_that_take_no_time_are_kept(count: int) -> None:
    """Their times are sums of ticks, of which some are a last digit beside the others."""
    found = simulated(f"FOR i = 1 TO {count}\nREADY\nEND")
    assert found.run is not None
    assert len(found.run.motions) == count
    for motion, following in pairwise(found.run.motions):
        assert motion.start_s <= motion.end_s <= following.start_s
    assert answers(loaded(saved_bytes(found))) == answers(found.run)


def test_a_line_that_a_fault_stops_is_kept_as_such() -> None:
    found = simulated("MOVE a\nBREAK\nMOVES TRANS(300,100,900,90,90,0)")
    assert found.run is not None
    for run in (found.run, loaded(saved_bytes(found))):
        assert [(motion.arrives, motion.cut) for motion in run.motions] == [
            (True, False),
            (False, False),
        ]


def test_a_run_that_was_cut_while_a_second_program_waits_is_kept() -> None:
    """The second program begins after the cut, and remembers nothing of what came after it."""
    found = simulate(
        Request(
            ProgramFile(
                program("READY\nDELAY 6\nn = 1\nDELAY 1\nPCEXECUTE watch\nDELAY 6").encode()
                + b".PROGRAM watch\n.END\n",
                "main.v2",
            ),
            robot_alone(),
        )
    )
    run = found.run
    assert run is not None
    for k in range(1, 20):
        time_s = run.horizon_s * k / 20
        cut = truncate(run, time_s)
        file = saved_bytes(found._replace(run=cut))
        assert answers(loaded(file)) == answers(cut)
        on = advance(cut, run.until_s, closed=True)
        assert answers(on) == answers(run)
        assert answers(loaded(saved_bytes(found._replace(run=on)))) == answers(run)


def test_files_whose_times_miss_each_other_by_a_last_digit_are_taken() -> None:
    """As earlier versions of vrts saved them."""
    data = saved_bytes(simulated("ENABLE DRY.RUN\nREADY\nREADY\nMOVE a\nREADY"))

    def nudged(table: Any) -> Any:
        table[0, :2] = np.nextafter(table[0, :2], 1e9)
        return table

    again = loaded(with_table(data, "motions.numbers", nudged))
    assert again.motions[0].start_s > again.motions[1].start_s


def test_what_is_compared_above_is_something() -> None:
    run = busy().run
    assert run is not None
    assert [found.rule.code for found in run.findings] == ["V250"]
    state = run.at(run.horizon_s)
    assert {"a", "spot[1]", "$t[2]", "m[4,2]", "#up"} <= state.variables.keys()
    assert state.parameters == {"HAND.TIME": pytest.approx(0.1)}
    assert state.X_FT != run.scene.X_FT
    assert state.process is not None
    assert run.history.arm.scale.rate == 0.6
    inside = [run.at_statement(k) for k in range(run.statements)]
    assert any(len(state.call_stack) == 2 and "old" in state.locals for state in inside)


@pytest.mark.parametrize("which", RUNS)
def test_the_same_run_gives_the_same_bytes(which: Callable[[], Simulated]) -> None:
    data = file_of(which)
    assert saved_bytes(load_run(data, "out.vrun")) == data


def test_a_file_is_json_and_arrays_that_numpy_reads_without_pickle() -> None:
    with np.load(io.BytesIO(file_of(busy)), allow_pickle=False) as arrays:
        assert json.loads(arrays["vrun.json"])["format"] == "vrts.run/3"
        for name in arrays.files:
            if name != "vrun.json":
                assert arrays[name].dtype.kind in "uif"


def test_a_saved_run_is_known_by_its_content() -> None:
    assert is_saved_run(file_of(busy))
    assert is_saved_run(file_of(busy)[:60])
    assert not is_saved_run(b"PK\x03\x04 a zip of something else")
    assert not is_saved_run(b".PROGRAM main\n.END\n")


def test_a_loaded_run_can_be_asked_but_not_advanced() -> None:
    run = loaded(file_of(busy))
    with pytest.raises(ValueError, match="asked, not advanced"):
        advance(run, run.until_s + 1.0)
    with pytest.raises(ValueError, match="asked, not advanced"):
        truncate(run, 1.0)


@pytest.mark.parametrize("which", RUNS)
def test_executed_again_it_is_the_same(which: Callable[[], Simulated]) -> None:
    assert check_again(load_run(file_of(which), "out.vrun")) is None


def test_a_fork_of_a_saved_run_begins_with_executing_it_again() -> None:
    before = busy().run
    assert before is not None
    again = executed_again(load_run(file_of(busy), "out.vrun"))
    assert answers(again) == answers(before)
    fork = advance(truncate(again, 3.0), 20.0, [TimedCommand(3.0, Abort())], closed=True)
    assert fork.ending is Ending.ABORTED
    assert plain(fork.at(2.9).call_stack) == plain(before.at(2.9).call_stack)


@pytest.mark.parametrize("name", first(3, scene_names()))
def test_every_scene_of_the_library_comes_back(name: str) -> None:
    found = simulate(
        Request(ProgramFile(b".PROGRAM a\nDELAY 0.1\n.END\n", "a.v2"), load_scene(name))
    )
    scene = loaded(saved_bytes(found)).scene
    assert (scene.name, scene.digest) == (name, load_scene(name).scene.digest)
    assert [body.name for body in scene.bodies] == [b.name for b in load_scene(name).scene.bodies]


def test_only_what_belongs_to_the_run_is_saved() -> None:
    """Runs share tables with longer ones: what came later is not in the file."""
    setting = robot_alone()
    text = program("FOR i = 1 TO 500\nn = i\nDELAY 0.1\nEND").encode()
    whole = simulate(Request(ProgramFile(text, "main.v2"), setting))
    assert whole.run is not None
    short = truncate(whole.run, 5.0)
    advance(short, 20.0)
    before = len(saved_bytes(whole))
    after = saved_bytes(whole._replace(run=short))
    assert len(after) < before
    read = loaded(after)
    assert answers(read) == answers(short)
    assert state_answers(read.at(5.0)) == state_answers(short.at(5.0))


def test_a_scene_is_kept_with_its_text(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    folder.mkdir()
    text = (Path(load_scene("cans-on-bases").scene_source.name)).read_text("utf-8")  # type: ignore[union-attr]
    (folder / "scene.toml").write_text(text, "utf-8")
    found = simulate(
        Request(ProgramFile(b".PROGRAM a\nMOVE safe\n.END\n", "a.v2"), load_scene(str(folder)))
    )
    data = saved_bytes(found)
    (folder / "scene.toml").unlink()
    scene = loaded(data).scene
    assert scene.name == "mine"
    assert scene.digest == load_scene("cans-on-bases").scene.digest


# --- what is not saved ----------------------------------------------------------------------------


def test_a_run_whose_programs_changed_on_the_way_is_not_saved() -> None:
    origin, run = busy().origin, busy().run
    assert origin is not None
    assert run is not None
    controller = Controller(run.module, run.scene)
    controller.issue(Execute("main"), 0.0)
    controller.issue(Load(run.module), 0.0)
    found = run_bytes(controller.advance(1.0), origin)
    assert isinstance(found, Diagnostic)
    assert found.rule.code == "V545"
    assert found.headline == (
        "the run cannot be saved: the programs in memory were changed on the way"
    )


def test_a_run_that_would_not_be_read_again_is_not_saved(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(container, "MOST_MANIFEST", 1000)
    with pytest.raises(Refused) as refused:
        saved_bytes(busy())
    assert refused.value.diagnostics[0].rule.code == "V545"
    assert "too large" in refused.value.diagnostics[0].headline


# --- damage ---------------------------------------------------------------------------------------

DATA = file_of(carrying)


def test_a_truncated_file_is_damaged() -> None:
    for length in (40, 100, 1000, len(DATA) // 2, len(DATA) - 1):
        found = refusal(DATA[:length])
        assert found.rule.code == "V540"
        assert found.headline.startswith("the saved run `out.vrun` is damaged: it is incomplete")


def test_members_are_those_that_belong_there() -> None:
    parts = members(DATA)
    found = refusal(packed({name: part for name, part in parts.items() if name != "ticks.npy"}))
    assert found.headline.endswith("its member `ticks.npy` is missing")
    for name in ("../evil.npy", "/etc/passwd", "strange.npy"):
        found = refusal(packed(parts | {name: b""}))
        assert found.headline.endswith(f"it has a member `{name}` that does not belong there")
    buffer = io.BytesIO(DATA)
    with zipfile.ZipFile(buffer, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("ticks.npy", parts["ticks.npy"])
    assert refusal(buffer.getvalue()).headline.endswith("a member is there twice")


def stated(data: bytes, name: str, size: int) -> bytes:
    """Return a file that states another unpacked size of a member."""
    entry = data.rindex(name.encode()) - 46  # of the central directory
    assert data[entry : entry + 4] == b"PK\x01\x02"
    return data[: entry + 24] + struct.pack("<I", size) + data[entry + 28 :]


def test_sizes_are_looked_at_before_anything_is_unpacked() -> None:
    found = refusal(stated(DATA, "ticks.npy", 300_000_000))
    assert found.rule.code == "V541"
    assert "bytes unpacked, the limit is 256,000,000" in found.headline
    found = refusal(stated(DATA, "vrun.json", 33_000_000))
    assert found.rule.code == "V541"
    bomb = packed(members(DATA) | {"ticks.npy": bytes(50_000_000)})
    assert len(bomb) < 200_000
    found = refusal(stated(bomb, "ticks.npy", 200))
    assert found.rule.code == "V540"


def test_encrypted_members_are_not_taken() -> None:
    entry = DATA.rindex(b"ticks.npy") - 46
    flagged = DATA[: entry + 8] + b"\x01" + DATA[entry + 9 :]
    assert refusal(flagged).headline.endswith("it is packed in a way that saved runs are not")


def test_other_formats_are_named() -> None:
    found = refusal(with_manifest(DATA, lambda m: m.update(format="vrts.run/9", vrts="8.0")))
    assert found.rule.code == "V542"
    known = "this vrts reads `vrts.run/3` and `vrts.run/2`"
    assert found.notes == (f"it is `vrts.run/9` of vrts 8.0; {known}",)


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"\xff",
        b"[]",
        b"NaN",
        b'{"format": NaN}',
        b'{"format": ' + b"[" * 100_000,
        b'{"format": ' + b"9" * 10_000 + b"}",
    ],
)
def test_a_description_is_json(text: bytes) -> None:
    assert refusal(packed(members(DATA) | {"vrun.json": text})).rule.code in ("V540", "V542")


def test_programs_and_scene_have_to_be_the_same_again() -> None:
    def other_program(manifest: dict[str, Any]) -> None:
        source = manifest["origin"]["programs"]["sources"][0]
        source[1] = source[1].replace("SPEED 30", "SPEED 40")

    found = refusal(with_manifest(DATA, other_program))
    assert found.rule.code == "V543"
    assert found.headline.endswith("its programs compile to something else now")

    def other_scene(manifest: dict[str, Any]) -> None:
        manifest["origin"]["scene"]["text"] += "# changed\n"

    found = refusal(with_manifest(DATA, other_scene))
    assert found.rule.code == "V543"
    assert found.headline.endswith("files that its scene names are missing, or were changed")

    def no_program(manifest: dict[str, Any]) -> None:
        manifest["origin"]["programs"]["sources"][0][1] = "what is this"

    assert refusal(with_manifest(DATA, no_program)).rule.code == "V543"


def test_a_check_tells_the_first_difference() -> None:
    def later(manifest: dict[str, Any]) -> None:
        manifest["events"][4][1][0] += 0.5

    found = check_again(load_run(with_manifest(DATA, later), "out.vrun"))
    assert found is not None
    assert found.rule.code == "V544"

    def turned(manifest: dict[str, Any]) -> None:
        manifest["arm"]["configuration"][0] += 0.001

    found = check_again(load_run(with_manifest(DATA, turned), "out.vrun"))
    assert found is not None
    assert found.headline == (
        "executed again, the program does something else: the arm is elsewhere (at 0.000 s)"
    )


def put(row: Any, value: float) -> Callable[[Any], Any]:
    """Return a change of one number of an array."""

    def change(table: Any) -> Any:
        table[row] = value
        return table

    return change


TABLES: list[tuple[str, Callable[[Any], Any], str]] = [
    ("pieces.coefficients", put(3, np.nan), "infinite or none"),
    ("pieces.coefficients", put(3, np.inf), "infinite or none"),
    ("pieces.coefficients", put(3, 1e300), "too large"),
    ("pieces.coefficients", lambda t: t[:-1], "missing"),
    ("pieces.coefficients", lambda t: t.astype("<f4"), "another kind or count"),
    ("pieces.times", lambda t: t[::-1], "not in order"),
    ("pieces.times", lambda t: t.reshape(-1), "another kind or count"),
    ("pieces.motion", put(0, 1000), "out of range"),
    ("pieces.lengths", put((0, 0), 0), "out of range"),
    ("motions.numbers", lambda t: t[:, :-1], "another kind or count"),
    ("motions.numbers", put((1, 0), 100.0), "not in order"),
    ("motions.cause", put(0, 999), "out of range"),
    ("motions.kinds", put((0, 0), 9), "out of range"),
    ("ticks", lambda t: t[::-1], "not in order"),
    ("ticks", lambda t: t[:-1], "differ in length"),
    ("counts", put(-1, 10_000), "out of range"),
    ("memory", put(0, 5000), "out of range"),
    ("cells.since", put(0, 77), "out of range"),
    ("cells.kind", put(0, 9), "out of range"),
    ("cells.value", put(0, 1e6), "out of range"),
    ("cells.first", put(1, 10_000), "not told apart"),
    ("cells.name", put(0, 10_000), "out of range"),
    ("names.cells", put(0, 10_000), "out of range"),
    ("names.array", put(0, 1), "another name"),
    ("calls.program", put(0, 7), "out of range"),
    ("calls.called_from", put(1, 1000), "out of range"),
    ("calls.caller", put(1, 1), "before its caller"),
    ("calls.slots", lambda t: t[:-1], "not told apart"),
    ("robot.instructions", put(0, 1000), "out of range"),
    ("robot.begun", lambda t: t[::-1], "not in order"),
    ("robot.counts", put(-1, 1000), "out of range"),
    ("robot.calls", put(0, 1000), "out of range"),
    ("robot.changed", lambda t: t[:-1], "differ in length"),
]


@pytest.mark.parametrize(("name", "change", "words"), TABLES)
def test_a_damaged_array_is_told(name: str, change: Callable[[Any], Any], words: str) -> None:
    found = refusal(with_table(DATA, name, change))
    assert found.rule.code == "V540"
    assert words in found.headline


def nest_a_finding(manifest: dict[str, Any]) -> None:
    """Put a warning among the events, whose exact values are lists in lists."""
    deep: list[Any] = []
    for _ in range(400):
        deep = [deep]
    warning = [["V310", "slug"], "warning", "headline", None, [], [], [], None, None, {"x": deep}]
    manifest["events"].append(["Found", [1.0, warning, None]])


MANIFESTS: list[tuple[Callable[[dict[str, Any]], None], str]] = [
    (lambda m: m.pop("events"), "a list is missing"),
    (lambda m: m.update(statements=-1), "a count is out of range"),
    (lambda m: m.update(statements="31"), "a whole number is missing"),
    (lambda m: m.update(until_s=True), "a number is missing"),
    (lambda m: m.update(until_s=1e9), "a time is out of range"),
    (lambda m: m["hand"]["placements"].pop("can1"), "other objects than the scene has"),
    (lambda m: m["hand"]["placements"]["can1"].reverse(), "nowhere at the start"),
    (lambda m: m["hand"]["placements"]["can1"][0].__setitem__(1, "flying"), "no Lie `flying`"),
    (lambda m: m["hand"]["strokes"].reverse(), "strokes are not in order"),
    (lambda m: m["events"][0].__setitem__(0, "Exploded"), "there is no `Exploded`"),
    (lambda m: m["events"][3][1].pop(), "a list has another length"),
    (lambda m: m["causes"][0].__setitem__(2, [0, 5, 100_000]), "a place is outside its source"),
    (lambda m: m["causes"][0].__setitem__(2, [7, 5, 6]), "a source that is not there"),
    (lambda m: m["commands"][0][1][1].__setitem__(0, "nobody"), "a program that is not there"),
    (lambda m: m["arm"].update(knots=[]), "the operator's speed is none"),
    (lambda m: m["arm"].update(rate=0.0), "the operator's speed is none"),
    (lambda m: m["arm"]["knots"][0].__setitem__(2, 0.0), "does not begin at 0 s"),
    (nest_a_finding, "a finding is nested too deep"),
    (lambda m: m["robot"].update(next=1000), "a count is out of range"),
    (lambda m: m["robot"].update(ending="vanished"), "there is no ending `vanished`"),
    (lambda m: m["system"].update(tool=5000), "a count is out of range"),
    (lambda m: m["scenario"].__setitem__(1, 5.0), "the start of its hand is out of range"),
    (lambda m: m["scenario"][4].__setitem__(0, 10**12), "a limit is out of range"),
    (lambda m: m["origin"]["programs"].update(sources=[]), "there is no program"),
    (lambda m: m["origin"].update(scene=5), "named parts are missing"),
    (lambda m: m["origin"]["scene"].update(name="a\0b"), "a file has no proper name"),
    (lambda m: m["origin"]["scene"].update(text="\ud800"), "a text has half a character"),
    (lambda m: m["events"][0][1].__setitem__(1, "\ud800"), "a text has half a character"),
]


@pytest.mark.parametrize(("change", "words"), MANIFESTS)
def test_a_damaged_description_is_told(
    change: Callable[[dict[str, Any]], None], words: str
) -> None:
    found = refusal(with_manifest(DATA, change))
    assert found.rule.code == "V540"
    assert words in found.headline
