"""A session by its orders: what moves, what is refused, what is told."""

import math
from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import (
    AskReach,
    AskSnapshot,
    Began,
    Happened,
    Moved,
    Output,
    Programs,
    Reached,
    Snapshot,
    Status,
)
from vrts.live.session.views.frame import HOLDING, MOVING, RUNNING, STOPPING

DOWN = (0.0, math.pi / 2, 0.0)  # O, A, T of a hand that points at the floor
ABOVE_TABLE = (0.75, -0.15, 0.0)
TICK = 0.028


@pytest.fixture
def driven(tmp_path: Path) -> Driven:
    return Driven(tmp_path)


def to_the_table(driven: Driven) -> None:
    """Bring the tool over the table, where lines can begin."""
    ref = driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(4.0)
    assert driven.done(ref).accepted


def test_frames_come_with_every_beat_and_tell_the_time(driven: Driven) -> None:
    driven.run(0.2)
    assert len(driven.frames) == 10
    assert [f.sequence for f in driven.frames] == list(range(10))
    assert driven.frames[-1].time_s == pytest.approx(0.2)
    assert driven.frames[-1].session == 7


def test_pointer_goes_where_it_points_from_the_tick_after_its_stamp(driven: Driven) -> None:
    driven.run(1.0)
    stamp_s = driven.session.now_s
    ref = driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(0.12)
    moving = next(f for f in driven.frames if f.flags & MOVING)
    assert stamp_s <= driven.done(ref).at_s < stamp_s + 1e-6
    assert moving.time_s - stamp_s <= TICK + 0.02
    began_s = driven.session.growing.machine.system.planner.given.motions[-1].start_s
    assert began_s == pytest.approx(math.ceil(stamp_s / TICK) * TICK)
    driven.run(4.0)
    status = driven.said(Status)[-1]
    assert status.location[:3] == pytest.approx((750.0, -150.0, 0.0), abs=0.01)
    assert status.mode == "idle"


def test_refusals_explain_themselves_and_move_nothing(driven: Driven) -> None:
    driven.run(0.1)
    far = driven.done(driven.act(do.Go((2.0, 0.0, 0.0), DOWN)))
    line = driven.done(driven.act(do.Go(ABOVE_TABLE, DOWN, straight=True)))
    joint = driven.done(driven.act(do.Step("joint", 1, -1, 1.0)))
    driven.run(0.5)
    assert not far.accepted
    assert far.code == "V301"
    assert "beyond reach" in far.text
    assert far.help == "", "who sits at a browser has no shell"
    assert not line.accepted
    assert line.code == "V305"
    assert line.help == "begin with MOVE"
    assert joint.accepted  # a joint within its limits
    driven.run(2.0)
    for _ in range(4):
        joint = driven.done(driven.act(do.Step("joint", 1, -1, 1.0)))
        driven.run(2.0)
    assert not joint.accepted
    assert joint.code == "V303"
    assert "limits" in joint.text


def test_reach_is_answered_at_once_with_branch_and_joints(driven: Driven) -> None:
    driven.session.take(AskReach(3, ABOVE_TABLE, DOWN))
    driven.session.take(AskReach(4, (0.0, 0.0, 0.0), DOWN))
    near, inside = driven.said(Reached)
    assert near.ref == 3
    assert near.reachable
    assert near.branch[:2] == ("lefty", "above")
    assert len(near.joints_rad) == 6
    assert not inside.reachable
    assert inside.why
    assert inside.code == "V301"


def test_reach_of_a_line_says_where_it_fails(driven: Driven) -> None:
    to_the_table(driven)
    driven.session.take(AskReach(1, (-0.75, -0.15, 0.0), DOWN, straight=True))
    (told,) = driven.said(Reached)
    assert not told.reachable
    assert "straight line" in told.why


def test_steps_of_the_pendant_move_by_their_size(driven: Driven) -> None:
    to_the_table(driven)
    before = driven.said(Status)[-1].location
    for step in (do.Step("world", 2, 1, 0.05), do.Step("tool", 2, -1, 0.03)):
        assert driven.done(driven.act(step)).accepted
        driven.run(1.5)
    driven.act(do.Step("world", 5, 1, math.radians(10.0)))
    driven.run(1.5)
    after = driven.said(Status)[-1].location
    assert after[2] - before[2] == pytest.approx(80.0, abs=0.01)  # up twice: the tool points down
    assert abs(after[3] - before[3]) == pytest.approx(10.0, abs=0.01) or abs(
        after[5] - before[5]
    ) == pytest.approx(10.0, abs=0.01)


