"""Every field of a model is a switch: another value changes what it says, and nothing else."""

import math
from collections.abc import Mapping

import pytest

from tests.support_engine import main
from tests.support_programs import codes, compiled, ended, happened, started, switched
from vrts.base.oat import components
from vrts.base.pose import IDENTITY, multiply, transpose
from vrts.base.units import deg
from vrts.controllers.model import (
    AlignTurn,
    CornerShape,
    LineTurn,
    NoLength,
    Settling,
    TurnMeasure,
    WristChoice,
)
from vrts.controllers.models import VAL2
from vrts.controllers.values import Value, values, with_value
from vrts.engine.controller import execute
from vrts.engine.memory.events import HandCommanded
from vrts.engine.motion.requests import Stance
from vrts.engine.run import Run
from vrts.live.session.operator.motions import farthest
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.kinematics.choice import NOTHING_REQUESTED
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.default import robot_alone
from vrts.scene.model import controlled

TICK, TACC = 0.028, 0.224
CALM = "MOVE a\nBREAK\nMOVES b\nBREAK\nMOVE c"  # nothing that only some fields are about
OTHER: Mapping[str, Value] = {  # what a field may be instead
    "pace.tick_s": 0.056,
    "pace.departure_ticks": 3,
    "pace.acceleration_s": 0.336,
    "pace.least_accelerations": 4.0,
    "pace.no_length": NoLength.LEAST_TIME,
    "pace.most_speed_percent": 50.0,
    "pace.most_monitor_percent": 50.0,
    "pace.brake_accelerations": 2.0,
    "pace.monitor_accelerations": 2.0,
    "pace.pendant_percent": 50.0,
    "corners.shape": CornerShape.PARABOLA,
    "corners.half_accelerations": 0.5,
    "corners.whole_s": 0.616,
    "lines.turn": LineTurn.ONE_AXIS,
    "lines.measure": TurnMeasure.SUM,
    "lines.align": AlignTurn.KEEPS_T,
    "stops.settling": Settling.WAITS,
    "stops.fine_ticks": 5,
    "stops.coarse_ticks": 4,
    "stops.branch_words_wait": False,
    "next_motion.delay_uses_settings": False,
    "next_motion.delay_moves_hand": False,
    "next_motion.drive_uses_speed": True,
    "programs.steps_a_tick": 10,
    "programs.hand_s": 1.12,
    "programs.pulse_s": 0.56,
    "branches.wrist": WristChoice.KEPT,
    "branches.shoulder_boundary_m": 0.1,
    "branches.elbow_boundary_m": 0.1,
    "branches.wrist_boundary_deg": 5.0,
}
CALM_DIFFERS = {  # fields that every program meets
    "pace.tick_s",
    "pace.departure_ticks",
    "pace.acceleration_s",
    "pace.least_accelerations",
    "pace.most_speed_percent",
    "stops.fine_ticks",
}


def runs(body: str, more: str = "", /, **fields: Value) -> Run:
    """Run a program under the usual model with other values; `group__field` names one."""
    model = VAL2
    for name, value in fields.items():
        model = with_value(model, name.replace("__", "."), value)
    return execute(compiled(main(body, more), "val2+"), controlled(robot_alone(), model))


def lasting(run: Run) -> list[float]:
    """Return how long every motion takes [s]."""
    return [motion.end_s - motion.start_s for motion in run.motions]


def turning(run: Run, start_s: float, end_s: float) -> list[tuple[float, float, float]]:
    """Return the angular velocity of the tool in equal steps of time, by differences [rad/s]."""
    step, found = 1e-4, list[tuple[float, float, float]]()
    for k in range(1, 40):
        time_s = start_s + (end_s - start_s) * k / 40
        before, after = (
            forward(run.scene.robot.arm, run.at(t).configuration).rotation
            for t in (time_s, time_s + step)
        )
        d = multiply(after, transpose(before))
        found.append(((d[7] - d[5]) / 2 / step, (d[2] - d[6]) / 2 / step, (d[3] - d[1]) / 2 / step))
    return found


