"""Futures that are driven tick by tick through a certifier, beside the runs that they are."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.pairs import PAD_DEPTH, TOLERANCE
from vrts.check.verdict import CollisionReport, ContactEvent
from vrts.engine.futures.future import happened
from vrts.engine.machine.machine import Machine
from vrts.engine.run import Run
from vrts.prove.certify.certifier import Certifier
from vrts.prove.certify.memory import Memory
from vrts.prove.certify.touching import Beyond, Outcome, Touching
from vrts.scene.model import Scene

Names: TypeAlias = frozenset[tuple[str, str]]

ALLOWED = (TOLERANCE, PAD_DEPTH)  # [m]
NEARLY = 2.5e-5  # [m] of depths that may be allowed or not, twice the band
TICK = 0.03  # [s] a little more than one
LATE = 2e-3  # [s] a contact begins between two instants at which it is looked for


class Driven(NamedTuple):
    """What a certifier told of one future."""

    touching: list[Touching]
    beyond: list[Beyond]
    outcomes: list[tuple[int, Outcome]]  # with the number of their tick
    ticks_s: list[float]
    memory: Memory

    def stands(self, one: Touching) -> bool:
        """Return whether a touch is a contact after all that followed."""
        if one.unless is None:
            return True
        for number, outcome in self.outcomes:
            if number >= one.future and outcome.time_s >= one.time_s - 1e-9:
                settled = outcome.settles(one.unless)
                if settled is not None:
                    return not settled
        return True

    @property
    def contacts(self) -> list[Touching]:
        """Return what is a contact, or may be one."""
        return sorted(
            (one for one in self.touching if self.stands(one)), key=lambda one: one.time_s
        )


def driven(certifier: Certifier, ticks: Iterator[Machine], first: int = 0) -> Driven:
    """Drive a future through a certifier; its ticks are numbered from `first` on."""
    memory, number, machine = Memory(), first, None
    outcomes: list[tuple[int, Outcome]] = []
    ticks_s: list[float] = []
    for machine in ticks:
        memory = certifier.follow(memory, machine, happened(machine), number)
        outcomes += [(number, outcome) for outcome in memory.outcomes]
        ticks_s.append(machine.now)
        number += 1
    assert machine is not None
    memory = certifier.finish(memory, machine, number)
    outcomes += [(number, outcome) for outcome in memory.outcomes]
    touching, beyond = certifier.certify()
    return Driven(touching, beyond, outcomes, [*ticks_s, memory.seen_s], memory)


def differences(
    scene: Scene, run: Run, told: Sequence[Touching], known: Names = frozenset()
) -> list[str]:
    """Return in what a certifier and the check of the whole run differ.

    Args:
        scene: Where the run was.
        run: The run.
        told: What was told of it.
        known: Who touches in futures before it: that need not be told again.
    """
    report = check_collisions(scene, run, clearance=False)
    return [*_missed(report, told, known), *_false(report, told)]


def _missed(report: CollisionReport, told: Sequence[Touching], known_names: Names) -> Iterator[str]:
    """Yield contacts that nothing was told of when they begin, if nothing was told before."""
    for names in {(one.first, one.second) for one in report.contacts} - known_names:
        known = min(one.start_s for one in report.contacts if (one.first, one.second) == names)
        own = [one.time_s for one in told if (one.first, one.second) == names]
        if not own or min(own) > known + TICK + LATE:
            yield f"missed: {names} at {known}, told of {own[:3]}"


def _false(report: CollisionReport, told: Sequence[Touching]) -> Iterator[str]:
    """Yield what was told that is none."""
    for one in told:
        if not one.certain:  # what may be none; the check tells it in other events too
            if min(abs(one.depth_m - depth) for depth in ALLOWED) > NEARLY:
                yield f"false: {one}"
            continue
        known = [*report.contacts, *report.undetermined]
        if not any(_within(one, event) for event in known):
            yield f"false: {one}"


def _within(one: Touching, event: ContactEvent) -> bool:
    names = (one.first, one.second) == (event.first, event.second)
    return names and event.start_s - LATE <= one.time_s <= event.end_s + LATE
