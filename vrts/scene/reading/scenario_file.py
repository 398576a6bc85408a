"""Reads a scenario file: how a run begins, what happens to it from outside, and when it is stopped.

Everything may be left out; what is left out is as in a run without a scenario. Lengths are in
millimetres, angles in degrees, times in seconds of simulated time, speeds in percent.

    title = "part arrives late"
    seed = 7                            # of RANDOM
    monitor_speed = 100                 # the operator's speed

    [start]
    joints_deg = [0, -90, 90, 0, 0, 0]  # or location = "safe", a named location of the scene
    hand_mm = 80                        # or hand = "open", hand = "closed"

    [[inputs]]                          # an input that changes at given times; off at the start
    signal = 1001
    on_s = [2.0, 5.5]
    off_s = [3.0]

    [[analog]]                          # an analog input; it reads 0 at the start
    channel = 1
    at_s = [0.0, 2.5]
    counts = [350, -20]                 # what it reads from then on, each

    [[sensors]]                         # an input that is on while something is in a region
    signal = 1003
    region_mm = { from = [700, -550, -300], to = [900, -350, -100] }
    sees = ["can1"]                     # or ["tool"]; left out: whatever can be carried
    inverted = false

    [prompts]
    answers = ["5", "yes"]              # what PROMPT reads, in order

    [[faults]]
    time_s = 4.0
    kind = "input stuck"                # or "gripper slips", "part missing", "emergency stop"
    signal = 1002                       # of a stuck input only, as is the state
    state = "on"

    [[operator]]                        # what is done at the controller
    time_s = 6.0
    does = "execute"                    # or "stop", "proceed", "retry"
    parts = "put back"                  # before EXECUTE: or "left" (as usual), "taken"

    [random]
    draws = [0.5, 0.25]                 # what RANDOM draws first; then the seed decides

    [programs]                          # in the tick that follows, the process control program
    process_first_s = [1.2]             # has its turn before the robot program

    [limits]
    statements = 2_000_000
    time_s = 600
    motions = 20_000
    output_characters = 1_000_000
    call_depth = 200

    [parameters]                        # as PARAMETER sets them, in the controller's units
    "hand.time" = 0.05

A sensor sees a body when its centre of mass is in the region, and the tool when the middle between
the pads is: see `scene.sensors`. Inputs are sampled at every tick of the controller (28 ms for a
PUMA), so a pulse within one tick may not be noticed.
"""

import hashlib
import re
from collections.abc import Iterable
from types import MappingProxyType

from vrts.base.diagnostic import Diagnostic, Label, Rule
from vrts.base.source import SourceFile, Span
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.scene.model import Act, Deed, Limits, PlannedFault, Scenario, Scene
from vrts.scene.planned import ScenarioFile
from vrts.scene.reading.scenario_analog import read_analog
from vrts.scene.reading.scenario_operator import (
    read_draws,
    read_operator,
    read_turns,
)
from vrts.scene.reading.scenario_signals import (
    LATEST_S,
    Inputs,
    check_count,
    read_faults,
    read_inputs,
)
from vrts.scene.reading.scenario_start import GIVEN_TWICE, read_start

AFTER_THE_END = Rule("V478", "after-the-end")
INVALID_ANSWER = Rule("V479", "invalid-answer")

# The most that a file may allow a run: what a hostile one costs is bounded by these.
MOST_STATEMENTS = 20_000_000
MOST_MOTIONS = 200_000
MOST_OUTPUT = 10_000_000  # characters
MOST_CALLS = 1_000  # in each other
LONGEST_RUN_S = LATEST_S
MOST_ANSWERS = 10_000
LONGEST_ANSWER = 128  # characters: a string of VAL-II [manual language/terminal#answer]
LARGEST_SEED = 2**31 - 1
SLOWEST, FASTEST = 0.01, 100.0  # monitor speed [%]
LARGEST_PARAMETER = 1e6


def read_scenario(
    source: SourceFile, scene: Scene, parameters: Iterable[str]
) -> tuple[ScenarioFile | None, tuple[Diagnostic, ...]]:
    """Return the scenario a file describes, or None, with everything there is to say about it.

    Args:
        source: The text of the file.
        scene: The workspace in which it is to happen.
        parameters: Names of the numbers of the controller that `[parameters]` may set.
    """
    top, problems = read_toml(source)
    found = None if top is None else _scenario(top, source, scene, tuple(parameters))
    diagnostics = problems.in_order()
    if found is None or problems.any_error:
        return None, diagnostics
    return found._replace(warnings=diagnostics), diagnostics


def _scenario(
    top: Table, source: SourceFile, scene: Scene, parameters: tuple[str, ...]
) -> ScenarioFile:
    title = top.string("title", _name(source))
    start = read_start(top.table("start"), scene)
    seed = top.integer("seed", 0, minimum=0, maximum=LARGEST_SEED)
    speed = top.number("monitor_speed", 100.0, minimum=SLOWEST, maximum=FASTEST)
    inputs = read_inputs(top, scene)
    analog = read_analog(top)
    answers = _answers(top.table("prompts"))
    faults = read_faults(top)
    operator = read_operator(top)
    draws = read_draws(top.table("random"))
    turns = read_turns(top.table("programs"))
    limits = _limits(top.table("limits"))
    numbers = _parameters(top.table("parameters"), parameters)
    top.finish()
    _check_times(top, limits, inputs, analog, faults, operator)
    scenario = Scenario(
        configuration=start.configuration,
        hand_opening=start.hand_opening,
        seed=seed,
        inputs=inputs.changes,
        limits=limits,
        parameters=MappingProxyType(numbers),
        sensors=inputs.sensors,
        answers=answers,
        faults=faults,
        monitor_speed=speed,
        operator=operator,
        draws=draws,
        process_first=turns,
        analog=analog,
    )
    return ScenarioFile(title, scenario, hashlib.sha256(source.text.encode()).hexdigest())


