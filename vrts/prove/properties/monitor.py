"""Watches properties tick by tick; what it remembers is a plain state that goes with a future.

An input that nobody has decided in a tick may be either: so it is what would break the property.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from vrts.prove.environment.environment import Property, Quantifier
from vrts.prove.properties.moments import Moment
from vrts.robots.model import Gripper
from vrts.scene.sensors import holds

SLIGHT = 5e-4  # [m] of the opening of a hand that makes no difference


class Due(NamedTuple):
    """Something that has to come about in time."""

    ticks: int  # for how many of them it is due
    assumed: bool  # no program had looked at the input that began it


# of each property with `after`: whether the signal was on, and what is due
Memory: TypeAlias = tuple[tuple[bool | None, Due | None], ...]


class Broken(NamedTuple):
    """A property that does not hold, and what an input would have to be for that."""

    number: int  # of the property
    inputs: tuple[tuple[int, bool], ...]  # at which no program had looked
    began: tuple[int, bool, int] | None = None  # an input, what it would have been, and ticks ago


class Monitor:
    """Watches the properties of an environment."""

    def __init__(self, properties: Sequence[Property], gripper: Gripper, tick_s: float) -> None:
        """Take properties; ticks are so long [s]."""
        self._properties = tuple(properties)
        self._gripper = gripper
        self._tick_s = tick_s
        # conditions that change while no program does anything
        self.moves = any(p.hand or p.region or p.still is not None for p in properties)

    def begin(self) -> Memory:
        """Return what is remembered before the first tick: all signals are off."""
        afters = [one.after for one in self._properties if one.after is not None]
        return tuple((after < 0, None) for after in afters)

    def follow(
        self, memory: Memory, moment: Moment, *, over: bool = False
    ) -> tuple[Memory, Broken | None]:
        """Return what is remembered after a tick, and the first property that it breaks.

        Args:
            memory: What is remembered of the ticks before.
            moment: The tick, once programs have had their turn.
            over: The program is over and the arm stands: only what is due already may break.
        """
        found: Broken | None = None
        kept = list(memory)
        timed = 0
        for number, one in enumerate(self._properties):
            if one.after is None:
                inputs, began = None if over else self._broken(one, moment), None
            else:
                kept[timed], inputs, began = self._late(one, moment, kept[timed], over)
                timed += 1
            if inputs is not None and found is None:
                found = Broken(number, inputs, began)
        return tuple(kept), found

    def _broken(self, one: Property, moment: Moment) -> tuple[tuple[int, bool], ...] | None:
        """Return undecided inputs with which a property is broken now; None: it is not."""
        met = self._state_met(one, moment)
        never = one.quantifier is Quantifier.NEVER
        open_: list[tuple[int, bool]] = []
        for number in one.signals:
            is_on = moment.signal(abs(number))
            wanted = number > 0
            level = wanted if never else not wanted
            if is_on is None:
                open_.append((abs(number), level))
            elif is_on is level and not moment.looked(abs(number)):
                open_.append((abs(number), level))  # the environment leaves nothing else
            elif is_on is not wanted:
                met = False
        if never:
            return tuple(open_) if met else None
        if not met:
            return ()
        return tuple(open_[:1]) or None  # one that is not as wanted is enough

    def _late(
        self, one: Property, moment: Moment, before: tuple[bool | None, Due | None], over: bool
    ) -> tuple[
        tuple[bool | None, Due | None],
        tuple[tuple[int, bool], ...] | None,
        tuple[int, bool, int] | None,
    ]:
        """Return what is remembered, and inputs with which what is due comes too late now.

        The last is the input that began it and its level, with how many ticks ago that was, if
        nobody had decided about it.
        """
        assert one.after is not None
        assert one.within_s is not None
        was, due = before
        said = moment.signal(abs(one.after))
        now = None if said is None else said is (one.after > 0)
        begins = now is not False and was is not True and not over
        if due is None and begins:
            due = Due(0, now is None or not moment.looked(abs(one.after)))
        wrong: tuple[tuple[int, bool], ...] | None = None
        began: tuple[int, bool, int] | None = None
        if due is not None:
            fails = self._broken(one._replace(quantifier=Quantifier.ALWAYS), moment)
            if fails is None:
                due = None
            elif due.ticks * self._tick_s >= one.within_s - 1e-9:
                if due.assumed:
                    began = abs(one.after), one.after > 0, due.ticks
                wrong, due = fails, None
            else:
                due = due._replace(ticks=due.ticks + 1)
        return (now, due), wrong, began

    def _state_met(self, one: Property, moment: Moment) -> bool:
        """Return whether all conditions but those on signals are met."""
        return (
            (one.hand is None or self._hand(one.hand, moment))
            and (one.region is None or holds(one.region, moment.tool))
            and (one.step is None or one.step == moment.step)
            and (one.still is None or one.still is moment.still)
        )

    def _hand(self, wanted: str, moment: Moment) -> bool:
        is_open = moment.opening_m >= self._gripper.opening_max - SLIGHT
        closed = moment.held or moment.opening_m <= self._gripper.opening_min + SLIGHT
        return {
            "open": is_open,
            "closed": closed,
            "not open": not is_open,
            "not closed": not closed,
            "holding": moment.held,
            "empty": not moment.held,
        }[wanted]
