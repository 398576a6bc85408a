"""Carries out URScript: def, if, while, return, break, halt, and the functions below.

Arrays, types and what is copied (sections 3 to 8 of the script manual for e-Series, SW 5.11) came
later, from that manual, by somebody who knew what the export writes.
"""

import math
import re
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np

from tests.oracle.urscript.lines import Line, blocks
from tests.oracle.urscript.poses import Matrix, Pose, matrix, pose
from tests.oracle.urscript.values import NotTaken, copied, element, kind_of

TOKEN = re.compile(
    r"\s*(\"[^\"]*\"|\d+\.?\d*(?:[eE][+-]?\d+)?|p\[|[A-Za-z_]\w*|==|!=|<=|>=|[-+*/%()\[\],=<>])"
)
LEVELS = (("or", "xor"), ("and",), ("==", "!=", "<", ">", "<=", ">="), ("+", "-"), ("*", "/", "%"))
STEPS = 100_000
WORDS = {"and", "or", "not", "xor", "if", "elif", "else", "while", "def", "end", "return"}


class Halted(Exception):  # noqa: N818 -- names the situation
    """The program has ended by `halt`."""


class Returned(Exception):  # noqa: N818 -- names the situation
    """A function is left."""

    def __init__(self, value: Any) -> None:
        """Keep what it gives back."""
        super().__init__()
        self.value = value


class Motion(NamedTuple):
    """What the arm was told: joints in radians, or the pose of the tool in UR's base frame."""

    word: str
    target: Pose
    is_pose: bool
    flange: Matrix  # in UR's base frame
    a: float
    v: float
    r: float


class Robot:
    """What a program does to a robot: motions, outputs and messages in one list."""

    def __init__(
        self, forward: Callable[[Pose], Matrix], start: Pose, on: Callable[[int], bool]
    ) -> None:
        """Begin at joints [rad]; `forward` gives the flange in UR's base frame."""
        self.forward, self.on = forward, on
        self.joints: Pose | None = start
        self.flange = forward(start)
        self.tcp = np.eye(4)
        self.payload: float | None = None
        self.done: list[Any] = []

    def run(self, text: str) -> list[Any]:
        """Carry out a program: its one outermost function, called at its end or not."""
        top = blocks(text)
        if len(top) != 1 or not top[0].text.startswith("def "):
            raise NotTaken("a program is one function")
        with suppress(Halted, Returned):
            _Running(self).body(top[0].inner, {})
        return self.done

    def move(self, word: str, given: list[Any], named: dict[str, float]) -> None:
        """Move to joints, or to a pose of the tool."""
        target: Any = given[0]
        values = dict(zip(("a", "v", "t", "r"), given[1:], strict=False)) | named
        extra = set(values) - {"a", "v", "t", "r"}
        if extra or not isinstance(given[0], tuple | list) or len(target) != 6:
            raise NotTaken(f"{word} takes a pose or joints, and a, v, t, r")
        is_pose = isinstance(given[0], tuple)
        if values.get("a", 1.0) <= 0.0 or values.get("v", 1.0) <= 0.0 or values.get("r", 0.0) < 0.0:
            raise NotTaken("a and v are positive, r is not negative")
        if is_pose:
            self.flange = matrix(target) @ np.linalg.inv(self.tcp)
            self.joints = None
        else:
            self.joints = tuple(target)
            self.flange = self.forward(self.joints)
        each = (values.get("a", 1.4), values.get("v", 1.05), values.get("r", 0.0))
        self.done.append(Motion(word, tuple(target), is_pose, self.flange, *each))

    def here(self) -> Pose:
        """Return the pose of the tool."""
        return pose(self.flange @ self.tcp)


