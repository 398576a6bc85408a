"""Carries out what was read, as far as where motions lead: control flow, variables, frames."""

import math
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np

from tests.oracle.robot_texts.expressions import Node, NotTaken
from tests.oracle.robot_texts.frames import Frame, shift, turn, zyz
from tests.oracle.robot_texts.reading import Line, read

Joints = tuple[float, ...]
Place = Joints | Frame
Forward = Callable[[tuple[float, ...]], Frame]  # from joints [deg] to the flange [mm]
OPENERS, STEPS = ("IF", "WHILE", "FOR", "CASE", "DO"), 100_000
LINEAR = {"LMOVE", "MOVES", "LAPPRO", "APPROS", "LDEPART", "DEPARTS", "DRAW", "MOVEST", "TDRAW"}
JOINT = {"JMOVE", "MOVE", "JAPPRO", "APPRO", "JDEPART", "DEPART", "DRIVE", "MOVET", "READY"}


class Ended(Exception):  # noqa: N818 -- names the situation
    """HALT or STOP."""


def targets(
    text: str, language: str, entry: str, forward: Forward, on: Callable[[int], bool]
) -> list[tuple[str, Frame]]:
    """Return word and pose of the flange in the robot's own base, for each motion."""
    machine = _Machine(text, language, forward, on)
    with suppress(Ended):
        machine.call(entry, [])
    return machine.moved


