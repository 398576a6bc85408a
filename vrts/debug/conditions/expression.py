"""One expression at many instants: compiled once, and worked out from histories where they tell.

The engine's own closures give the values: of recorded variables, signals, arm, hand, and all that
was noted of the machine, at many instants at once where columns do. What no history tells is asked
of the controller, on a fork.
"""

import re
from collections.abc import Sequence
from typing import cast

import numpy as np

from vrts.base.pose import Pose
from vrts.debug.conditions.block import Block, Histories, Moments
from vrts.debug.conditions.columns import Bools, Reals
from vrts.debug.conditions.compiled import Compiled, made, unreadable
from vrts.debug.conditions.functions import Functions
from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.conditions.names import Kind, Names, content_of, kind_of
from vrts.debug.conditions.past import Past
from vrts.debug.conditions.tracks import Tracks
from vrts.debug.evaluating import CannotTell, evaluate, read
from vrts.debug.frames import seen_by
from vrts.debug.passages import Instant
from vrts.engine.code.values.arithmetic import checked_string
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Content
from vrts.engine.memory.trace import Activation
from vrts.engine.programs.context import Context
from vrts.engine.run import Run
from vrts.ir.values import Type, Value
from vrts.lang.dialect import Dialect
from vrts.lang.names import key

_WORD = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_WHOLE = re.compile(r"(?P<name>[$#]?[a-z][\w.]*)(\[(?P<inside>\d{1,5}(,\d{1,5})*)\])?", re.ASCII)
NEAR = 1e-6  # of a tick: nearer to it an instant is on it
_KEPT = 200_000  # answers of the controller that are remembered, of one expression


class Asked:
    """Who asks: an instant, the program that is being executed then, and whose it is."""

    __slots__ = ("activation", "at", "process")

    def __init__(self, at: Instant, activation: Activation | None, *, process: bool) -> None:
        """Take all three."""
        self.at, self.activation, self.process = at, activation, process

    @property
    def place(self) -> tuple[Instant, int, bool]:
        """What answers are remembered by."""
        return self.at, id(self.activation), self.process