def test_every_field_has_another_value_here() -> None:
    usual = dict(values(VAL2))
    assert OTHER.keys() == usual.keys()
    assert all(OTHER[name] != value for name, value in usual.items())


@pytest.mark.parametrize("name", OTHER)
def test_a_calm_program_meets_few_of_them(name: str) -> None:
    before, after = runs(CALM), runs(CALM, **{name.replace(".", "__"): OTHER[name]})
    one, other = ([(m.start_s, m.end_s, m.goal) for m in r.motions] for r in (before, after))
    same = one == other and before.horizon_s == after.horizon_s
    assert same is (name not in CALM_DIFFERS)


# --- pace -----------------------------------------------------------------------------------------


def test_a_tick_is_the_distance_of_set_points() -> None:
    run = runs("MOVE a\nBREAK\nMOVES b", pace__tick_s=0.056)
    line = run.motions[1]
    inside = [s for s in run.timeline.segments if line.start_s <= s.start_s < line.end_s - 1e-9]
    assert [s.end_s - s.start_s for s in inside] == pytest.approx([0.056] * len(inside))
    assert started(run)[0] == pytest.approx(0.056)
    assert started(run)[1] - ended(run)[0] == pytest.approx(4 * 0.056)  # FINE, and the next tick


def test_a_motion_at_rest_begins_so_many_ticks_later() -> None:
    assert started(runs("MOVE a", pace__departure_ticks=3)) == [pytest.approx(3 * TICK)]


def test_acceleration_makes_motions_longer_at_both_ends() -> None:
    usual, slow = (
        lasting(runs("MOVE #far", FAR, **f)) for f in ({}, {"pace__acceleration_s": 0.336})
    )
    assert slow[0] - usual[0] == pytest.approx(0.112)


def test_a_short_motion_takes_at_least_so_many_accelerations() -> None:
    for most in (2.0, 3.0, 4.0):
        run = runs("DRIVE 1, 1, 100", pace__least_accelerations=most)
        assert lasting(run)[0] == pytest.approx((most + 1.0) * TACC)


STILL = "MOVE a\nBREAK\nMOVE a\nBREAK\nMOVES a\nBREAK\nMOVE b\nMOVE b"


@pytest.mark.parametrize(
    ("rule", "ticks"),
    [
        (NoLength.NO_TIME, (0, 0, 0)),
        (NoLength.LEAST_TIME, (24, 24, 28)),
        (NoLength.BY_KIND, (0, 24, 28)),
    ],
)
def test_a_motion_to_where_the_arm_is(rule: NoLength, ticks: tuple[int, int, int]) -> None:
    found = lasting(runs(STILL, pace__no_length=rule))
    assert [found[k] for k in (1, 2, 4)] == pytest.approx([n * TICK for n in ticks])


def test_duration_does_not_stretch_a_motion_that_goes_nowhere() -> None:
    assert lasting(runs("MOVE a\nBREAK\nDURATION 2\nMOVES a"))[1] == 0.0
    under = runs("MOVE a\nBREAK\nDURATION 2\nMOVES a", pace__no_length=NoLength.LEAST_TIME)
    assert lasting(under)[1] > 2.0


def test_a_place_that_is_not_left_is_stood_at_exactly() -> None:
    run = runs(
        "READY\nDRIVE 1, 40\nDRIVE 1, -40\nREADY\nBREAK\nTYPE IDENTICAL(#HERE, #PPOINT(0,-90,90))"
    )
    assert run.output.strip() == "-1"


def test_a_program_goes_no_faster_than_the_most() -> None:
    run = runs("SPEED 80\nMOVE a\nTYPE PARAMETER(SPEED.MAX)", pace__most_speed_percent=50.0)
    assert run.motions[0].speed_fraction == 0.5
    assert run.output.strip() == "50"


def test_the_operator_goes_no_faster_than_the_most() -> None:
    slow = runs("SPEED 100 MONITOR\nMOVE a", pace__most_monitor_percent=50.0)
    fast = runs("SPEED 100 MONITOR\nMOVE a")
    assert lasting(slow)[0] == pytest.approx(2.0 * lasting(fast)[0], abs=TACC)


