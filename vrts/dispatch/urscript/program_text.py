"""The programs of a module as one program of URScript: a function each, in one that begins."""

from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.pose import Pose
from vrts.dispatch.saying.calls import called_by
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import decimal, plain, readable
from vrts.dispatch.saying.parts import condition_of, constant, parts
from vrts.dispatch.saying.signals import FIRST_INTERNAL
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.under_way import looks, under_way
from vrts.dispatch.urscript.steps import Steps, asks
from vrts.dispatch.urscript.values import (
    NOTHING,
    joints_text,
    name_of,
    pose_text,
)
from vrts.ir import instructions as ir
from vrts.ir.expressions import Constant, Global, Place, Slot
from vrts.ir.module import Module, Program
from vrts.ir.values import Type
from vrts.lang.compiler import Resolved
from vrts.lang.meaning.structure import word_of
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import Declare

CANNOT = Rule("V877", "urscript-cannot")
INDENT = "  "
EMPTY = {Type.REAL: "0", Type.POSE: NOTHING, Type.JOINTS: "[0, 0, 0, 0, 0, 0]"}


class Arm(NamedTuple):
    """What the text says of the arm."""

    X_FT: Pose
    ready: tuple[float, ...]
    joint_speed: float  # [rad/s] of the slowest joint
    linear_speed: float  # [m/s]
    acceleration_time: float  # [s]
    hand_s: float


class Said(NamedTuple):
    """Programs in URScript, as far as they could be said."""

    text: str
    diagnostics: tuple[Diagnostic, ...]


LIBRARY = """
  # VAL-II counts in a frame that is turned by half a turn about Z against UR's base.
  global v_turn = p[0, 0, 0, 0, 0, 3.141592653589793]
  global v_rad = 0.017453292519943295
  global v_next = 0
  global v_always = 1
  global v_full_mm = {linear_mm}
  global v_hand_s = {hand}
  def v_here():
    return pose_trans(v_turn, get_forward_kin())
  end
  def v_tool(q):
    return pose_trans(v_turn, get_forward_kin(q))
  end
  def v_share():
    local share = v_always
    if v_next > 0:
      share = v_next
    end
    global v_next = 0
    return share
  end
  def v_movej(x, r):
    local s = v_share()
    movej(pose_trans(v_turn, x), a={joint_a} * s, v={joint_v} * s, r=r)
    global v_at = x
  end
  def v_movejoints(q, r):
    local s = v_share()
    movej(q, a={joint_a} * s, v={joint_v} * s, r=r)
    global v_at = v_tool(q)
  end
  def v_movel(x, r):
    local s = v_share()
    movel(pose_trans(v_turn, x), a={linear_a} * s, v={linear_v} * s, r=r)
    global v_at = x
  end
  def v_shift(x, y, z):
    return p[x / 1000, y / 1000, z / 1000, 0, 0, 0]
  end
  def v_trans(x, y, z, o, a, t):
    local turned = pose_trans(p[0, 0, 0, 0, 0, v_rad * o], p[0, 0, 0, 0, v_rad * a, 0])
    return pose_trans(v_shift(x, y, z), pose_trans(turned, p[0, 0, 0, 0, 0, v_rad * t]))
  end
  def v_part(x, k):
    return x[k]
  end
  def v_distance(x, y):
    local a = (x[0] - y[0]) * (x[0] - y[0]) + (x[1] - y[1]) * (x[1] - y[1])
    return 1000 * sqrt(a + (x[2] - y[2]) * (x[2] - y[2]))
  end
  def v_real(b):
    if b:
      return -1
    end
    return 0
  end
  def v_int(x):
    if x < 0:
      return ceil(x)
    end
    return floor(x)
  end
  def v_hand(open, close):
    set_standard_digital_out({hand_close}, close)
    set_standard_digital_out({hand_open}, open)
  end
"""


