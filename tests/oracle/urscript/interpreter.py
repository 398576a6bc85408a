"""Carries out URScript: def, if, while, return, break, halt, and the functions below.

Arrays, types and what is copied (sections 3 to 8 of the script manual for e-Series, SW 5.11) came
later, from that manual, by somebody who knew what the export writes. So did threads (SW 5.20),
`time` (SW 5.19), `get_steptime` and `stopj`, before the export used them. How long motions take and
where the arm comes to rest when it is stopped, the manual does not say: whoever runs it tells.
"""

import math
import re
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np

from tests.oracle.urscript.expressions import Expression
from tests.oracle.urscript.lines import Line, blocks
from tests.oracle.urscript.poses import Matrix, Pose, matrix, nearest, pose
from tests.oracle.urscript.threads import FRAME, Killed, Thread, Threads
from tests.oracle.urscript.values import NotTaken, Struct, copied, element, kind_of

STEPS = 400_000
STARTED = 5000.25  # [s] that the controller has run when a program begins
WORDS = {
    *("and", "or", "not", "xor", "if", "elif", "else", "while", "def", "end", "return"),
    *("thread", "run", "join", "kill"),
}


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
        self,
        forward: Callable[[Pose], Matrix],
        start: Pose,
        on: Callable[[int], bool],
        takes: Callable[[int], float] = lambda _: 0.0,
        stops: Callable[[int], tuple[float, Pose]] | None = None,
    ) -> None:
        """Begin at joints [rad].

        Args:
            forward: Gives the flange in UR's base frame.
            start: The joints.
            on: Tells an input.
            takes: How long the motion of a number takes, from 0 [s].
            stops: How long the motion of a number takes to stop when it is cut [s], and where.
        """
        self.forward, self.on, self.takes, self.stops = forward, on, takes, stops
        self.known: Pose = start  # joints that the arm last had for certain, and poses since
        self.since: list[Matrix] = []
        self.threads = Threads()
        self.when: list[float] = []  # beside what is done [s]
        self.moves = 0
        self.moving = self.cut = False
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
        try:
            with suppress(Halted, Returned):
                _Running(self).body(top[0].inner, {})
        finally:
            self.threads.end()
        return self.done

    @property
    def now(self) -> float:
        """The time since the program began [s]."""
        return self.threads.now

    def note(self, item: Any) -> None:
        """Keep what is done, with its time."""
        self.done.append(item)
        self.when.append(self.now)

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
        if self.moving:
            raise NotTaken("the arm is under way: one thread moves it, and stops it before others")
        if is_pose:
            flange, joints = matrix(target) @ np.linalg.inv(self.tcp), None
        else:
            joints = tuple(target)
            flange = self.forward(joints)
        each = (values.get("a", 1.4), values.get("v", 1.05), values.get("r", 0.0))
        self.note(Motion(word, tuple(target), is_pose, flange, *each))
        self.moves += 1
        self.moving = True
        try:
            self.threads.use(self.takes(self.moves - 1))
        except Killed:
            self.cut = True
            raise
        self.moving, self.flange, self.joints = False, flange, joints
        self.since.append(flange)
        if joints is not None:
            self.known, self.since = joints, []

    def stop(self, word: str, a: float) -> None:
        """Slow down to rest what a killed thread has left under way."""
        if a <= 0.0:
            raise NotTaken("a is positive")
        self.note((word, a))
        if self.moving and not self.cut:
            raise NotTaken("another thread moves the arm")
        if self.cut:
            if self.stops is None:
                raise NotTaken("nobody told where the arm comes to rest")
            seconds, joints = self.stops(self.moves - 1)
            self.threads.use(seconds)
            self.moving = self.cut = False
            self.joints, self.flange = joints, self.forward(joints)
            self.known, self.since = joints, []

    def stands(self) -> Pose:
        """Return the joints: of a pose those nearest to where the arm stood, as the manual says."""
        joints = np.array(self.known)
        for flange in self.since:
            joints = nearest(self.forward, flange, joints)
        self.known, self.since = tuple(map(float, joints)), []
        return self.known

    def here(self) -> Pose:
        """Return the pose of the tool."""
        if self.moving:
            raise NotTaken("where the arm is while it moves is not worked out here")
        return pose(self.flange @ self.tcp)


class _Running:
    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.functions: dict[str, tuple[list[str], list[Line]]] = {}
        self.bodies: dict[str, list[Line]] = {}  # of threads
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
                if words.startswith(("def ", "thread ")):
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

    def begin(self, name: str) -> Thread:
        """Begin a thread of a name."""
        if name not in self.bodies:
            raise NotTaken(f"there is no thread {name}")

        def carry_out() -> None:
            with suppress(Returned):
                self.body(self.bodies[name], {})

        return self.robot.threads.begin(carry_out)

    def _define(self, line: Line) -> None:
        match = re.fullmatch(r"thread ([A-Za-z_]\w*)\(\):", line.text)
        if match is not None:
            self.bodies[match[1]] = line.inner
            return
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
        match = re.fullmatch(r"(kill|join) ([A-Za-z_]\w*)", words)
        if match is not None:
            threads = self.robot.threads
            (threads.kill if match[1] == "kill" else threads.join)(self._value(match[2], local))
            return
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
        reader = Expression(text, local, self)
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
        self.robot.note(("out", round(number), on))

    def _get_standard_digital_in(self, number: float) -> bool:
        if not 0 <= number <= 7:
            raise NotTaken("inputs are 0 to 7")
        return self.robot.on(round(number))

    def _sleep(self, seconds: float) -> None:
        if seconds < 0.0:
            raise NotTaken("a time is not negative")
        self.robot.note(("sleep", seconds))
        self.robot.threads.use(seconds)

    def _sync(self) -> None:
        self.robot.threads.use(FRAME)

    def _get_steptime(self) -> float:
        return FRAME

    def _time(self, mode: int = 0) -> Struct:
        if mode != 0:
            raise NotTaken("time(0) counts from when the controller began")
        whole, part = divmod(self.robot.now + STARTED, 1.0)
        return Struct(sec=int(whole), nanosec=round(1e9 * part))

    def _stopj(self, a: float) -> None:
        self.robot.stop("stopj", a)

    def _textmsg(self, *words: Any) -> None:
        self.robot.note(("text", *words))

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
        if self.robot.moving:
            raise NotTaken("where the arm is while it moves is not worked out here")
        return list(self.robot.stands())

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