def _name(source: SourceFile) -> str:
    return re.split(r"[/\\]", source.name)[-1].removesuffix(".toml") or "scenario"


def _answers(section: Table | None) -> tuple[str, ...]:
    if section is None:
        return ()
    answers = section.strings("answers", ()) or ()
    section.finish()
    span = section.span_of("answers")
    if not check_count(section.problems, len(answers), MOST_ANSWERS, "answers", span):
        return ()
    for index, answer in enumerate(answers):
        reason = _refused(answer)
        if reason:
            section.problems.error(
                INVALID_ANSWER,
                f"answer {index + 1} {reason}",
                section.element_span("answers", index),
                help=("write each line that PROMPT reads as an answer of its own",),
            )
            break
    return answers


def _refused(answer: str) -> str:
    """Return why nobody can type a line, or nothing."""
    if len(answer) > LONGEST_ANSWER:
        return f"has {len(answer)} characters; a line has at most {LONGEST_ANSWER}"
    return "" if answer.isprintable() else "is not one line of printable characters"


def _limits(section: Table | None) -> Limits:
    usual = Limits()
    if section is None:
        return usual
    found = Limits(
        section.integer("statements", usual.statements, minimum=1, maximum=MOST_STATEMENTS),
        section.number("time_s", usual.time_s, above=0.0, maximum=LONGEST_RUN_S),
        section.integer("motions", usual.motions, minimum=1, maximum=MOST_MOTIONS),
        section.integer("call_depth", usual.call_depth, minimum=1, maximum=MOST_CALLS),
        section.integer(
            "output_characters", usual.output_characters, minimum=1, maximum=MOST_OUTPUT
        ),
    )
    section.finish()
    return found


def _parameters(section: Table | None, known: tuple[str, ...]) -> dict[str, float]:
    """Return the values of parameters by their names in small letters.

    A name with a dot may stand in quotation marks or without them, which TOML tells apart.
    """
    if section is None:
        return {}
    names = tuple(name.lower() for name in known)
    groups = {name.partition(".")[0] for name in names if "." in name} - set(names)
    found: dict[str, float] = {}
    places: dict[str, Span] = {}
    for key in section.keys:
        if key.lower() in names:
            _take(section, key, key.lower(), found, places)
        elif key.lower() in groups:
            group = section.table(key)
            if group is not None:
                _group(group, key.lower(), names, found, places)
    _finish(section, names)
    return found


def _group(
    group: Table,
    prefix: str,
    names: tuple[str, ...],
    found: dict[str, float],
    places: dict[str, Span],
) -> None:
    for key in group.keys:
        if f"{prefix}.{key.lower()}" in names:
            _take(group, key, f"{prefix}.{key.lower()}", found, places)
    _finish(group, tuple(n.removeprefix(f"{prefix}.") for n in names if n.startswith(f"{prefix}.")))


def _take(
    table: Table, key: str, name: str, found: dict[str, float], places: dict[str, Span]
) -> None:
    value = table.number(key, minimum=0.0, maximum=LARGEST_PARAMETER)
    span = table.span_of(key)
    if name in places:
        table.problems.error(
            GIVEN_TWICE,
            f"parameter `{name}` is given twice",
            span,
            secondary=(Label(places[name], "the first time"),),
            help=("leave out one of the two",),
        )
    elif value is not None:
        found[name] = value
    places.setdefault(name, span)


def _finish(table: Table, names: tuple[str, ...]) -> None:
    """Report what is no parameter, with the names of those that are not given as proposals."""
    given = {key.lower() for key in table.keys}
    for name in names:
        if name not in given:
            table.number(name)
    table.finish()


def _check_times(
    top: Table,
    limits: Limits,
    inputs: Inputs,
    analog: tuple[tuple[float, int, int], ...],
    faults: tuple[PlannedFault, ...],
    operator: tuple[Act, ...],
) -> None:
    """Warn about what is planned for a time that no run reaches."""
    problems: Problems = top.problems
    planned = [("an input changes", "inputs", change[0]) for change in inputs.changes]
    planned += [("an analog input changes", "analog", change[0]) for change in analog]
    planned += [("a fault comes", "faults", fault.time_s) for fault in faults]
    begun = max([act.time_s for act in operator if act.deed is Deed.EXECUTE], default=0.0)
    late = next((item for item in planned if item[2] > begun + limits.time_s), None)
    if late is not None:
        what, key, time_s = late
        problems.warning(
            AFTER_THE_END,
            f"{what} at {time_s:g} s, and a run is stopped at {limits.time_s:g} s",
            top.span_of(key),
            help=("let it happen earlier, or raise `time_s` of `[limits]`",),
            data={"time_s": time_s, "limit_s": limits.time_s},
        )