def said(
    found: Resolved,
    module: Module,
    entry: str,
    table: Table,
    arm: Arm,
    radii: Mapping[tuple[str, int], float],
) -> Said:
    """Return the file of a program and all that it calls.

    Args:
        found: The programs as syntax trees.
        module: The same compiled.
        entry: The program that is executed.
        table: Inputs and outputs.
        arm: The arm.
        radii: Of rounded corners [m], by program and step.
    """
    try:
        names = called_by(module, entry)
    except CannotSay as cannot:
        return Said("", (cannot.diagnostic(CANNOT, module.programs[entry].span),))
    writer = _Writer(found, module, table, arm, radii, under_way(module, entry))
    texts = {program.name: program for program in found.programs}
    bodies = [row for name in names for row in writer.program(texts[name])]
    library = LIBRARY.format(
        linear_mm=decimal(1000.0 * arm.linear_speed),
        hand=decimal(arm.hand_s),
        joint_a=decimal(arm.joint_speed / arm.acceleration_time),
        joint_v=decimal(arm.joint_speed),
        linear_a=decimal(arm.linear_speed / arm.acceleration_time),
        linear_v=decimal(arm.linear_speed),
        hand_open=table.hand_open,
        hand_close=table.hand_close,
    )
    rows = [
        f"def {plain(entry)}_of_val():",
        f"{INDENT}# Written by vrts; not tried on a controller. Read the sheet first.",
        *library.strip("\n").split("\n"),
        f"{INDENT}set_tcp({pose_text(arm.X_FT)})",
        f"{INDENT}global v_at = v_here()",
        *(f"{INDENT}global {name} = {text}" for name, text in writer.variables().items()),
        *(INDENT + row for row in bodies),
        f"{INDENT}prog_{plain(entry)}()",
        "end",
    ]
    return Said("\n".join(rows) + "\n", tuple(writer.errors))


class _Writer:
    def __init__(
        self,
        found: Resolved,
        module: Module,
        table: Table,
        arm: Arm,
        radii: Mapping[tuple[str, int], float],
        moving: frozenset[tuple[str, int]],
    ) -> None:
        self.module, self.table, self.radii, self.moving = module, table, radii, moving
        self.problems = found.resolver.problems
        self.errors: list[Diagnostic] = []
        self.arm = arm

    def variables(self) -> dict[str, str]:
        """Return every variable with what it holds at first."""
        held: dict[str, str] = {}
        for program in self.module.programs.values():
            for part in parts(program.instructions):
                if isinstance(part, Place) and isinstance(part.variable, Global):
                    kind = part.variable.type
                    if kind in EMPTY and not part.subscripts:
                        held[name_of(part)] = EMPTY[kind]
                if isinstance(part, Constant) and isinstance(part.value, float):
                    signal = round(abs(part.value))
                    if FIRST_INTERNAL <= signal < FIRST_INTERNAL + 1000:
                        held[f"signal_{signal}"] = "False"
        for datum in self.module.data:
            if datum.subscripts or isinstance(datum.value, str):
                continue
            kind = Type.REAL
            text = decimal(datum.value) if isinstance(datum.value, float) else ""
            if isinstance(datum.value, Pose):
                kind, text = Type.POSE, pose_text(datum.value)
            elif isinstance(datum.value, tuple):
                kind, text = Type.JOINTS, joints_text(datum.value)
            name = name_of(Place(Global(datum.name, kind)))
            if name in held:
                held[name] = text
        return held

    def program(self, text: ProgramText) -> list[str]:
        """Return the lines of a program."""
        program = self.module.programs[text.name]
        steps = Steps(self.table, joints_text(self.arm.ready))
        names = ", ".join(name_of(Place(Slot(*formal))) for formal in program.formals)
        rows = [f"def prog_{plain(text.name)}({names}):"]
        blocks = _Blocks(steps)
        for step in text.steps:
            node = step.statement
            if node is None:
                continue
            depth = blocks.depth
            try:
                written = self._step(program, step, steps, blocks)
            except CannotSay as cannot:
                span = self.problems.span(node.start, node.end)
                self.errors.append(cannot.diagnostic(CANNOT, span))
                blocks.pass_over(word_of(step) or "", depth)
                continue
            indent = INDENT * (1 + min(depth, blocks.depth))
            words = self.problems.source.text[node.start : node.end]
            rows.append(f"{indent}# {step.number:>3}  {readable(words)}")
            rows += [indent + line for line in written]
        return [*rows, f"{INDENT}return True", "end"]

    def _step(self, program: Program, step: Step, steps: Steps, blocks: "_Blocks") -> list[str]:
        last = len(program.instructions) - 1
        at = [k for k, o in enumerate(program.origins) if o.step == step.number and k < last]
        found = [program.instructions[k] for k in at]
        if any((program.name, k) in self.moving for k in at) and any(
            looks(i) or asks(i) for i in found
        ):
            raise CannotSay(
                "the arm may still move when this looks at the outside or changes it",
                "write BREAK before it: URScript goes on when a motion has ended",
            )
        word = word_of(step)
        if word is not None:
            return blocks.lines(word, found)
        if isinstance(step.statement, Declare):
            raise CannotSay("variables of a program's own are not written", "use other names")
        radius = self.radii.get((program.name, step.number), 0.0)
        rows: list[str] = []
        for k, instruction in zip(at, found, strict=True):
            rows += steps.lines(instruction, program.instructions[k + 1], radius)
        return rows


