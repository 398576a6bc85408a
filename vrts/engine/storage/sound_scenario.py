"""Whether the scenario of a saved run is one that a scenario file could have said."""

from itertools import pairwise

from vrts.engine.programs.signals import INPUTS
from vrts.engine.storage.damage import require
from vrts.ir.ranges import ANALOG_INPUTS, LEAST_COUNT, MOST_COUNT
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.robots.kinematics.kinematics import limit_violations
from vrts.scene.model import FASTEST_ACCELERATION, Scenario, Scene
from vrts.scene.reading.scenario_file import (
    FASTEST,
    LARGEST_PARAMETER,
    LARGEST_SEED,
    LONGEST_ANSWER,
    LONGEST_RUN_S,
    MOST_ANSWERS,
    MOST_CALLS,
    MOST_MOTIONS,
    MOST_OUTPUT,
    MOST_STATEMENTS,
    SLOWEST,
)
from vrts.scene.reading.scenario_operator import LARGEST_DRAW, MOST_DRAWS, MOST_TURNS
from vrts.scene.reading.scenario_signals import LATEST_S, MOST_ENTRIES

TOLERANCE = 1e-6  # [m] of the hand's opening


def check_scenario(scenario: Scenario, scene: Scene) -> None:
    """Check everything that executing a program under a scenario relies on.

    Raises:
        Damaged: Something is out of range.
    """
    limits, gripper = scenario.limits, scene.robot.gripper
    bounded = (
        (limits.statements, MOST_STATEMENTS),
        (limits.time_s, LONGEST_RUN_S),
        (limits.motions, MOST_MOTIONS),
        (limits.call_depth, MOST_CALLS),
        (limits.output_characters, MOST_OUTPUT),
    )
    require(all(0 < limit <= most for limit, most in bounded), "a limit is out of range")
    q = scenario.configuration
    reachable = q is None or not limit_violations(scene.robot.arm, q)
    require(reachable, "the start of its arm is out of range")
    opening = -TOLERANCE <= scenario.hand_opening <= gripper.opening_max + TOLERANCE
    require(opening, "the start of its hand is out of range")
    require(0 <= scenario.seed <= LARGEST_SEED, "its seed is out of range")
    require(SLOWEST <= scenario.monitor_speed <= FASTEST, "its monitor speed is out of range")
    answers = scenario.answers
    short = len(answers) <= MOST_ANSWERS and all(len(line) <= LONGEST_ANSWER for line in answers)
    require(short, "its answers are too long")
    drawn = all(0.0 <= draw <= LARGEST_DRAW for draw in scenario.draws)
    require(drawn and len(scenario.draws) <= MOST_DRAWS, "a random number is out of range")
    require(len(scenario.operator) <= MOST_ENTRIES, "its operator does too much")
    turns = scenario.process_first
    in_time = all(0.0 <= time_s <= LONGEST_RUN_S for time_s in turns)
    require(in_time and len(turns) <= MOST_TURNS, "a turn of its programs is out of range")
    names = {name.lower() for name in PARAMETERS}
    for name, value in scenario.parameters.items():
        require(name.lower() in names, f"there is no parameter `{name}`")
        require(0.0 <= value <= LARGEST_PARAMETER, f"its parameter `{name}` is out of range")
    known = all(name in PARAMETERS or name in SWITCHES for name in scenario.locks.names)
    require(known, "it locks what there is not")
    most = scenario.locks.acceleration
    require(1.0 <= most <= FASTEST_ACCELERATION, "its largest acceleration is out of range")
    _check_signals(scenario)


def _check_signals(scenario: Scenario) -> None:
    times = [change[0] for change in scenario.inputs]
    counted = [change[0] for change in scenario.analog]
    planned = [fault.time_s for fault in scenario.faults]
    acts = [act.time_s for act in scenario.operator]
    for when in (times, counted, planned, acts):
        require(all(0.0 <= time_s <= LATEST_S for time_s in when), "a time is out of range")
        require(all(a <= b for a, b in pairwise(when)), "what happens is not in order")
    signals = [change[1] for change in scenario.inputs]
    signals += [sensor.signal for sensor in scenario.sensors]
    signals += [fault.signal for fault in scenario.faults if fault.signal]
    require(all(signal in INPUTS for signal in signals), "an input does not exist")
    known = all(change[1] in ANALOG_INPUTS for change in scenario.analog)
    require(known, "an analog input does not exist")
    counts = all(LEAST_COUNT <= change[2] <= MOST_COUNT for change in scenario.analog)
    require(counts, "an analog input is out of range")