def test_a_stop_takes_so_many_accelerations() -> None:
    body = "MOVE #far\nTIMER 1 = 0\nWAIT TIMER(1) > 0.7\nBRAKE"
    ends = [runs(body, FAR, pace__brake_accelerations=n).motions[0].end_s for n in (1.0, 2.0)]
    assert ends[1] - ends[0] == pytest.approx(TACC)


def test_a_change_of_the_operators_speed_takes_so_many_accelerations() -> None:
    body = "MOVE #far\nTIMER 1 = 0\nWAIT TIMER(1) > 0.7\nSPEED 50 MONITOR"
    for n in (1.0, 3.0):
        run = runs(body, FAR, pace__monitor_accelerations=n)
        after, changed = run.history.arm.scale.knots[-1], run.history.arm.scale.knots[-2]
        assert after.time_s - changed.time_s == pytest.approx(n * TACC)


def test_the_pendant_moves_the_arm_at_a_share_of_its_speed() -> None:
    arm = robot_alone().robot.arm
    branch = branch_of(arm, arm.ready)
    for percent in (25.0, 50.0):
        model = with_value(VAL2, "pace.pendant_percent", percent)
        stance = Stance(arm, arm.ready, branch, NOTHING_REQUESTED, IDENTITY, IDENTITY, model)
        found = farthest(stance, "joint", 0, 1, 1.0)
        assert found is not None
        assert found.lines[0].endswith(f",{percent:g}")


# --- corners --------------------------------------------------------------------------------------

CORNER = "MOVE #far\nMOVE #back"
FAR = ".LOCATIONS\n#far 90 -60 130 40 30 0\n#back 0 -90 90 0 0 90\n.END\n"


@pytest.mark.parametrize(("shape", "powers"), [(CornerShape.QUARTIC, 5), (CornerShape.PARABOLA, 3)])
def test_the_shape_of_a_corner(shape: CornerShape, powers: int) -> None:
    run = runs(CORNER, FAR, corners__shape=shape)
    first, second = run.motions
    assert first.blended
    zone = next(s for s in run.timeline.segments if s.start_s == pytest.approx(first.end_s))
    assert max(len(row) for row in zone.coefficients) == powers
    assert zone.end_s - zone.start_s == pytest.approx(2 * TACC)
    usual = runs(CORNER, FAR)
    assert second.end_s == pytest.approx(usual.motions[1].end_s)


@pytest.mark.parametrize("shape", CornerShape)
@pytest.mark.parametrize("half", [0.5, 1.0, 1.5])
def test_a_corner_takes_so_many_accelerations_and_nothing_jumps(
    shape: CornerShape, half: float
) -> None:
    run = runs(CORNER, FAR, corners__shape=shape, corners__half_accelerations=half)
    first, second = run.motions
    zone = next(s for s in run.timeline.segments if s.start_s == pytest.approx(first.end_s))
    assert zone.end_s - zone.start_s == pytest.approx(2 * half * TACC)
    assert second.end_s == pytest.approx(runs(CORNER, FAR).motions[1].end_s)
    for time_s in (zone.start_s, zone.end_s):
        before, after = run.at(time_s - 1e-9), run.at(time_s + 1e-9)
        assert before.configuration == pytest.approx(after.configuration, abs=1e-6)
        assert before.velocity == pytest.approx(after.velocity, abs=1e-5)


def test_a_corner_fitted_takes_as_long_as_it_says() -> None:
    run = runs(CORNER, FAR, corners__whole_s=0.616)
    zone = next(
        s for s in run.timeline.segments if s.start_s == pytest.approx(run.motions[0].end_s)
    )
    assert zone.end_s - zone.start_s == pytest.approx(0.616)


# --- lines ----------------------------------------------------------------------------------------

BOTH = "SET t = a:RY(-40):RZ(40)\nMOVE a\nBREAK\nSPEED 40\nMOVES t"  # both turns by 40 degrees