class _Machine:
    def __init__(
        self, text: str, language: str, forward: Forward, on: Callable[[int], bool]
    ) -> None:
        self.language, self.forward, self.on = language, forward, on
        found = read(text, language)
        self.programs = found.programs
        self.globals: dict[Any, Any] = {
            (name, at): self._datum(name, value) for (name, at), value in found.data.items()
        }
        self.locals: list[dict[Any, Any]] = []
        self.names: list[set[str]] = []
        self.tool, self.base = np.eye(4), np.eye(4)  # of no controller: the text has to set it
        self.at: Place = np.eye(4)  # joints, or the flange in the robot's own base
        self.moved: list[tuple[str, Frame]] = []
        self.steps = 0
        self.out: dict[int, bool] = {}  # signals that the program has set

    def _datum(self, name: str, value: Any) -> Any:
        given: Any = value
        return zyz(*given) if isinstance(value, tuple) and name[0] != "#" else given

    # --- programs ------------------------------------------------------------------------------

    def call(self, name: str, given: list[Any]) -> None:
        formals, lines = self.programs[name]
        cells = {formal[1]: value for formal, value in zip(formals, given, strict=True)}
        self.locals.append(cells)
        own = {s for line in lines if line.word == "AUTO" for _, s, _ in line.given[0]}
        self.names.append(own | cells.keys())
        stack: list[Any] = []
        at = 0
        while at < len(lines):
            self.steps += 1
            if self.steps > STEPS:
                raise NotTaken("the program does not end")
            following = self._step(lines, at, stack)
            if following is None:
                break
            at = following
        self.locals.pop()
        self.names.pop()

    def _step(self, lines: list[Line], at: int, stack: list[Any]) -> int | None:
        word, given = lines[at].word, lines[at].given
        match word:
            case "IF" if len(given) == 2:
                if self.value(given[0]) != 0:
                    return self._label(lines, given[1])
            case "GOTO":
                if given[1] is None or self.value(given[1]) != 0:
                    return self._label(lines, given[0])
            case "IF":
                if self.value(given[0]) == 0:
                    return self._partner(lines, at, ("ELSE", "END")) + 1
            case "ELSE":
                return self._partner(lines, at, ("END",)) + 1
            case "WHILE":
                if self.value(given[0]) == 0:
                    return self._partner(lines, at, ("END",)) + 1
            case "UNTIL":
                if self.value(given[0]) == 0:
                    return self._opener(lines, at) + 1
            case "FOR":
                last, by = self.value(given[2]), self.value(given[3])
                self.assign(given[0], self.value(given[1]))
                stack.append((at, last, by))
                return self._looped(lines, at, stack)
            case "CASE":
                chosen = self.value(given[0])
                k = at
                while True:
                    k = self._partner(lines, k, ("VALUE", "ANY", "END"))
                    if lines[k].word != "VALUE":
                        return k + 1
                    if any(self.value(v) == chosen for v in lines[k].given):
                        return k + 1
            case "VALUE" | "ANY":
                return self._partner(lines, at, ("END",)) + 1
            case "END":
                opener = self._opener(lines, at)
                if lines[opener].word == "WHILE":
                    return opener
                if lines[opener].word == "FOR":
                    while stack[-1][0] != opener:
                        stack.pop()
                    variable = lines[opener].given[0]
                    self.assign(variable, self.value(variable) + stack[-1][2])
                    return self._looped(lines, opener, stack)
            case "RETURN":
                return None
            case "HALT" | "STOP":
                raise Ended
            case _:
                self._do(lines[at])
        return at + 1

    def _looped(self, lines: list[Line], at: int, stack: list[Any]) -> int:
        now, (_, last, by) = self.value(lines[at].given[0]), stack[-1]
        if (now > last) if by > 0 else (now < last):
            stack.pop()
            return self._partner(lines, at, ("END",)) + 1
        return at + 1

    def _partner(self, lines: list[Line], at: int, wanted: tuple[str, ...]) -> int:
        depth = 0
        for k in range(at + 1, len(lines)):
            word = lines[k].word
            if depth == 0 and word in wanted:
                return k
            if word in OPENERS and not (word == "IF" and len(lines[k].given) == 2):
                depth += 1
            elif word in ("END", "UNTIL"):
                depth -= 1
        raise NotTaken(f"line {lines[at].number}: no partner of {lines[at].word}")

    def _opener(self, lines: list[Line], at: int) -> int:
        depth = 0
        for k in range(at - 1, -1, -1):
            word = lines[k].word
            if word in ("END", "UNTIL"):
                depth += 1
            elif word in OPENERS and not (word == "IF" and len(lines[k].given) == 2):
                if depth == 0:
                    return k
                depth -= 1
        raise NotTaken(f"line {lines[at].number}: nothing is open")

    def _label(self, lines: list[Line], label: str) -> int:
        return next(k for k, line in enumerate(lines) if line.label == label)

    # --- steps ---------------------------------------------------------------------------------

    def _do(self, line: Line) -> None:
        word, given = line.word, line.given
        match word:
            case "=" | "POINT" | "SET":
                self.assign(given[0], self.value(given[1]))
            case "HERE":
                joints = given[0][1].lstrip(".")[0] == "#"
                self.assign(given[0], self.at if joints else self.here())
            case "TOOL":
                self.tool = self.value(given[0]) if given else np.eye(4)
            case "BASE" if self.language == "as":
                self.base = self.value(given[0])
            case "BASE":
                x, y, z, angle = (*map(self._or_zero, given), 0.0, 0.0, 0.0, 0.0)[:4]
                self.base = np.linalg.inv(shift(x, y, z) @ turn("z", angle))
            case "CALL":
                passed = [self._passed(item) for item in given[1]]
                self.call(given[0], passed)
            case "SIGNAL":
                for number in (self.value(item) for item in given if item is not None):
                    self.out[round(abs(number))] = number > 0
            case "RESET":
                self.out = dict.fromkeys(self.out, False)
            case "BITS":
                first, *more, value = (self.value(item) for item in given)
                for k in range(round(more[0]) if more else 1):
                    self.out[round(first) + k] = bool(round(value) >> k & 1)
            case _ if word in LINEAR | JOINT:
                self._moves(word, given)
            case _:
                pass

    def _or_zero(self, node: Node | None) -> float:
        return 0.0 if node is None else self.value(node)

    def _passed(self, node: Node) -> Any:
        return self.cell(node) if node[0] == "variable" else [self.value(node)]

    def _moves(self, word: str, given: tuple[Any, ...]) -> None:
        if word == "DRIVE":
            if not isinstance(self.at, tuple):
                raise NotTaken("DRIVE from where no joints are known")
            joints = list(self.at)
            joints[round(self.value(given[0])) - 1] += self.value(given[1])
            goal: Place = tuple(joints)
        elif "DEPART" in word:
            goal = self.here() @ shift(0, 0, -self.value(given[0]))
        elif word == "DRAW":
            x, y, z = (*map(self._or_zero, given), 0.0, 0.0, 0.0)[:3]
            goal = shift(x, y, z) @ self.here()
        else:
            goal = self.value(given[0])
            if "APPRO" in word:
                goal = self.pose(goal) @ shift(0, 0, -self.value(given[1]))
        if isinstance(goal, tuple):
            self.at = goal
        else:
            self.at = self.base @ goal @ np.linalg.inv(self.tool)
        flange = self.forward(self.at) if isinstance(self.at, tuple) else self.at
        self.moved.append((word, flange))

    def here(self) -> Frame:
        """Return where the tool is, under BASE."""
        return self.pose(self.at) if isinstance(self.at, tuple) else self._under(self.at)

    def pose(self, place: Place) -> Frame:
        return self._under(self.forward(place)) if isinstance(place, tuple) else place

    def _under(self, flange: Frame) -> Frame:
        return np.linalg.inv(self.base) @ flange @ self.tool

    # --- values --------------------------------------------------------------------------------

    def cell(self, node: Node) -> list[Any]:
        """Return a cell that holds a variable, so that a program may change its caller's."""
        name = node[1]
        at = tuple(round(self.value(s)) for s in node[2])
        if self.language == "as" and name.startswith("."):
            return self.locals[-1].setdefault((name, at) if at else name, [None])
        if self.language == "vplus" and name in self.names[-1]:
            return self.locals[-1].setdefault((name, at) if at else name, [None])
        found = self.globals.setdefault((name, at), [None])
        if not isinstance(found, list):
            self.globals[name, at] = [found]
        return self.globals[name, at]

    def assign(self, node: Node, value: Any) -> None:
        self.cell(node)[0] = value

    def value(self, node: Node) -> Any:
        kind = node[0]
        if kind in ("number", "string"):
            return node[1]
        if kind == "variable":
            found = self.cell(node)[0]
            if found is None:
                raise NotTaken(f"`{node[1]}` has no value")
            return found
        if kind == "SIG":
            return -float(all(self._signal(self.value(s)) for s in node[1:]))
        if kind == "HERE":
            return self.here()
        if kind in ("TOOL", "BASE", "NULL"):
            return {"TOOL": self.tool, "BASE": self.base, "NULL": np.eye(4)}[kind]
        if kind == "DEST":
            return self.here()
        return self._worked_out(kind, [self.value(n) if n is not None else 0.0 for n in node[1:]])

    def _signal(self, number: float) -> bool:
        signal = round(abs(number))
        on = self.out[signal] if signal in self.out else self.on(signal)
        return on == (number > 0)

    def _worked_out(self, kind: str, v: list[Any]) -> Any:
        located = hasattr(v[0], "shape")
        if located and kind in ("+", "-", ":", "- before", "INVERSE"):
            return _joined(kind, v)
        padded: list[Any] = [*v, *(0.0 for _ in range(6))][:6]
        match kind:
            case "TRANS":
                return zyz(*padded)
            case "#PPOINT":
                return tuple(padded)
            case "SHIFT":
                return shift(*padded[1:4]) @ self.pose(v[0])
            case "DX" | "DY" | "DZ":
                return float(self.pose(v[0])["XYZ".index(kind[1]), 3])
            case "DISTANCE":
                return float(np.linalg.norm(v[0][:3, 3] - v[1][:3, 3]))
            case "RX" | "RY" | "RZ":
                return turn(kind[1].lower(), padded[0])
            case "BITS":
                first, count = round(v[0]), round(v[1]) if len(v) > 1 else 1
                return float(sum(2**k for k in range(count) if self._signal(first + k)))
            case "MAX" | "MAXVAL":
                return max(v)
            case "MIN" | "MINVAL":
                return min(v)
            case _ if kind in _PAIRS:
                return _PAIRS[kind](v[0], v[1])
            case _ if kind in _SINGLE:
                return _SINGLE[kind](v[0])
            case _:
                pass
        raise NotTaken(f"{kind} is not worked out by this reader")


