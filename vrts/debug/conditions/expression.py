"""One expression at many instants: compiled once, and worked out from histories where they tell.

The truth is what the controller answers on a fork (`debug.evaluating`). The engine's own closures
give the same from recorded values, a thousand times faster; functions that ask for more than is
recorded go to the fork.
"""

import re
from collections.abc import Sequence
from typing import NamedTuple, cast

from vrts.base.pose import Pose
from vrts.debug.conditions.hearing import Hear
from vrts.debug.conditions.past import Elements, Past, Tracks
from vrts.debug.evaluating import CannotTell, evaluate, read
from vrts.debug.frames import seen_by
from vrts.debug.passages import Instant
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.arithmetic import checked_string
from vrts.engine.code.values.evaluate import compiler
from vrts.engine.code.values.functions import PURE
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Content, Memory
from vrts.engine.memory.trace import Activation
from vrts.engine.programs.context import Context
from vrts.engine.run import Run
from vrts.ir.data import Assign
from vrts.ir.expressions import Apply, Function
from vrts.ir.values import Type, Value
from vrts.lang.dialect import Dialect
from vrts.lang.names import key

_WORD = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_WHOLE = re.compile(r"(?P<name>[$#]?[a-z][\w.]*)(\[(?P<inside>\d{1,5}(,\d{1,5})*)\])?", re.ASCII)
_KEPT = 200_000  # answers of forks that are remembered, of one expression
# what changes between two ticks, at which commands come
_MOVES = frozenset(
    {
        *(Function.HERE, Function.HERE_JOINTS, Function.HAND, Function.TIMER),
        *(Function.TIME, Function.TIME_TEXT, Function.DATE_TEXT),
    }
)
_RECORDED = frozenset(PURE) | {
    *_MOVES,
    Function.SWITCH,
    Function.PENDANT,
    Function.ERROR_TEXT,
    Function.SIG,
    Function.BITS,
    Function.DEFINED,
    Function.ENCODE,
    Function.UNPACK,
    Function.LAST,
    Function.BASE,
    Function.TOOL,
}

_Kind = object  # class of a scalar's value, classes of an array's elements, or None


class _Compiled(NamedTuple):
    """An expression made ready, for one kind of what its names stand for."""

    problem: str  # why it cannot be read; empty: it can
    evaluate: Evaluate | None  # None: the controller itself has to be asked
    wanted: Type
    at_ticks: bool  # what it asks for changes between two ticks
    memory: Memory
    cells: Sequence[tuple[int, Cell]]  # scalars, beside their places in the names
    arrays: Sequence[tuple[int, Elements]]