class _Open(NamedTuple):
    word: str
    variable: str = ""
    increment: str = ""
    groups: int = 0


class _Blocks:
    """Structure words as blocks of URScript; each holds a line, so that none is empty."""

    def __init__(self, steps: Steps) -> None:
        self.values = steps.values
        self.open: list[_Open] = []
        self.named = 0

    @property
    def depth(self) -> int:
        """How far lines are moved in."""
        return len(self.open)

    def lines(self, word: str, found: list[ir.Instruction]) -> list[str]:
        """Return what a structure word becomes."""
        inner = INDENT + "sync()"
        match word:
            case "IF" | "WHILE":
                text = self.values.condition(condition_of(found))
                self.open.append(_Open(word))
                return [f"{word.lower()} {text}:", inner]
            case "DO":
                self.open.append(_Open(word))
                return ["while True:", inner]
            case "UNTIL":
                text = self.values.condition(condition_of(found))
                self.open.pop()
                return [f"  if {text}:", "    break", "  end", "end"]
            case "FOR":
                return self._for(found)
            case "CASE":
                case = next(i for i in found if isinstance(i, ir.BeginCase))
                self.named += 1
                self.open.append(_Open(word, f"case_{self.named}"))
                return [f"local case_{self.named} = {self.values.real(case.selector)}"]
            case "VALUE":
                return self._group(found, inner)
            case "ANY" | "ELSE":
                if self.open[-1].word == "CASE" and not self.open[-1].groups:
                    raise CannotSay("a CASE without VALUE", "leave it out")
                return ["else:", inner]
            case "END":
                return self._end()
            case _:
                raise CannotSay(f"URScript has nothing that means {word}")

    def _for(self, found: list[ir.Instruction]) -> list[str]:
        loop = next(i for i in found if isinstance(i, ir.BeginFor))
        if isinstance(loop.place.variable, Slot):
            raise CannotSay("a FOR counts with an argument", "count with another variable")
        by = 1.0 if loop.increment is None else constant(loop.increment)
        if by is None or by == 0.0:
            raise CannotSay("the step of a FOR is worked out in the run", "write a number")
        variable = name_of(loop.place)
        self.named += 1
        last = f"last_{self.named}"
        sign = "<=" if by > 0.0 else ">="
        rows = [
            f"global {variable} = {self.values.real(loop.first)}",
            f"local {last} = {self.values.real(loop.last)}",
            f"while {variable} {sign} {last}:",
            INDENT + "sync()",
        ]
        self.open.append(_Open("FOR", variable, decimal(by)))
        return rows

    def _group(self, found: list[ir.Instruction], inner: str) -> list[str]:
        group = next(i for i in found if isinstance(i, ir.TestCase))
        now = self.open[-1]
        tests = " or ".join(f"({now.variable} == {self.values.real(v)})" for v in group.values)
        word = "elif" if now.groups else "if"
        self.open[-1] = now._replace(groups=now.groups + 1)
        return [f"{word} {tests}:", inner]

    def _end(self) -> list[str]:
        now = self.open.pop()
        if now.word == "CASE" and not now.groups:
            raise CannotSay("a CASE without VALUE", "leave it out")
        if now.word == "FOR":
            return [f"  global {now.variable} = {now.variable} + {now.increment}", "end"]
        return ["end"]

    def pass_over(self, word: str, depth: int) -> None:
        """Keep what is open in order behind a structure word that was refused."""
        if word in ("IF", "WHILE", "DO", "FOR", "CASE") and len(self.open) == depth:
            self.open.append(_Open(word, groups=1))
        elif word in ("END", "UNTIL") and len(self.open) == depth and self.open:
            self.open.pop()
