"""A story as a scenario: replayed by the ordinary engine, it comes to the same."""

from collections.abc import Iterable
from dataclasses import replace

from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Decided, What
from vrts.scene.model import Act, Deed, FaultKind, PlannedFault, Scenario

EARLIER = 0.5  # of a tick: what happens in a tick comes so long before it
DIGITS = 6  # of times [s]


def scenario_of(environment: Environment, story: Iterable[Decided], tick_s: float) -> Scenario:
    """Return what a scenario says about a story.

    Args:
        environment: What is the same in every future.
        story: What outside decided, in time order.
        tick_s: How often the controller looks [s].
    """
    base = environment.scenario
    speed = environment.speeds[0]
    inputs, faults, acts = list(base.inputs), list(base.faults), list(base.operator)
    answers, draws, turns = list(base.answers), list(base.draws), list(base.process_first)
    analog = list(base.analog)
    for decided in story:
        time_s = round(max(decided.time_s - EARLIER * tick_s, 0.0), DIGITS)
        match decided.what, decided.value:
            case What.INPUT, bool(on):
                inputs.append((time_s, decided.number, on))
            case What.ANALOG, float(counts):
                analog.append((time_s, decided.number, round(counts)))
            case What.ANSWER, str(text):
                answers.append(text)
            case What.RANDOM, float(drawn):
                draws.append(drawn)
            case What.GRIP, False:
                faults.append(PlannedFault(time_s, FaultKind.PART_MISSING))
            case What.STOP, str(deed):
                acts.append(Act(time_s, Deed(deed)))
            case What.AGAIN, _:
                acts.append(Act(time_s, Deed.EXECUTE, environment.again.parts))
            case What.TURN, _:
                turns.append(time_s)
            case What.SPEED, float(percent):
                speed = percent
            case _:
                raise TypeError(f"{decided.value!r} is no {decided.what.value}")
    return replace(
        base,
        inputs=tuple(sorted(inputs)),
        answers=tuple(answers),
        faults=tuple(sorted(faults, key=_fault)),
        operator=tuple(sorted(acts, key=_act)),
        draws=tuple(draws),
        process_first=tuple(sorted(turns)),
        monitor_speed=speed,
        analog=tuple(sorted(analog)),
    )


def _fault(fault: PlannedFault) -> float:
    return fault.time_s


def _act(act: Act) -> float:
    return act.time_s