class Expression:
    """One text, asked at instants of one run in any order."""

    def __init__(self, run: Run, tracks: Tracks, text: str, dialect: Dialect) -> None:
        """Compile nothing before it is asked for."""
        self._run, self._dialect, self._text = run, dialect, text.strip()
        self._past = Past(run, tracks)
        self._names = tuple(dict.fromkeys(key(word) for word in _WORD.findall(self._text)))
        bound = {item.name: item for item in run.history.memory.bound}
        self._globals = [bound.get(name) for name in self._names]
        self._slots: dict[int, list[tuple[int, int]]] = {}  # name and slot, by program
        self._whole = _WHOLE.fullmatch(self._text.replace(" ", "").lower())
        self._compiled: dict[tuple[_Kind, ...], _Compiled] = {}
        self._forked: dict[tuple[Instant, int], Value | CannotTell] = {}

    @property
    def forks(self) -> int:
        """How many answers of the controller itself are remembered."""
        return len(self._forked)

    def value(self, at: Instant, activation: Activation | None, hear: Hear) -> Value:
        """Return the value at an instant, for a program that is being executed then.

        Raises:
            CannotTell: It cannot be read, or has no value then.
            Interrupted: `hear` has heard somebody.
        """
        finished = at.finished
        sources = self._sources(activation)
        whole = self._at_once(sources, finished)
        if whole is not UNDEFINED:
            return cast("Value", whole)
        found = [_content(source, finished) for source in sources]
        kinds = tuple([_kind(content) for content in found])
        known = self._compiled.get(kinds)
        if known is None:
            known = self._compiled[kinds] = self._made(at, activation, sources)
        if known.problem:
            raise CannotTell(known.problem)
        if known.evaluate is None or (known.at_ticks and not self._on_tick(at.time_s)):
            return self._asked(at, activation, hear)
        past = self._past
        past.now, past.finished, past.memory = at.time_s, finished, known.memory
        for k, cell in known.cells:
            cell.value = cast("Content", found[k])
        for k, elements in known.arrays:
            elements.stand_for(sources[k].elements)  # type: ignore[union-attr]
        try:
            value = known.evaluate(cast("Context", past))
            if value.__class__ is float:
                return value
            if isinstance(value, str):
                return checked_string(value, None)
        except RuntimeFault as fault:
            raise CannotTell(fault.headline) from fault
        if known.wanted is Type.JOINTS and isinstance(value, Pose):
            return self._asked(at, activation, hear)
        if known.wanted is Type.POSE and not isinstance(value, Pose):
            return self._asked(at, activation, hear)
        return value

    def _on_tick(self, time_s: float) -> bool:
        ticks = time_s / self._run.history.tick_s
        return abs(ticks - round(ticks)) < 1e-6

    def _sources(self, activation: Activation | None) -> Sequence[Bound | None]:
        """Return what the names stand for, beside them: what is local hides what is global."""
        if activation is None:
            return self._globals
        slots = self._slots.get(activation.program)
        if slots is None:
            program = self._run.history.code.programs[activation.program]
            listed = [slot.name for slot in (*program.formals, *program.autos)]
            slots = [
                (k, listed.index(name)) for k, name in enumerate(self._names) if name in listed
            ]
            self._slots[activation.program] = slots
        if not slots:
            return self._globals
        found = list(self._globals)
        for k, slot in slots:
            found[k] = activation.slots[slot]
        return found

    def _at_once(self, sources: Sequence[Bound | None], finished: int) -> Content:
        """Return the value of what is only a name."""
        if self._whole is None:
            return UNDEFINED
        source, inside = sources[0], self._whole["inside"]
        if isinstance(source, Array) and inside:
            element = source.elements.get(tuple(map(int, inside.split(","))))
            return UNDEFINED if element is None else element.at(finished)
        return source.at(finished) if isinstance(source, Cell) and not inside else UNDEFINED

    def _made(
        self, at: Instant, activation: Activation | None, sources: Sequence[Bound | None]
    ) -> _Compiled:
        """Compile the text for what its names stand for at an instant."""
        known = self._run.at_moment(at.time_s, at.finished).variables
        seen = seen_by(self._run, at, activation)
        try:
            _, module = read(self._text, known, seen, self._dialect)
        except CannotTell as problem:
            return _Compiled(str(problem), None, Type.REAL, False, Memory([]), (), ())
        (program,) = module.programs.values()
        step, *others = program.instructions
        asked = set(_functions(step))
        unknown = Function.TIMER in asked and self._past.timers is None
        if len(others) != 1 or not isinstance(step, Assign) or unknown or not asked <= _RECORDED:
            return _Compiled("", None, Type.REAL, False, Memory([]), (), ())
        layout = Layout()
        made = compiler(layout).value(step.value)
        by_name = dict(zip(self._names, enumerate(sources), strict=True))
        bound: list[Bound] = []
        cells: list[tuple[int, Cell]] = []
        arrays: list[tuple[int, Elements]] = []
        for name in layout.names:
            k, source = by_name.get(name, (-1, None))
            item: Bound
            if isinstance(source, Array):
                item = Array(name)
                item.elements = Elements(self._past)
                arrays.append((k, item.elements))
            elif name in layout.arrays and (source is None or source.at(at.finished) is UNDEFINED):
                item = Array(name)
            else:
                item = Cell(name)
                if source is not None:
                    cells.append((k, item))
            bound.append(item)
        wanted = step.place.variable.type
        return _Compiled("", made, wanted, bool(asked & _MOVES), Memory(bound), cells, arrays)

    def _asked(self, at: Instant, activation: Activation | None, hear: Hear) -> Value:
        """Ask the controller itself; what it has said is remembered."""
        place = at, id(activation)
        known = self._forked.get(place)
        if known is None:
            hear()
            seen = seen_by(self._run, at, activation)
            try:
                known = evaluate(self._run, at, self._text, self._dialect, seen)
            except CannotTell as problem:
                known = problem
            if len(self._forked) < _KEPT:
                self._forked[place] = known
        if isinstance(known, CannotTell):
            raise CannotTell(str(known))
        return known


class Expressions:
    """All expressions that somebody asks of one run."""

    def __init__(self, run: Run, dialect: Dialect) -> None:
        """Take a run; nothing is worked out before it is asked for."""
        self._run, self._dialect = run, dialect
        self._tracks: Tracks | None = None
        self._known: dict[str, Expression] = {}

    def of(self, text: str) -> Expression:
        """Return an expression of this run."""
        if self._tracks is None:
            self._tracks = Tracks(self._run)
        if text not in self._known:
            self._known[text] = Expression(self._run, self._tracks, text, self._dialect)
        return self._known[text]


def _content(source: Bound | None, finished: int) -> object:
    """Return the value of a scalar after so many statements, the classes of those of an array."""
    if source.__class__ is Cell:
        return source.at(finished)  # type: ignore[union-attr]
    if source is None:
        return None
    elements = cast("Array", source).elements.values()
    return frozenset(cell.at(finished).__class__ for cell in elements)


def _kind(content: object) -> _Kind:
    """Return what an expression is compiled for."""
    return content if content is None or content.__class__ is frozenset else content.__class__


def _functions(node: object) -> "list[Function]":
    """Return the functions that a step asks."""
    if not isinstance(node, tuple):
        return []
    inner = [function for part in cast("tuple[object, ...]", node) for function in _functions(part)]
    return [node.function, *inner] if isinstance(node, Apply) else inner