def test_presses_one_after_the_other_add_up(driven: Driven) -> None:
    to_the_table(driven)
    before = driven.said(Status)[-1].location
    refs = [driven.act(do.Step("world", 0, 1, 0.01)) for _ in range(5)]
    driven.run(4.0)
    assert all(driven.done(ref).accepted for ref in refs)
    assert driven.said(Status)[-1].location[0] - before[0] == pytest.approx(50.0, abs=0.01)


def test_panic_decelerates_from_the_next_tick(driven: Driven) -> None:
    driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(0.6)
    assert driven.frames[-1].flags & MOVING
    pressed_s = driven.session.now_s
    driven.halt()
    driven.run(1.0)
    stopping = [f for f in driven.frames if f.flags & STOPPING]
    assert stopping[0].time_s - pressed_s <= TICK + 0.021
    assert not driven.frames[-1].flags & MOVING
    assert stopping[-1].time_s - pressed_s <= 0.224 + 2 * TICK + 0.021


def test_panic_stops_a_program_and_what_waits(driven: Driven) -> None:
    driven.act(do.Upload("loop.v2", ".PROGRAM loop()\n 10 x = x + 1\n GOTO 10\n.END\n"))
    driven.run(0.2)
    driven.typed("DO x = 0", "EXECUTE loop")
    assert driven.frames[-1].flags & RUNNING
    driven.halt()
    driven.run(0.2)
    assert not driven.frames[-1].flags & RUNNING
    assert any("Program stopped" in text for text in driven.texts(Output))


def test_a_held_key_moves_until_it_is_let_go(driven: Driven) -> None:
    ref = driven.act(do.Jog("joint", 0, 1, 1.0))
    for _ in range(10):
        driven.run(0.1)
        driven.act(do.Keep())
    assert driven.done(ref).accepted
    assert driven.said(Status)[-1].mode == "jogging"
    driven.act(do.LetGo())
    driven.run(0.6)
    stopped = driven.frames[-1].joints[0]
    assert stopped > 0.2
    driven.run(0.4)
    assert driven.frames[-1].joints[0] == stopped


def test_silence_of_200_ms_counts_as_letting_go(driven: Driven) -> None:
    driven.act(do.Jog("joint", 0, -1, 1.0))
    driven.run(0.1)
    driven.act(do.Keep())
    heard_s = driven.session.now_s
    driven.run(1.0)
    stopping = [f for f in driven.frames if f.flags & STOPPING]
    assert 0.2 <= stopping[0].time_s - heard_s <= 0.2 + TICK + 0.021
    assert any("200 ms" in h.text for h in driven.said(Happened))
    assert not driven.done(driven.act(do.Keep())).accepted


def test_a_key_replaces_the_motion_under_way(driven: Driven) -> None:
    driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(0.5)
    ref = driven.act(do.Jog("joint", 5, 1, 1.0))
    for _ in range(12):
        driven.run(0.1)
        driven.act(do.Keep())
    assert driven.done(ref).accepted
    first, last = driven.frames[-20], driven.frames[-1]
    assert last.joints[5] > first.joints[5]
    assert last.joints[:5] == first.joints[:5]  # it does not go on to the pointer


@pytest.mark.parametrize("axis", range(6))
def test_keys_of_world_and_tool_follow_lines(driven: Driven, axis: int) -> None:
    to_the_table(driven)
    before = driven.said(Status)[-1].location
    for frame, way in (("world", 1), ("tool", -1)):
        ref = driven.act(do.Jog(frame, axis, way, 1.0))  # type: ignore[arg-type]
        for _ in range(5):
            driven.run(0.1)
            driven.act(do.Keep())
        assert driven.done(ref).accepted
        driven.act(do.LetGo())
        driven.run(0.5)
    assert driven.said(Status)[-1].location != before


def test_keys_are_refused_while_a_program_runs(driven: Driven) -> None:
    driven.act(do.Upload("loop.v2", ".PROGRAM loop()\n 10 x = 1\n GOTO 10\n.END\n"))
    driven.run(0.1)
    driven.typed("EXECUTE loop")
    for action in (do.Jog("joint", 0, 1), do.Go(ABOVE_TABLE, DOWN), do.Ready(), do.Hand(True)):
        done = driven.done(driven.act(action))
        assert not done.accepted
        assert done.code == "busy"
        assert "panic" in done.help


def test_the_hand_opens_and_closes(driven: Driven) -> None:
    driven.act(do.Hand(open=True))
    driven.run(0.5)
    assert driven.frames[-1].hand_m == pytest.approx(0.08)
    driven.act(do.Hand(open=False))
    driven.run(0.5)
    assert driven.frames[-1].hand_m == pytest.approx(0.0)


