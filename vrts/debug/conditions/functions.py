"""Functions of the language at many instants at once: arm, hand, timers, signals, arithmetic."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TypeAlias, cast

import numpy as np

from vrts.base.oat import LAST_BIT
from vrts.base.pose import IDENTITY, Pose, add
from vrts.base.units import MM, mm
from vrts.debug.conditions.block import Block, reals_of
from vrts.debug.conditions.columns import Bools, Reals, pose_of
from vrts.debug.conditions.machine import Machines
from vrts.debug.conditions.moving import Moving
from vrts.debug.conditions.past import Past
from vrts.debug.conditions.vectors import Columns, NotAtOnce, Poses, logical, real, single
from vrts.engine.code.values.controller_functions import parameter
from vrts.engine.code.values.functions import PURE
from vrts.engine.code.values.operands import expression_of, number_of, parameter_cell
from vrts.engine.code.values.real_expressions import SIGNALS
from vrts.engine.code.values.state_functions import in_range
from vrts.engine.code.values.static_types import static_type
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import Cell
from vrts.engine.programs.context import Context
from vrts.ir.expressions import Apply, Argument, Compose, Constant, Expression, Function, Load
from vrts.ir.ranges import ANALOG_INPUTS
from vrts.ir.values import Type

Names: TypeAlias = Mapping[str, int]
Lanes: TypeAlias = Callable[[Block], Sequence[object]]

_SIMPLE: Mapping[Function, Callable[[Reals], Reals]] = {
    Function.ABS: np.abs,
    Function.INT: lambda a: np.trunc(a) + 0.0,  # which leaves no -0
    Function.ROUND: lambda a: np.where(a >= 0.0, np.floor(a + 0.5), np.ceil(a - 0.5)) + 0.0,
    Function.SIGN: lambda a: np.where(a >= 0.0, 1.0, -1.0),
}
OFTEN = 64  # instants after which somebody is heard again
_COMPONENTS = (Function.DX, Function.DY, Function.DZ)


class Functions:
    """Compiles functions, for one run."""

    def __init__(self, past: Past) -> None:
        """Take what histories of the run say."""
        self._past, self._moving = past, Moving(past.run)

    def real(self, expression: Expression, names: Names) -> Columns:
        """Return a closure for any expression that gives reals; raises `NotAtOnce`."""
        return real(expression, names, self._function)

    def _function(self, expression: Expression, names: Names) -> Columns:
        assert isinstance(expression, Apply)
        function, arguments = expression.function, expression.arguments
        simple = _SIMPLE.get(function)
        if simple is not None:
            inner = self._operand(arguments[0], names)
            return lambda b: simple(inner(b))
        match function:
            case Function.SQR:
                inner = self._operand(arguments[0], names)
                return lambda b: single(b, (value := inner(b)) * value)
            case Function.SQRT:
                inner = self._operand(arguments[0], names)
                return lambda b: _root(b, inner(b))
            case Function.MAX | Function.MIN:
                operands = [self._operand(a, names) for a in arguments]
                return lambda b: _extreme([o(b) for o in operands], most=function is Function.MAX)
            case Function.DISTANCE:
                one, other = (self.pose(expression_of(a), names) for a in arguments)
                return lambda b: _distance(b, one(b), other(b))
            case Function.DX | Function.DY | Function.DZ:
                pose, k = self.pose(expression_of(arguments[0]), names), _COMPONENTS.index(function)
                return lambda b: _component(b, pose(b), k)
            case Function.HAND:
                return self._moving.hand_is_open
            case Function.TIMER:
                return self._timer(self._operand(arguments[0], names))
            case Function.SIG:
                signals = [self._signal(number_of(a)) for a in arguments]
                return lambda b: logical(np.logical_and.reduce([holds(b) for holds in signals]))
            case Function.PARAMETER if len(arguments) == 1:
                return self._parameter(expression)
            case _ if function in PURE and static_type(expression) is Type.REAL:
                return self._each(expression, names)
            case _:
                return self._of_machine(expression, names)

    def _of_machine(self, expression: Apply, names: Names) -> Columns:
        """Return a closure for what was noted of the machine."""
        machines, arguments = self._machines, expression.arguments
        number = number_of(arguments[0]) if arguments else None
        match expression.function:
            case Function.RANDOM if machines.draws_anew:
                return machines.random
            case Function.SPEED if number in (1, 2, 3):
                return lambda b: machines.speed(b, number)
            case Function.STATE if number is not None:
                return lambda b: machines.state(b, number)
            case Function.ADC if number is not None and number in ANALOG_INPUTS:
                return lambda b: machines.analog(b, number)
            case Function.PRIORITY:
                return machines.priority
            case Function.ERROR if not arguments or number is not None:
                return machines.error
            case Function.FREE if number is not None:
                return lambda b: single(b, machines.free(b))
            case Function.STATUS if isinstance(arguments[0], Constant):
                name = str(arguments[0].value).strip().lower()
                return lambda b: machines.status(b, name)
            case Function.INRANGE:
                return self._in_range(expression_of(arguments[0]), names)
            case _:
                raise NotAtOnce

    @cached_property
    def _machines(self) -> Machines:
        if self._past.facts is None:
            raise NotAtOnce
        return Machines(self._past.run, self._past.facts)

    def _in_range(self, location: Expression, names: Names) -> Columns:
        """Return a closure that works out each situation once."""
        machines, pose = self._machines, self.pose(location, names)
        base, tool = self._held("base"), self._held("tool")

        def found(b: Block) -> Reals:
            wanted = pose(b)
            places = [_numbers(b, place) for place in (wanted, base(b), tool(b))]
            state = machines.aims(b).astype(np.float64), machines.turns(b)
            rows = np.array([*state, *(number for place in places for number in place)]).T
            _, first, which = np.unique(rows, axis=0, return_index=True, return_inverse=True)
            poses, times, finished = _listed(b, wanted), b.times.tolist(), b.finished.tolist()
            bits: list[float] = []
            once: list[int] = first.tolist()
            for k in once:
                b.hear()
                if b.unsure[k]:
                    bits.append(0.0)
                    continue
                self._past.now, self._past.finished = times[k], finished[k]
                bits.append(in_range(cast("Context", self._past), poses[k]))
            return np.array(bits)[which.reshape(-1)]

        return found

    def _parameter(self, expression: Apply) -> Columns:
        """Return a closure for a parameter that is one number."""
        named, span, past = expression.arguments[0], expression.span, self._past
        assert isinstance(named, Constant)
        name = str(named.value).upper()
        try:
            wanted = parameter_cell(name, None, span)
        except RuntimeFault:
            raise NotAtOnce from None
        cell = past.run.history.memory.parameters.get(wanted)
        past.now, past.finished = 0.0, -1  # before anything was set
        otherwise = np.float64(parameter(cast("Context", past), name, wanted, span))
        if cell is None:
            return lambda b: np.full(b.count, otherwise)

        def held(b: Block) -> Reals:
            known = b.histories.of(cell)
            values = known.reals[known.places(b.finished)]
            return single(b, np.where(np.isnan(values), otherwise, values))

        return held

    def _operand(self, argument: Argument, names: Names) -> Columns:
        if argument is None:
            raise NotAtOnce
        try:
            return self.real(expression_of(argument), names)
        except ValueError:  # it is no expression
            raise NotAtOnce from None

    # --- places -------------------------------------------------------------------------------

    def pose(self, expression: Expression, names: Names) -> Poses:
        """Return a closure for an expression that gives poses; raises `NotAtOnce`."""
        match expression:
            case Constant(value=Pose() as pose):
                return lambda b: pose
            case Load(place=place) if not place.subscripts and place.variable.type is Type.POSE:
                k = names.get(place.variable.name)
                if k is None:
                    raise NotAtOnce
                return lambda b: b.pose(k)
            case Compose(parts=parts):
                first, *others = (self.pose(part, names) for part in parts)
                return lambda b: _joined(first(b), [other(b) for other in others])
            case Apply(function=Function.HERE):
                base, tool = self._held("base"), self._held("tool")
                return lambda b: base(b) @ (self._moving.flange(b) @ tool(b))
            case Apply(function=Function.DEST):
                base, machines = self._held("base"), self._machines
                return lambda b: base(b) @ machines.dest(b)
            case Apply(function=Function.BASE):
                return self._held("base")
            case Apply(function=Function.TOOL):
                return self._held("tool")
            case Apply(function=Function.NULL):
                return lambda b: IDENTITY
            case Apply(function=Function.INVERSE, arguments=(argument,)):
                inner = self.pose(expression_of(argument), names)
                return lambda b: inner(b).inverse()
            case Apply(function=Function.SHIFT, arguments=(argument, *offsets)) if (
                len(offsets) == 3 and None not in offsets
            ):
                inner = self.pose(expression_of(argument), names)
                by = [self._operand(offset, names) for offset in offsets]
                return lambda b: _shifted(inner(b), [o(b) * MM for o in by])
            case Apply(function=function) if (
                function in PURE and static_type(expression) is Type.POSE
            ):
                lanes = self._lanes(expression, names)
                return lambda b: _columns(b, lanes(b))
            case _:
                raise NotAtOnce

    def _held(self, which: str) -> Poses:
        """Return what BASE or TOOL has set."""
        run = self._past.run
        memory = run.history.memory
        cell = memory.base if which == "base" else memory.tool
        otherwise = IDENTITY if which == "base" else run.scene.X_FT
        if not cell.since:
            return lambda b: otherwise
        return lambda b: _held(b, cell, otherwise)

    # --- timers and signals -------------------------------------------------------------------

    def _timer(self, number: Columns) -> Columns:
        machines, whole = self._machines, _SIMPLE[Function.ROUND]
        return lambda b: single(
            b, b.times - machines.timer(b, np.broadcast_to(whole(number(b)), b.count))
        )

    def _signal(self, number: int | None) -> Callable[[Block], Bools]:
        if number == 0:
            return lambda b: np.ones(b.count, bool)
        if number is None or not any(abs(number) in known for known in SIGNALS):
            raise NotAtOnce
        on, tracks = number > 0, self._past.tracks
        track = tracks.columns(abs(number))
        if track is None:
            return lambda b: np.full(b.count, not on)
        return lambda b: track.states(b.times, b.finished) == on

    # --- all others, one instant after the other ----------------------------------------------

    def _each(self, expression: Apply, names: Names) -> Columns:
        lanes = self._lanes(expression, names)
        return lambda b: np.array(
            [v if v.__class__ is float else 0.0 for v in lanes(b)], np.float64
        )

    def _lanes(self, expression: Apply, names: Names) -> Lanes:
        """Return a closure for a function whose result depends on its arguments only."""
        apply, span = PURE[expression.function], expression.span
        operands = [self._any(argument, names) for argument in expression.arguments]

        def called(b: Block) -> Sequence[object]:
            found: list[object] = [None] * b.count
            rows = [o(b) for o in operands]
            for n, k in enumerate(np.flatnonzero(~b.unsure).tolist()):
                if n % OFTEN == 0:
                    b.hear()
                try:
                    found[k] = apply([row[k] for row in rows], span)  # type: ignore[misc]
                except (RuntimeFault, AssertionError, TypeError, AttributeError):
                    b.unsure[k] = True
            return found

        return called

    def _any(self, argument: Argument, names: Names) -> Lanes:
        """Return a closure that gives an operand at each instant."""
        if argument is None:
            return lambda b: [None] * b.count
        try:
            expression = expression_of(argument)
        except ValueError:
            raise NotAtOnce from None
        known = static_type(expression)
        if known is Type.REAL:
            column = self.real(expression, names)
            return lambda b: reals_of(column(b), b.count).tolist()
        if known is Type.POSE:
            pose = self.pose(expression, names)
            return lambda b: _listed(b, pose(b))
        match expression:
            case Apply(function=Function.HERE_JOINTS):
                return lambda b: list(
                    zip(*(row.tolist() for row in self._moving.all_joints(b)), strict=True)
                )
            case Apply(function=Function.DEST_JOINTS):
                return self._machines.dest_joints
            case Constant(value=value):
                return lambda b: [value] * b.count
            case _:
                raise NotAtOnce


def _root(b: Block, values: Reals) -> Reals:
    b.mark(values < 0.0)
    return single(b, np.sqrt(np.where(values < 0.0, 0.0, values)))


def _extreme(columns: Sequence[Reals], *, most: bool) -> Reals:
    """Return the first of the largest, or of the smallest, as Python's functions do."""
    found = columns[0]
    for column in columns[1:]:
        found = np.where(column > found if most else column < found, column, found)
    return found