class _Running:
    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.functions: dict[str, tuple[list[str], list[Line]]] = {}
        self.globals: dict[str, Any] = {}
        self.steps = 0

    def body(self, lines: list[Line], local: dict[str, Any]) -> bool:
        """Carry out lines; return whether `break` was met."""
        taken = False  # whether a branch of the present `if` was
        for line in lines:
            self.steps += 1
            if self.steps > STEPS:
                raise NotTaken("the program does not end")
            words = line.text
            try:
                if words == "break":
                    return True
                if words.startswith("def "):
                    self._define(line)
                elif words.startswith(("if ", "elif ", "else")):
                    first = words.startswith("if ")
                    if first:
                        taken = False
                    if taken:
                        continue
                    condition = words.removesuffix(":").partition(" ")[2]
                    if words.startswith("else") or self._true(condition, local):
                        taken = True
                        if self.body(line.inner, local):
                            return True
                elif words.startswith("while "):
                    while self._true(words.removesuffix(":")[6:], local):
                        self.steps += 1
                        if self.steps > STEPS:
                            raise NotTaken("the program does not end")
                        if self.body(line.inner, local):
                            break
                else:
                    self._statement(words, local)
            except NotTaken as why:
                if str(why).startswith("line "):
                    raise
                raise NotTaken(f"line {line.number}: {why}: {words}") from None
        return False

    def _define(self, line: Line) -> None:
        match = re.fullmatch(r"def ([A-Za-z_]\w*)\(([\w, ]*)\):", line.text)
        if match is None:
            raise NotTaken("def NAME(a, b): is wanted")
        names = [name.strip() for name in match[2].split(",") if name.strip()]
        self.functions[match[1]] = (names, line.inner)

    def _true(self, text: str, local: dict[str, Any]) -> bool:
        found = self._value(text, local)
        if not isinstance(found, bool):
            raise NotTaken("a condition is True or False")
        return found

    def _statement(self, words: str, local: dict[str, Any]) -> None:
        if words == "halt":
            raise Halted
        if words == "return" or words.startswith("return "):
            raise Returned(self._value(words[7:], local) if words[7:] else None)
        match = re.fullmatch(r"([A-Za-z_]\w*)\[(.+?)\] *=(?!=) *(.+)", words)
        if match is not None:
            name, at, text = match.groups()
            held: Any = local[name] if name in local else self.globals.get(name)
            number, value = self._value(at, local), self._value(text, local)
            if kind_of(element(held, number)) != kind_of(value):
                raise NotTaken("an element keeps its type")
            held[number] = value
            return
        match = re.fullmatch(r"(?:(global|local) )?([A-Za-z_]\w*) *=(?!=) *(.+)", words)
        if match is None:
            self._value(words, local)
            return
        kind, name, text = match.groups()
        if name in WORDS:
            raise NotTaken(f"`{name}` is a word of the language")
        value = copied(self._value(text, local))
        held = local.get(name) if kind != "global" and name in local else self.globals.get(name)
        if kind != "local" and held is not None and kind_of(held) != kind_of(value):
            raise NotTaken("a variable keeps the type that it was given first")
        if kind == "local" or (kind is None and name in local):
            local[name] = value
        elif kind == "global" or name in self.globals:
            self.globals[name] = value
        else:
            local[name] = value

    def _value(self, text: str, local: dict[str, Any]) -> Any:
        reader = _Expression(text, local, self)
        found = reader.level(0)
        if reader.next():
            raise NotTaken(f"nothing may follow before `{reader.next()}`")
        return found

    def call(self, name: str, given: list[Any], named: dict[str, float]) -> Any:
        """Carry out a function of the program or of the manual."""
        if name in self.functions:
            names, lines = self.functions[name]
            if len(names) != len(given) or named:
                raise NotTaken(f"{name} takes {len(names)} arguments")
            try:
                self.body(lines, dict(zip(names, map(copied, given), strict=True)))
            except Returned as left:
                return left.value
            return None
        robot = self.robot
        if name in ("movej", "movel"):
            robot.move(name, given, named)
            return None
        own = getattr(self, f"_{name}", None)
        if own is None or named:
            raise NotTaken(f"the manual has no function {name} so")
        return own(*given)

    def _set_tcp(self, tcp: Pose) -> None:
        self.robot.tcp = matrix(tcp)

    def _set_payload(self, mass: float, cog: list[float]) -> None:
        if mass < 0.0 or len(cog) != 3:
            raise NotTaken("a mass and a centre of gravity are wanted")
        self.robot.payload = mass

    def _set_standard_digital_out(self, number: float, on: object) -> None:
        if not isinstance(on, bool) or not 0 <= number <= 7:
            raise NotTaken("outputs are 0 to 7, True or False")
        self.robot.done.append(("out", round(number), on))

    def _get_standard_digital_in(self, number: float) -> bool:
        if not 0 <= number <= 7:
            raise NotTaken("inputs are 0 to 7")
        return self.robot.on(round(number))

    def _sleep(self, seconds: float) -> None:
        if seconds < 0.0:
            raise NotTaken("a time is not negative")
        self.robot.done.append(("sleep", seconds))

    def _sync(self) -> None:
        pass

    def _textmsg(self, *words: Any) -> None:
        self.robot.done.append(("text", *words))

    def _pose_trans(self, one: Pose, other: Pose) -> Pose:
        return pose(matrix(one) @ matrix(other))

    def _pose_inv(self, one: Pose) -> Pose:
        return pose(np.asarray(np.linalg.inv(matrix(one)), np.float64))

    def _get_target_tcp_pose(self) -> Pose:
        return self.robot.here()

    def _get_forward_kin(self, joints: list[float] | None = None) -> Pose:
        if joints is None:
            return self.robot.here()
        return pose(self.robot.forward(tuple(joints)) @ self.robot.tcp)

    def _get_target_joint_positions(self) -> list[float]:
        if self.robot.joints is None:
            raise NotTaken("joints behind a pose are not worked out here")
        return list(self.robot.joints)

    def _sin(self, x: float) -> float:
        return math.sin(x)

    def _tan(self, x: float) -> float:
        return math.tan(x)

    def _cos(self, x: float) -> float:
        return math.cos(x)

    def _sqrt(self, x: float) -> float:
        return math.sqrt(x)

    def _floor(self, x: float) -> float:
        return math.floor(x)

    def _ceil(self, x: float) -> float:
        return math.ceil(x)

    def _norm(self, x: float) -> float:
        return abs(x)

    def _atan2(self, y: float, x: float) -> float:
        return math.atan2(y, x)