@pytest.mark.parametrize(
    ("measure", "share"),
    [(TurnMeasure.LARGER, math.sqrt(2.0)), (TurnMeasure.TRUE, 1.0), (TurnMeasure.SUM, 0.5**0.5)],
)
def test_the_limit_of_turning_is_for_one_angle(measure: TurnMeasure, share: float) -> None:
    run = runs(BOTH, lines__measure=measure)
    line = run.motions[1]
    fastest = max(math.dist((0, 0, 0), w) for w in turning(run, line.start_s, line.end_s))
    limit = 0.4 * run.scene.robot.arm.angular_speed
    assert fastest / limit == pytest.approx(share, rel=0.04)  # a motion takes whole ticks
    assert measure is not TurnMeasure.TRUE or fastest <= limit * (1.0 + 1e-4)


def test_the_tool_turns_about_one_axis_or_by_two_turns() -> None:
    spread: dict[LineTurn, float] = {}
    for turn in LineTurn:
        run = runs(BOTH, lines__turn=turn)
        line = run.motions[1]
        axes = [
            tuple(part / math.dist((0, 0, 0), w) for part in w)
            for w in turning(run, line.start_s, line.end_s)
            if math.dist((0, 0, 0), w) > 0.1
        ]
        spread[turn] = max(math.dist(axes[0], axis) for axis in axes)
        goal = run.at(run.horizon_s).configuration
        assert goal == pytest.approx(runs(BOTH).at(run.horizon_s).configuration, abs=1e-6)
    assert spread[LineTurn.ONE_AXIS] < 1e-3 < 0.2 < spread[LineTurn.TWO_TURNS]


def test_align_turns_as_little_as_it_can_or_keeps_the_angle_t() -> None:
    body = "MOVE TRANS(900,100,100,70,20,35)\nALIGN"
    ends = {
        rule: components(runs(body, lines__align=rule).motions[-1].X_WT)[3:] for rule in AlignTurn
    }
    assert ends[AlignTurn.KEEPS_T] == pytest.approx((90.0, 0.0, 35.0), abs=1e-4)
    assert ends[AlignTurn.SMALLEST][:2] == pytest.approx((90.0, 0.0), abs=1e-4)
    assert abs(ends[AlignTurn.SMALLEST][2] - 35.0) > 1.0
    down = "MOVE TRANS(900,100,100,70,80,35)\nALIGN"  # no axis that is level: no other turn
    both = [runs(down, lines__align=rule).motions[-1].goal for rule in AlignTurn]
    assert both[0] == both[1]


# --- stops ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "body", ["DISABLE CP\nMOVE a\nMOVE b", "MOVE a\nMOVE #flip", "MOVE a\nDELAY 1\nMOVE b"]
)
def test_the_arm_settles_at_every_stop_or_only_where_a_step_waits(body: str) -> None:
    flip = ".LOCATIONS\n#flip 20 -60 100 10 -30 20\n.END\n"
    starts = [started(runs(body, flip, stops__settling=rule))[1] for rule in Settling]
    assert starts[0] - starts[1] == pytest.approx(3 * TICK)


@pytest.mark.parametrize(("word", "field"), [("FINE", "fine"), ("COARSE", "coarse")])
def test_settling_takes_so_many_ticks(word: str, field: str) -> None:
    for ticks in (0, 2, 5):
        run = runs(f"{word}\nMOVE a\nBREAK\nSIGNAL 1", **{f"stops__{field}_ticks": ticks})
        assert switched(run)[1] - ended(run)[0] == pytest.approx(ticks * TICK)


def test_words_of_the_branch_wait_or_do_not() -> None:
    body = "MOVE a\nNOFLIP\nSIGNAL 1\nMOVE b"
    waits, goes_on = runs(body), runs(body, stops__branch_words_wait=False)
    assert switched(waits)[1] == pytest.approx(ended(waits)[0] + 3 * TICK)
    assert switched(goes_on)[1] == 0.0


# --- the next motion ------------------------------------------------------------------------------


