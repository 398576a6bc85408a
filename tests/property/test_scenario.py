"""Whatever stands in a scenario file, it is read or refused, never half of either."""

from hypothesis import given
from hypothesis import strategies as st

from vrts.base.source import SourceFile
from vrts.robots.model import Configuration
from vrts.scene.default import robot_alone
from vrts.scene.reading.scenario_file import (
    LONGEST_RUN_S,
    MOST_CALLS,
    MOST_MOTIONS,
    MOST_OUTPUT,
    MOST_STATEMENTS,
    read_scenario,
)

ALONE = robot_alone()
NUMBERS = st.one_of(
    st.integers(-5, 2000).map(str),
    st.floats(-1e3, 1e5, allow_nan=False).map(lambda value: repr(round(value, 3))),
    st.sampled_from(["nan", "inf", "-inf", "1e400", "true", '"5"', "9" * 400, "[]", "{ a = 1 }"]),
)
LISTS = st.lists(NUMBERS, max_size=7).map(lambda items: "[" + ", ".join(items) + "]")
VALUES = st.one_of(
    NUMBERS,
    LISTS,
    st.sampled_from(
        [
            '"open"',
            '"safe"',
            '["tool"]',
            '["\\u0007"]',
            '"input stuck"',
            '"emergency stop"',
            '"execute"',
            '"put back"',
            '"on"',
            "{ from = [0, 0, 0], to = [1, 1, 1] }",
        ]
    ),
)
KEYS = {
    "": ("title", "seed", "monitor_speed", "limits", "start", "other"),
    "[start]": ("joints_deg", "hand_mm", "hand", "location"),
    "[[inputs]]": ("signal", "on_s", "off_s"),
    "[[analog]]": ("channel", "at_s", "counts"),
    "[[sensors]]": ("signal", "region_mm", "sees", "inverted"),
    "[prompts]": ("answers",),
    "[[faults]]": ("time_s", "kind", "signal", "state"),
    "[[operator]]": ("time_s", "does", "parts"),
    "[random]": ("draws",),
    "[programs]": ("process_first_s",),
    "[limits]": ("statements", "time_s", "motions", "output_characters", "call_depth"),
    "[parameters]": ('"hand.time"', "hand.time", "hand", "speed.max"),
}


@st.composite
def sections(draw: st.DrawFn) -> str:
    header = draw(st.sampled_from(list(KEYS)))
    keys = draw(st.lists(st.sampled_from(KEYS[header]), unique=True))
    return "\n".join([header, *(f"{key} = {draw(VALUES)}" for key in keys)])


@st.composite
def times(draw: st.DrawFn) -> list[float]:
    return draw(st.lists(st.floats(0.0, 7200.0), unique=True, max_size=8))


@given(st.lists(sections(), max_size=6).map("\n".join))
def test_a_file_is_read_or_refused(text: str) -> None:
    found, diagnostics = read_scenario(SourceFile("a.toml", text), ALONE, ("HAND.TIME",))
    assert (found is None) is any(d.is_error for d in diagnostics)
    if found is None:
        return
    scenario = found.scenario
    limits = scenario.limits
    assert 1 <= limits.statements <= MOST_STATEMENTS
    assert 0 < limits.time_s <= LONGEST_RUN_S
    assert 1 <= limits.motions <= MOST_MOTIONS
    assert 1 <= limits.output_characters <= MOST_OUTPUT
    assert 1 <= limits.call_depth <= MOST_CALLS
    assert list(scenario.inputs) == sorted(scenario.inputs)
    assert [f.time_s for f in scenario.faults] == sorted(f.time_s for f in scenario.faults)
    assert list(scenario.analog) == sorted(scenario.analog)
    assert all(n in range(1, 9) and -2048 <= c <= 2047 for _, n, c in scenario.analog)
    driven = {signal for _, signal, _ in scenario.inputs}
    watched = [sensor.signal for sensor in scenario.sensors]
    assert len(set(watched)) == len(watched)
    assert driven.isdisjoint(watched)
    for sensor in scenario.sensors:
        assert all(a < b for a, b in zip(*sensor.region, strict=True))
    q: Configuration = scenario.configuration or ALONE.robot.arm.ready
    arm = ALONE.robot.arm
    for value, lower, upper in zip(q, arm.lower, arm.upper, strict=True):
        assert lower - 1e-9 <= value <= upper + 1e-9


@given(times())
def test_inputs_come_in_the_order_of_time_with_the_state_of_their_list(
    given_s: list[float],
) -> None:
    on, off = given_s[::2], given_s[1::2]
    text = f"[[inputs]]\nsignal = 1001\non_s = {on}\noff_s = {off}\n"
    found, diagnostics = read_scenario(SourceFile("a.toml", text), ALONE, ())
    if not given_s:
        assert [d.rule.code for d in diagnostics] == ["V475"]
        return
    assert found is not None, diagnostics
    assert found.scenario.inputs == tuple(
        sorted([*((t, 1001, True) for t in on), *((t, 1001, False) for t in off)])
    )