def test_a_grasped_object_is_told_with_its_place_in_the_hand(driven: Driven) -> None:
    grasp(driven)
    (moved,) = driven.said(Moved)
    assert driven.frames[-1].flags & HOLDING
    (row,) = moved.bodies
    assert row.lie == "held"
    assert len(row.X) == 12
    held = driven.said(Status)[-1].held
    assert held == row.body
    driven.act(do.Step("world", 2, 1, 0.1))
    driven.run(1.0)
    driven.act(do.Hand(open=True))
    driven.run(1.0)
    lies = [row.lie for moved in driven.said(Moved)[1:] for row in moved.bodies]
    assert lies == ["falling", "resting"]
    kinds = [h.text for h in driven.said(Happened) if h.kind == "grasp"]
    assert kinds[0] == f"{held} grasped"
    assert "to fall 100 mm" in kinds[1]


def grasp(driven: Driven) -> None:
    """Take the first can of the scene by pointer and buttons."""
    body = next(b for b in driven.session.setting.scene.bodies if b.name.startswith("can"))
    x, y, z = body.X_WO.translation
    driven.act(do.Hand(open=True))
    driven.act(do.Go((x, y, z + 0.2), DOWN))
    driven.run(4.0)
    driven.act(do.Go((x, y, z + 0.06), DOWN, straight=True))
    driven.run(2.0)
    driven.act(do.Hand(open=False))
    driven.run(1.0)


def test_the_monitor_answers_asks_and_edits(driven: Driven) -> None:
    assert "X/JT1" in driven.typed("WHERE")
    driven.typed("HERE p1")
    assert driven.said(Output)[-1].prompt == "Change?\n"
    driven.typed("")
    assert driven.said(Output)[-1].prompt == "."
    driven.typed("EDIT prog", "TYPE 1", "E", seconds=0.2)
    assert [p.name for p in driven.said(Programs)[-1].programs] == ["prog"]
    assert "1" in driven.typed("EXECUTE prog", seconds=0.3)
    assert "*Illegal monitor command*" in driven.typed("NONSENSE")


def test_a_question_is_left_when_somebody_else_types(driven: Driven) -> None:
    driven.typed("EDIT prog")
    assert driven.said(Output)[-1].prompt != "."
    driven.act(do.Typed("WHERE"), owner="bob")
    driven.run(0.1)
    assert driven.said(Output)[-1].prompt == "."
    assert "X/JT1" in driven.said(Output)[-1].text


def test_users_have_folders_of_their_own(driven: Driven, tmp_path: Path) -> None:
    text = ".PROGRAM one()\n TYPE 1\n.END\n"
    driven.act(do.Upload("one.v2", text), owner="ada")
    driven.run(0.1)
    assert (tmp_path / "ada" / "one.v2").read_text() == text
    driven.act(do.Typed("FDIRECTORY"), owner="bob")
    driven.run(0.1)
    assert "one.v2" not in driven.said(Output)[-1].text
    for name in ("../one.v2", "/etc/one.v2", "one.sh", "a/b.v2"):
        done = driven.done(driven.act(do.Upload(name, text)))
        assert not done.accepted
        assert done.text
    assert sorted(p.name for p in tmp_path.rglob("*.*")) == ["one.v2"]


def test_uploads_stay_within_the_quota(tmp_path: Path) -> None:
    driven = Driven(tmp_path, quota=1000)
    text = f".PROGRAM one()\n; {'x' * 600}\n.END\n"
    assert driven.done(driven.act(do.Upload("one.v2", text))).accepted
    driven.run(0.1)
    assert not driven.done(driven.act(do.Upload("two.v2", text))).accepted


def test_locations_are_recorded_as_they_are(driven: Driven) -> None:
    to_the_table(driven)
    driven.act(do.Record("spot"))
    driven.act(do.Record("#spot"))
    driven.run(0.1)
    assert "750.00" in driven.typed("LISTL spot")
    assert not driven.done(driven.act(do.Record("2bad"))).accepted


def test_reset_puts_the_scene_back_and_keeps_the_memory(driven: Driven) -> None:
    grasp(driven)
    driven.act(do.Record("spot"))
    driven.act(do.Upload("one.v2", ".PROGRAM one()\n TYPE 1\n.END\n"))
    driven.run(0.2)
    driven.act(do.Reset())
    (began,) = driven.said(Began)
    assert began.time_s == 0.0
    assert began.epoch_s == driven.clock_s
    driven.run(0.2)
    assert driven.frames[-1].time_s == pytest.approx(0.2)
    assert not driven.frames[-1].flags & HOLDING
    assert {b.lie for b in driven.said(Snapshot)[-1].bodies} == {"resting"}
    assert "spot" in driven.typed("LISTL spot")
    assert "1" in driven.typed("EXECUTE one", seconds=0.3)


