"""Contacts and limits of motion that many futures share: each stretch of it is certified once.

Whoever explores futures makes one `Certifier`, and keeps a `Memory` beside each machine, a value
that futures share when a machine is forked; `Memory()` at the beginning. After every `tick` that
returned None, and after `command` or another `next_tick` where that is given then:

    memory = certifier.follow(memory, machine, happened(machine), number)

`memory.state(machine)` goes into the key of the state. Where a future ends, and nothing is to
follow, `certifier.finish(memory, machine, number)` looks at what still moves. Where it ends and a
command comes, the very next tick has to be run: `next_tick` is `last_tick + 1`. Now and then, and
at the end, `certify()` tells what touches, with the number of the first future that came through
it: a contact that others come through later is not told again.

A touch with `unless` is a contact only if what it hopes for does not come about. That lies in the
future. So it is told of every future that came through it, before or after it was certified, and
for each of them whoever explores goes on, from the tick with that number, through all states that
follow. On each way the first of `Memory.outcomes`, of that tick or later, with a time not before
that of the touch, for which `Outcome.settles(unless)` is not None decides: True, it is excused on
that way; False, it is a contact. Where the way ends before that, or comes round for ever, it is a
contact too. A state that was merged goes on as the one it was merged with: outcomes belong to the
ticks between states. A full replay confirms what was found. What is deeper than 1.2 mm is told
without `unless` as well, so all this is about what presses lightly on what it may come to stand on
or be held by.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeAlias

from vrts.check.collision.pairs.pairs import PAD_DEPTH
from vrts.engine.futures.future import KEPT_S, happened
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.tick import settle
from vrts.engine.memory.events import Event
from vrts.engine.memory.records import INSTANT
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposer
from vrts.prove.certify.laying import Entry, Hit
from vrts.prove.certify.looking import Looked, New, looked_at, unless_of
from vrts.prove.certify.memory import Grips, LettingGo, Memory, Span, grips, stood_on
from vrts.prove.certify.parting import Parting
from vrts.prove.certify.seen import Seen
from vrts.prove.certify.situation import Part
from vrts.prove.certify.situations import Situation, Situations
from vrts.prove.certify.stretches import Stretch, Way, Ways, stretches
from vrts.prove.certify.touching import Beyond, Touching, Unless
from vrts.scene.model import Scene

_Kind: TypeAlias = tuple[Way, Part]


class _Came(NamedTuple):
    """A future that came along a stretch on which what touches may be excused later."""

    way: Way
    parts: tuple[Part, ...]
    stretch: Stretch
    future: int


class Certifier:
    """Certifies the motion of futures."""

    def __init__(
        self, scene: Scene, *, pads: float = PAD_DEPTH, proposer: Proposer | None = None
    ) -> None:
        """Know nothing.

        Args:
            scene: What stands where; its robot moves.
            pads: How far a pad may press into what it grasps before that is a contact [m].
            proposer: Helps to prove distances; no answer depends on it. None: the best there is.
        """
        self.motion_s = 0.0  # certified, or waiting for it [s]
        self.waiting_s = 0.0  # of that what waits [s]
        self._scene, self._pads = scene, pads
        self._proposer = here() if proposer is None else proposer
        self._parting = Parting(scene, self._proposer)
        self._ways = Ways()
        self._seen = Seen()
        self._situations = Situations(scene)
        self._entries: list[Entry] = []
        self._came: list[_Came] = []
        self._hopes: dict[_Kind, list[Hit]] = {}
        self._open: set[Way] = set()  # ways on which something is not certified
        self._hoped: set[Way] = set()  # and on which something touches that may be excused
        self._away: list[_Came] = []  # of motions that were taken to be looked at
        self._open_away: set[Way] = set()
        self._told: set[tuple[object, ...]] = set()

    def follow(
        self, memory: Memory, machine: Machine, events: Iterable[Event], future: int
    ) -> Memory:
        """Note how a machine has moved since the last tick, and up to the last one that it skips.

        Args:
            memory: What was remembered after the last tick; `Memory()` before the first one.
            machine: A machine at the end of a tick.
            events: All that has happened in it.
            future: A number for this future in this tick, or for several ticks on end.

        Returns:
            What is remembered now.

        Raises:
            ValueError: Another tick came than was to come at the last call.
        """
        if not memory.seen_s - INSTANT <= machine.now <= memory.seen_s + KEPT_S - INSTANT:
            raise ValueError("another tick came than was to come: change that before `follow`")
        goes_on = machine.robot.running or machine.next_command_s is not None
        until_s = max(machine.now, (machine.next_tick - 1) * machine.tick if goes_on else 0.0)
        return self._noted(memory, machine, events, (memory.seen_s, until_s), future)

    def finish(self, memory: Memory, machine: Machine, future: int) -> Memory:
        """Note what still moves when no tick is to follow; the machine is left as it is."""
        hand = machine.system.hand
        strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
        landings = [track[-1].start_s for track in hand.placements.values()]
        ended_s = machine.ended_s if machine.ended_s is not None else machine.now
        end_s = max([machine.now, ended_s, *strokes, *landings])
        other = machine.copy()
        settle(other, end_s)
        return self._noted(memory, other, happened(other), (memory.seen_s, end_s), future)

    def certify(self) -> tuple[list[Touching], list[Beyond]]:
        """Return what touches in the motions that are new, and joints beyond their limits.

        Both in the order in which futures came, and then of time.
        """
        new = self.take()
        return self.certified(new, looked_at(new))

    def take(self) -> New:
        """Return the motions that are new. They are to be looked at, and given back before more."""
        entries, self._entries = self._entries, []
        self._away, self._came = self._came, []
        self._open_away, self._open = self._open, set[Way]()
        self.waiting_s = 0.0
        return New(self._scene, entries, self._proposer, self._pads)

    def certified(self, new: New, looked: Looked) -> tuple[list[Touching], list[Beyond]]:
        """Return what `certify` does, of motions that were taken and looked at."""
        touching = self._certain(new.entries, looked.hits)
        for came in self._away:
            touching += self._hoping(came)
        self._away, self._open_away = [], set()
        found = sorted(touching, key=_order)
        return self._news(found), sorted(looked.beyond)

    # --- what moves ---------------------------------------------------------------------------

    def _noted(
        self,
        memory: Memory,
        machine: Machine,
        events: Iterable[Event],
        span: Span,
        future: int,
    ) -> Memory:
        did = grips(memory, machine, events, span)
        letting_go = self._moved(machine, did, span, future)
        in_hand = stood_on(memory, machine, span[1])
        return Memory(
            *(span[1], did.closing, did.holds, in_hand, letting_go, did.coming, did.outcomes)
        )

    def _moved(
        self, machine: Machine, did: Grips, span: Span, future: int
    ) -> tuple[LettingGo, ...]:
        """Note what moves between two times; return which fingers are not free then."""
        letting_go = tuple([self._parting.until(machine, one, *span) for one in did.letting_go])
        did = did._replace(letting_go=letting_go)
        for situation, from_s, to_s in self._situations.between(machine, did, span):
            for stretch in stretches(
                *(machine, self._ways, from_s, to_s), falling_from_s=situation.falls_from_s
            ):
                self._note(situation, stretch, future)
        return tuple([one for one in letting_go if one.until_s > span[1]])

    def _note(self, situation: Situation, stretch: Stretch, future: int) -> None:
        """Keep what is new of a stretch."""
        number, parts = self._situations.of(situation, stretch)
        if stretch.hand_moves:
            new = self._add(stretch, 3 * number, parts + situation.in_hand, future)
        else:
            new = self._add(stretch, 3 * number + 1, parts, future)
            if situation.in_hand:
                self._add(stretch.at_once, 3 * number + 2, situation.in_hand, future)
        if situation.hopes:
            if new:
                self._open.add(stretch.way)
            if self._is_open(stretch.way):
                self._came.append(_Came(stretch.way, parts, stretch, future))

    def _is_open(self, way: Way) -> bool:
        """Return whether something that touches on a way may be excused, as far as is known."""
        return way in self._open or way in self._open_away or way in self._hoped

    def _add(self, stretch: Stretch, number: int, parts: tuple[Part, ...], future: int) -> bool:
        """Keep what is new of parts along a stretch; return whether anything is."""
        span = (stretch.from_s, stretch.to_s)
        new = self._seen.added(stretch.way, number, parts, span)
        for (from_s, to_s), some in new:
            self._entries.append(Entry(stretch.part(from_s, to_s), some, future))
            self.waiting_s += to_s - from_s
            self.motion_s += to_s - from_s
        return bool(new)

    # --- what touches -------------------------------------------------------------------------

    def _certain(self, entries: Sequence[Entry], hits: Sequence[Hit]) -> list[Touching]:
        """Return what touches whatever follows; keep the rest."""
        found: list[Touching] = []
        for hit in hits:
            stretch, _, future = entries[hit.entry]
            if hit.part is None:
                found.append(_touching(hit, future, stretch.time(hit.s), None))
            else:
                kind = (stretch.way, hit.part)
                self._hopes.setdefault(kind, []).append(hit)
                self._hoped.add(stretch.way)
        return found

    def _hoping(self, came: _Came) -> list[Touching]:
        """Return what touches where a future came along, unless something follows."""
        stretch = came.stretch
        found: list[Touching] = []
        hoping = [(came.way, part) for part in came.parts if part.hopes]
        for hit in [hit for kind in hoping for hit in self._hopes.get(kind, ())]:
            low, high = max(hit.from_s, stretch.from_s), min(hit.to_s, stretch.to_s)
            if high >= low:
                s = min(max(hit.s, low), high)
                found.append(_touching(hit, came.future, stretch.time(s), unless_of(hit)))
        return found

    def _news(self, found: Sequence[Touching]) -> list[Touching]:
        """Return the first touch of each kind of each future; all that may be excused later."""
        news: list[Touching] = []
        for one in found:
            hopes = () if one.unless is None else (one.unless, one.time_s)
            kind = (one.future, one.first, one.second, one.certain, hopes)
            if kind not in self._told:
                self._told.add(kind)
                news.append(one)
        return news


def _touching(hit: Hit, future: int, time_s: float, unless: Unless | None) -> Touching:
    first, second = hit.group[:2]
    return Touching(future, time_s, first, second, hit.parts, -hit.distance, hit.certain, unless)


def _order(one: Touching) -> tuple[object, ...]:
    unless = one.unless
    hope = () if unless is None else (unless.hope.value, unless.body, unless.on or "")
    return (one.future, one.time_s, one.first, one.second, one.parts, not one.certain, hope)