def _joined(kind: str, v: list[Frame]) -> Frame:
    """Return a compound of locations, or an inverse."""
    if kind in ("- before", "INVERSE"):
        return np.asarray(np.linalg.inv(v[0]), np.float64)
    return v[0] @ (np.linalg.inv(v[1]) if kind == "-" else v[1])


def _true(value: bool) -> float:
    return -1.0 if value else 0.0


_PAIRS: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "^": lambda a, b: a**b,
    "**": lambda a, b: a**b,
    "MOD": math.fmod,
    "==": lambda a, b: _true(a == b),
    "<>": lambda a, b: _true(a != b),
    "<": lambda a, b: _true(a < b),
    ">": lambda a, b: _true(a > b),
    "<=": lambda a, b: _true(a <= b),
    ">=": lambda a, b: _true(a >= b),
    "AND": lambda a, b: _true(a != 0 and b != 0),
    "OR": lambda a, b: _true(a != 0 or b != 0),
    "XOR": lambda a, b: _true((a != 0) != (b != 0)),
    "ATAN2": lambda a, b: math.degrees(math.atan2(a, b)),
}
_SINGLE: dict[str, Callable[[float], float]] = {
    "- before": lambda a: -a,
    "NOT before": lambda a: _true(a == 0),
    "ABS": math.fabs,
    "INT": math.trunc,
    "SQRT": math.sqrt,
    "SQR": lambda a: a * a,
    "SIN": lambda a: math.sin(math.radians(a)),
    "COS": lambda a: math.cos(math.radians(a)),
}
