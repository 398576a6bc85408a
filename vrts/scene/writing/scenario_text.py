"""Writes a scenario file: read again, it says the same."""

import json
import math
from collections.abc import Iterable, Iterator, Sequence

from vrts.base.units import DEG, MM
from vrts.scene.model import Deed, FaultKind, Limits, Scenario

USUAL = Scenario()


def scenario_text(title: str, scenario: Scenario) -> str:
    """Return the text of the file of a scenario; what is as usual is left out.

    What a program may not set (`locks`) stands in tasks, not in scenarios.
    """
    blocks = [
        _top(title, scenario),
        _start(scenario),
        *_inputs(scenario),
        *_analog(scenario),
        *_sensors(scenario),
        _list("prompts", "answers", [_text(answer) for answer in scenario.answers]),
        *_faults(scenario),
        *_operator(scenario),
        _list("random", "draws", [_number(draw) for draw in scenario.draws]),
        _list("programs", "process_first_s", [_number(time) for time in scenario.process_first]),
        _limits(scenario.limits),
        _parameters(scenario),
    ]
    return "\n\n".join("\n".join(lines) for lines in blocks if lines) + "\n"


def _top(title: str, scenario: Scenario) -> list[str]:
    lines = [f"title = {_text(title)}"]
    if scenario.seed != USUAL.seed:
        lines.append(f"seed = {scenario.seed}")
    if scenario.monitor_speed != USUAL.monitor_speed:
        lines.append(f"monitor_speed = {_number(scenario.monitor_speed)}")
    return lines


def _start(scenario: Scenario) -> list[str]:
    lines: list[str] = []
    if scenario.configuration is not None:
        joints = ", ".join(_in(DEG, joint) for joint in scenario.configuration)
        lines.append(f"joints_deg = [{joints}]")
    if scenario.hand_opening != USUAL.hand_opening:
        lines.append(f"hand_mm = {_in(MM, scenario.hand_opening)}")
    return ["[start]", *lines] if lines else []


def _inputs(scenario: Scenario) -> Iterator[list[str]]:
    for signal in sorted({signal for _, signal, _ in scenario.inputs}):
        lines = ["[[inputs]]", f"signal = {signal}"]
        for key, state in (("on_s", True), ("off_s", False)):
            times = [t for t, n, on in scenario.inputs if n == signal and on is state]
            if times:
                lines.append(f"{key} = [{', '.join(map(_number, times))}]")
        yield lines


def _analog(scenario: Scenario) -> Iterator[list[str]]:
    for channel in sorted({channel for _, channel, _ in scenario.analog}):
        own = [(time_s, counts) for time_s, n, counts in scenario.analog if n == channel]
        lines = ["[[analog]]", f"channel = {channel}"]
        lines.append(f"at_s = [{', '.join(_number(time_s) for time_s, _ in own)}]")
        lines.append(f"counts = [{', '.join(str(counts) for _, counts in own)}]")
        yield lines


def _sensors(scenario: Scenario) -> Iterator[list[str]]:
    for sensor in scenario.sensors:
        lower, upper = (
            ", ".join(_in(MM, x) for x in corner)
            for corner in (sensor.region.lower, sensor.region.upper)
        )
        lines = ["[[sensors]]", f"signal = {sensor.signal}"]
        lines.append(f"region_mm = {{ from = [{lower}], to = [{upper}] }}")
        if sensor.sees:
            lines.append(f"sees = [{', '.join(map(_text, sensor.sees))}]")
        if sensor.inverted:
            lines.append("inverted = true")
        yield lines


def _faults(scenario: Scenario) -> Iterator[list[str]]:
    for fault in scenario.faults:
        lines = ["[[faults]]", f"time_s = {_number(fault.time_s)}"]
        lines.append(f"kind = {_text(fault.kind.value)}")
        if fault.kind is FaultKind.INPUT_STUCK:
            lines += [f"signal = {fault.signal}", f'state = "{"on" if fault.on else "off"}"']
        yield lines


def _operator(scenario: Scenario) -> Iterator[list[str]]:
    for act in scenario.operator:
        lines = ["[[operator]]", f"time_s = {_number(act.time_s)}", f'does = "{act.deed.value}"']
        if act.deed is Deed.EXECUTE:
            lines.append(f'parts = "{act.parts.value}"')
        yield lines


def _limits(limits: Limits) -> list[str]:
    usual = Limits()
    said = [
        ("statements", limits.statements, usual.statements),
        ("time_s", limits.time_s, usual.time_s),
        ("motions", limits.motions, usual.motions),
        ("output_characters", limits.output_characters, usual.output_characters),
        ("call_depth", limits.call_depth, usual.call_depth),
    ]
    lines = [f"{key} = {_number(value)}" for key, value, known in said if value != known]
    return ["[limits]", *lines] if lines else []


def _parameters(scenario: Scenario) -> list[str]:
    items: Iterable[tuple[str, float]] = sorted(scenario.parameters.items())
    lines = [f"{_text(name.lower())} = {_number(value)}" for name, value in items]
    return ["[parameters]", *lines] if lines else []


def _list(section: str, key: str, items: Sequence[str]) -> list[str]:
    return [f"[{section}]", f"{key} = [{', '.join(items)}]"] if items else []


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False)


def _number(value: float) -> str:
    """Return a number as TOML has it: the shortest that is read as the same."""
    text = repr(value)
    return text.removesuffix(".0") if isinstance(value, float) and "e" not in text else text


def _in(unit: float, value: float) -> str:
    """Return a number which times a unit is a value, to the last digit where there is one."""
    near = value / unit
    tried = (round(near, 6), near, math.nextafter(near, math.inf), math.nextafter(near, -math.inf))
    return _number(next((number for number in tried if number * unit == value), near))