def test_rewinding_goes_on_from_an_earlier_moment(driven: Driven) -> None:
    driven.run(1.0)
    earlier = driven.frames[-1]
    driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(2.0)
    driven.act(do.Rewind(0.9))
    driven.run(0.5)
    assert driven.frames[-1].joints == earlier.joints
    assert driven.frames[-1].time_s == pytest.approx(1.4)
    assert not driven.done(driven.act(do.Rewind(99.0))).accepted


def test_a_snapshot_holds_what_a_late_comer_needs(driven: Driven) -> None:
    driven.typed("WHERE")
    driven.act(do.Upload("one.v2", ".PROGRAM one()\n TYPE 1\n.END\n"))
    driven.run(0.2)
    driven.session.take(AskSnapshot(9))
    snapshot = driven.said(Snapshot)[-1]
    assert snapshot.ref == 9
    assert "X/JT1" in snapshot.output
    assert [p.name for p in snapshot.programs] == ["one"]
    movable = [b for b in driven.session.setting.scene.bodies if b.mobility.value == "movable"]
    assert len(snapshot.bodies) == len(movable)


def test_time_that_was_slept_through_is_given_up(driven: Driven) -> None:
    driven.run(1.0)
    driven.clock_s += 3600.0
    driven.session.beat()
    assert driven.frames[-1].time_s == pytest.approx(1.0, abs=0.05)
    assert driven.said(Began)


def test_the_status_lights_the_line_that_runs(driven: Driven) -> None:
    driven.act(do.Upload("slow.v2", ".PROGRAM slow()\n TYPE 1\n WAIT SIG(1001)\n TYPE 2\n.END\n"))
    driven.run(0.2)
    driven.typed("EXECUTE slow", seconds=0.5)
    status = driven.said(Status)[-1]
    assert (status.program, status.line, status.text) == ("slow", 2, "WAIT SIG(1001)")
    assert status.mode == "waiting"


def test_a_program_runs_while_the_arm_moves_for_it(driven: Driven) -> None:
    driven.act(do.Upload("slow.v2", ".PROGRAM slow()\n DRIVE 1,60,50\n BREAK\n TYPE 2\n.END\n"))
    driven.run(0.2)
    driven.typed("EXECUTE slow", seconds=0.5)
    status = driven.said(Status)[-1]
    assert status.mode == "running"


def test_too_many_variables_stop_the_program(driven: Driven) -> None:
    text = ".PROGRAM fill()\n 10 a[i] = 1\n i = i + 1\n GOTO 10\n.END\n"
    driven.act(do.Upload("fill.v2", text))
    driven.run(0.1)
    driven.typed("DO i = 0", "EXECUTE fill")
    driven.run(25.0, beat_s=0.5)
    assert not driven.frames[-1].flags & RUNNING
    assert any("20,000 variables" in h.text for h in driven.said(Happened))


@pytest.mark.thorough
def test_after_a_key_is_let_go_the_monitor_is_free_at_once(driven: Driven) -> None:
    driven.act(do.Upload("slow.v2", ".PROGRAM slow()\n 10 x = 1\n GOTO 10\n.END\n"))
    driven.act(do.Jog("joint", 0, 1, 0.2))
    for _ in range(5):
        driven.run(0.1)
        driven.act(do.Keep())
    driven.act(do.LetGo())
    driven.run(0.6)
    status = driven.said(Status)[-1]
    assert (status.mode, status.prompt) == ("idle", ".")
    assert "Illegal" not in driven.typed("EXECUTE slow")
    driven.run(40.0, beat_s=0.1)  # longer than the key would have led
    assert driven.said(Status)[-1].mode == "running"
    assert driven.said(Status)[-1].prompt == "*"
    assert "completed" not in "".join(driven.texts(Output))
    assert "Illegal" in driven.typed("EXECUTE slow")


def test_panic_stops_as_soon_at_a_low_monitor_speed(driven: Driven) -> None:
    driven.typed("SPEED 5", "DO DRIVE 1,-90,100", seconds=1.0)
    assert driven.frames[-1].flags & MOVING
    driven.halt()
    driven.run(0.3)
    stopped = driven.frames[-1].joints
    driven.run(2.0)
    assert driven.frames[-1].joints == stopped


def test_a_rewind_that_waited_leads_to_its_moment(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(5.0)
    driven.act(do.Step("joint", 0, 1, 0.1))
    driven.act(do.Rewind(2.0))  # its turn comes at the next tick
    line = driven.act(do.Typed("DO a = 1"))
    driven.run(0.1)
    assert driven.session.growing.time_s == pytest.approx(2.1, abs=0.05)
    assert driven.done(line).at_s == pytest.approx(2.0, abs=0.05)