class Expression:
    """One text, asked at instants of one run in any order."""

    def __init__(self, shared: "Expressions", text: str) -> None:
        """Compile nothing before it is asked for."""
        self._run, self._dialect, self._text = shared.run, shared.dialect, text.strip()
        self._shared, self._past = shared, Past(shared.run, lambda: shared.tracks)
        self._histories, self._functions = shared.histories, Functions(self._past)
        words = tuple(dict.fromkeys(key(word) for word in _WORD.findall(self._text)))
        self._names = Names(shared.run, shared.histories, words)
        self._whole = _WHOLE.fullmatch(self._text.replace(" ", "").lower())
        self._compiled: dict[tuple[Kind, ...], Compiled] = {}
        self._seen: dict[tuple[Instant, int, bool], Value | CannotTell] = {}
        self.forks = 0  # how often the controller was asked on a fork

    def value(
        self, at: Instant, activation: Activation | None, hear: Hear, *, process: bool = False
    ) -> Value:
        """Return the value at an instant, for a program that is being executed then.

        Args:
            at: The instant.
            activation: The program that asks, and sees its own variables.
            hear: Who is heard meanwhile.
            process: It was called, maybe indirectly, by the process control program.

        Raises:
            CannotTell: It cannot be read, or has no value then.
            Interrupted: `hear` has heard somebody.
        """
        self._shared.hear = hear
        sources = self._names.at(activation)
        whole = self._at_once(sources, at.finished)
        if whole is not UNDEFINED:
            return cast("Value", whole)
        finished = at.finished
        found = [content_of(source, finished) for source in sources]
        kinds = tuple([kind_of(content) for content in found])
        known = self._compiled.get(kinds)
        if known is None:
            known = self._known(kinds, Asked(at, activation, process=process), sources)
        if known.problem:
            raise CannotTell(known.problem)
        if known.evaluate is None or (known.at_ticks and not self._on_tick(at.time_s)):
            return self._forked(Asked(at, activation, process=process), hear)
        self._past.stand(at.time_s, finished, known.memory, process=process)
        value = self._worked_out(known, sources, found, cast("Context", self._past))
        if value is None:
            return self._forked(Asked(at, activation, process=process), hear)
        return value

    def reals(
        self,
        instants: Sequence[Instant],
        activations: Sequence[Activation | None],
        processes: Sequence[bool],
        hear: Hear,
    ) -> tuple[Reals, Bools]:
        """Return its reals at many instants, and where they are sure: ask the others alone.

        Args:
            instants: When it is asked.
            activations: The program that asks, beside each.
            processes: Whether it is that of the process control program, beside each.
            hear: Who is heard meanwhile.

        Raises:
            Interrupted: `hear` has heard somebody.
        """
        self._shared.hear = hear
        count = len(instants)
        reals, sure = np.zeros(count), np.zeros(count, bool)
        moments = Moments(
            np.array([at.time_s for at in instants], np.float64),
            np.array([at.finished for at in instants], np.int64),
            np.array(processes, bool),
        )
        asked = [
            Asked(at, activation, process=process)
            for at, activation, process in zip(instants, activations, processes, strict=True)
        ]
        programs: dict[int, list[int]] = {}
        for k, activation in enumerate(activations):
            programs.setdefault(-1 if activation is None else activation.program, []).append(k)
        for places in programs.values():
            here = np.array(places, np.intp)
            sources = self._names.at_all([activations[k] for k in places])
            block = Block(moments.some(here), sources, self._histories, hear)
            for kinds, lanes in self._names.by_kinds(block):
                first = asked[places[int(lanes[0])]]
                known = self._known(kinds, first, self._names.at(first.activation))
                if known.at_once is not None:
                    part = block.some(lanes)
                    if known.at_ticks:
                        ticks = part.times / self._run.history.tick_s
                        part.mark(np.abs(ticks - np.round(ticks)) >= NEAR)
                    with np.errstate(all="ignore"):
                        reals[here[lanes]] = known.at_once(part)
                    sure[here[lanes]] = ~part.unsure
        return reals, sure

    def _at_once(self, sources: Sequence[Bound | None], finished: int) -> Content:
        """Return the value of what is only a name."""
        if self._whole is None:
            return UNDEFINED
        source, inside = sources[0], self._whole["inside"]
        if isinstance(source, Array) and inside:
            element = source.elements.get(tuple(map(int, inside.split(","))))
            return UNDEFINED if element is None else element.at(finished)
        return source.at(finished) if isinstance(source, Cell) and not inside else UNDEFINED

    # --- one instant --------------------------------------------------------------------------

    def _on_tick(self, time_s: float) -> bool:
        ticks = time_s / self._run.history.tick_s
        return abs(ticks - round(ticks)) < NEAR

    def _known(
        self, kinds: tuple[Kind, ...], asked: Asked, sources: Sequence[Bound | None]
    ) -> Compiled:
        """Return the text compiled for what its names stand for at an instant."""
        known = self._compiled.get(kinds)
        if known is not None:
            return known
        at = asked.at
        variables = self._run.at_moment(at.time_s, at.finished).variables
        try:
            seen = seen_by(self._run, at, asked.activation)
            _, module = read(self._text, variables, seen, self._dialect)
        except CannotTell as problem:
            known = unreadable(str(problem))
        else:
            known = made(
                module, self._names.names, sources, at.finished, self._past, self._functions
            )
        self._compiled[kinds] = known
        return known

    def _worked_out(
        self,
        known: Compiled,
        sources: Sequence[Bound | None],
        found: Sequence[object],
        context: Context,
    ) -> Value | None:
        """Return the value; None where the controller itself is to be asked.

        Raises:
            CannotTell: It has no value.
        """
        for k, cell in known.cells:
            cell.value = found[k]  # type: ignore[assignment]
        for k, elements in known.arrays:
            elements.stand_for(sources[k].elements)  # type: ignore[union-attr]
        try:
            value = known.evaluate(context)  # type: ignore[misc]
            if value.__class__ is float:
                return value
            if isinstance(value, str):
                return checked_string(value, None)
        except RuntimeFault as fault:
            raise CannotTell(fault.headline) from fault
        finally:
            if known.swaps:
                known.forget()
        if known.wanted is Type.JOINTS and isinstance(value, Pose):
            return None
        if known.wanted is Type.POSE and not isinstance(value, Pose):
            return None
        return value

    # --- what no history tells ----------------------------------------------------------------

    def _forked(self, asked: Asked, hear: Hear) -> Value:
        """Ask the controller itself, unless it is known; what it has said is remembered."""
        known = self._seen.get(asked.place)
        if known is None:
            hear()
            self.forks += 1
            seen = seen_by(self._run, asked.at, asked.activation)
            try:
                known = evaluate(self._run, asked.at, self._text, self._dialect, seen)
            except CannotTell as problem:
                known = problem
            if len(self._seen) < _KEPT:
                self._seen[asked.place] = known
        if isinstance(known, CannotTell):
            raise CannotTell(str(known))
        return known


class Expressions:
    """All expressions that somebody asks of one run."""

    def __init__(self, run: Run, dialect: Dialect) -> None:
        """Take a run; nothing is worked out before it is asked for."""
        self.run, self.dialect = run, dialect
        self.histories = Histories()
        self._tracks: Tracks | None = None
        self.hear: Hear = nobody  # whoever asked last
        self._known: dict[str, Expression] = {}

    @property
    def tracks(self) -> Tracks:
        """All changes of signals and switches."""
        if self._tracks is None:
            self._tracks = Tracks(self.run, self.hear)
        return self._tracks

    def of(self, text: str) -> Expression:
        """Return an expression of this run."""
        if text not in self._known:
            self._known[text] = Expression(self, text)
        return self._known[text]