def test_a_delay_uses_up_settings_or_leaves_them() -> None:
    body = "SPEED 20\nCOARSE\nDELAY 0.1\nMOVE a\nBREAK\nSIGNAL 1"
    uses, leaves = runs(body), runs(body, next_motion__delay_uses_settings=False)
    assert [run.motions[0].speed_fraction for run in (uses, leaves)] == [1.0, 0.2]
    waits = [switched(run)[1] - ended(run)[0] for run in (uses, leaves)]
    assert waits == pytest.approx([3 * TICK, TICK])


def test_a_delay_moves_the_hand_or_leaves_it() -> None:
    body = "MOVE a\nOPEN\nDELAY 1\nMOVE b"
    moves, leaves = runs(body), runs(body, next_motion__delay_moves_hand=False)
    assert happened(moves, HandCommanded)[0].time_s == pytest.approx(ended(moves)[0] + 3 * TICK)
    assert happened(leaves, HandCommanded)[0].time_s == pytest.approx(started(leaves)[1])


def test_a_drive_uses_up_a_speed_or_leaves_it() -> None:
    body = "SPEED 20\nDRIVE 1, 10, 50\nMOVE a"
    found = [
        [motion.speed_fraction for motion in run.motions]
        for run in (runs(body), runs(body, next_motion__drive_uses_speed=True))
    ]
    assert found == [[0.5, 0.2], [0.5, 1.0]]


# --- programs -------------------------------------------------------------------------------------


def test_a_program_does_so_many_steps_a_tick() -> None:
    body = "\n".join(["n = 1"] * 60)
    for steps in (10, 25):
        run = runs(body, programs__steps_a_tick=steps)
        done = list(run.history.counts)
        assert done[1] - done[0] == done[2] - done[1] == steps  # EXECUTE comes first


def test_the_wait_after_openi() -> None:
    run = runs("OPENI\nSIGNAL 1\nTYPE PARAMETER(HAND.TIME)", programs__hand_s=1.12)
    assert switched(run)[1] == pytest.approx(1.12)
    assert run.output.strip() == "1.12"


def test_a_pulse_without_a_time() -> None:
    run = runs("PULSE 1\nWAIT SIG(-1)\nTYPE TIMER(0)", programs__pulse_s=0.56)
    assert switched(run)[1] == pytest.approx(0.56)


# --- branches -------------------------------------------------------------------------------------


def test_the_wrist_that_turns_less_or_the_present_one() -> None:
    body = (
        "SET #s = #PPOINT(0,-60,100,10,30,-80)\nMOVE #s\nSET #g = #PPOINT(0,-60,100,150,40,100)\n"
    )
    body += "SET goal = #g\nMOVE goal"
    ends = {rule: deg(runs(body, branches__wrist=rule).motions[-1].goal[4]) for rule in WristChoice}
    assert ends == {WristChoice.NEAREST: pytest.approx(-40), WristChoice.KEPT: pytest.approx(40)}


@pytest.mark.parametrize(
    ("joints", "field"),
    [
        ("0,-92,90,0,30,0", "branches__shoulder_boundary_m"),
        ("0,-60,86,0,30,0", "branches__elbow_boundary_m"),
    ],
)
def test_near_a_boundary_the_arm_keeps_its_branch(joints: str, field: str) -> None:
    """Both points are 52 and 59 mm beyond it, on the other side than the arm was before."""
    body = f"MOVE #PPOINT({joints})\nMOVE a"
    wide, usual = runs(body, **{field: 0.1}), runs(body)
    assert wide.motions[-1].goal == runs("MOVE a").motions[-1].goal
    assert usual.motions[-1].goal != wide.motions[-1].goal


def test_with_joint_5_near_zero_the_arm_keeps_its_wrist() -> None:
    body = "MOVE #PPOINT(0,-60,100,0,-2,0)\nBREAK\nNOFLIP\nMOVES HERE:TRANS(0,0,5)"
    assert "V304" in codes(runs(body))
    assert "V304" not in codes(runs(body, branches__wrist_boundary_deg=5.0))