def _numbers(b: Block, pose: Pose) -> list[Reals]:
    return [reals_of(number, b.count) for number in (*pose.rotation, *pose.translation)]


def _listed(b: Block, pose: Pose) -> Sequence[Pose]:
    rows = zip(*(column.tolist() for column in _numbers(b, pose)), strict=True)
    return [Pose(row[:9], row[9:]) for row in rows]


def _columns(b: Block, lanes: Sequence[object]) -> Pose:
    rows = [
        (*lane.rotation, *lane.translation) if isinstance(lane, Pose) else (np.nan,) * 12
        for lane in lanes
    ]
    return pose_of(tuple(np.array(rows, np.float64).reshape(b.count, 12).T))


def _joined(first: Pose, others: Sequence[Pose]) -> Pose:
    for other in others:
        first = first @ other
    return first


def _shifted(pose: Pose, offset: Sequence[Reals]) -> Pose:
    return Pose(pose.rotation, add(pose.translation, cast("tuple[float, float, float]", offset)))


def _held(b: Block, cell: Cell, otherwise: Pose) -> Pose:
    at = b.histories.of(cell).places(b.finished)
    usual = (*otherwise.rotation, *otherwise.translation)
    return pose_of(
        tuple(
            [
                np.where(np.isnan(held := column[at]), number, held)
                for column, number in zip(b.histories.poses_of(cell), usual, strict=True)
            ]
        )
    )


def _distance(b: Block, one: Pose, other: Pose) -> Reals:
    points = [
        zip(*(reals_of(c, b.count).tolist() for c in pose.translation), strict=True)
        for pose in (one, other)
    ]
    return single(b, mm(np.array([math.dist(p, q) for p, q in zip(*points, strict=True)])))  # type: ignore[arg-type]


def _component(b: Block, pose: Pose, k: int) -> Reals:
    lengths = [cast("Reals", length) / MM for length in pose.translation]
    least = np.maximum.reduce([np.abs(length) for length in lengths]) * LAST_BIT
    return single(b, np.where(np.abs(lengths[k]) < least, 0.0, lengths[k]))