class _Expression:
    def __init__(self, text: str, local: dict[str, Any], running: _Running) -> None:
        self.tokens: list[str] = []
        self.local, self.running, self.at = local, running, 0
        place = 0
        while place < len(text.rstrip()):
            match = TOKEN.match(text, place)
            if match is None:
                raise NotTaken(f"`{text[place:]}` is no expression")
            self.tokens.append(match.group(1))
            place = match.end()

    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, wanted: str = "") -> str:
        found = self.next()
        if not found or (wanted and found != wanted):
            raise NotTaken(f"`{wanted or 'more'}` is missing")
        self.at += 1
        return found

    def level(self, k: int) -> Any:
        if k == len(LEVELS):
            return self.unary()
        found = self.level(k + 1)
        while self.next() in LEVELS[k]:
            operator = self.take()
            found = _operation(operator, found, self.level(k + 1))
        return found

    def unary(self) -> Any:
        if self.next() == "-":
            self.take()
            return -self.unary()
        if self.next() == "not":
            self.take()
            value = self.unary()
            if not isinstance(value, bool):
                raise NotTaken("`not` takes True or False")
            return not value
        found = self.primary()
        while self.next() == "[":
            self.take()
            found = element(found, self.level(0))
            self.take("]")
        return found

    def primary(self) -> Any:
        token = self.take()
        if token == "(":
            found = self.level(0)
            self.take(")")
            return found
        if token in ("[", "p["):
            items: list[Any] = []
            while self.next() != "]":
                items.append(self.level(0))
                if self.next() != "]":
                    self.take(",")
            self.take("]")
            if token == "p[" and len(items) != 6:
                raise NotTaken("a pose has six numbers")
            return tuple(items) if token == "p[" else items
        if token[0] == '"':
            return token[1:-1]
        if token[0].isdigit():
            return int(token) if token.isdigit() else float(token)
        if token in ("True", "False"):
            return token == "True"
        if self.next() == "(":
            return self._call(token)
        if token in self.local:
            return self.local[token]
        if token in self.running.globals:
            return self.running.globals[token]
        raise NotTaken(f"`{token}` has no value")

    def _call(self, name: str) -> Any:
        self.take("(")
        given: list[Any] = []
        named: dict[str, float] = {}
        while self.next() != ")":
            if self.at + 1 < len(self.tokens) and self.tokens[self.at + 1] == "=":
                key = self.take()
                self.take("=")
                named[key] = self.level(0)
            else:
                given.append(self.level(0))
            if self.next() != ")":
                self.take(",")
        self.take(")")
        return self.running.call(name, given, named)


def _operation(operator: str, a: Any, b: Any) -> Any:
    if operator in ("and", "or", "xor"):
        if not (isinstance(a, bool) and isinstance(b, bool)):
            raise NotTaken(f"`{operator}` takes True and False")
        return {"and": a and b, "or": a or b, "xor": a != b}[operator]
    if isinstance(a, bool) or isinstance(b, bool):
        raise NotTaken("True and False are no numbers")
    match operator:
        case "+":
            return a + b
        case "-":
            return a - b
        case "*":
            return a * b
        case "/":
            if isinstance(a, int) and isinstance(b, int):
                raise NotTaken("the manual does not say how whole numbers divide")
            return a / b
        case "%":
            return math.fmod(a, b)
        case "==":
            return a == b
        case "!=":
            return a != b
        case "<":
            return a < b
        case ">":
            return a > b
        case "<=":
            return a <= b
        case _:
            return a >= b
