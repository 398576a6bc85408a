"""AS of Kawasaki: its words for motions, and `+` between locations.

See [manual language/dialects#to-as].
"""

from typing import ClassVar

from vrts.dispatch.posts.expressions_anew import TIGHTEST, CannotWrite, Settled, Start
from vrts.dispatch.posts.post import Post
from vrts.ir.values import Type
from vrts.lang.compiler import Resolved
from vrts.lang.dialect import AS
from vrts.lang.names import key
from vrts.lang.said_by_relatives import WORDS_IN_AS
from vrts.lang.syntax import expressions, statements
from vrts.lang.syntax.program import Formal

COARSE_MM = 10.0  # ACCURACY for COARSE [assumed]
FINE_MM = 1.0  # the same for FINE, AS's own default [manual language/dialects#accuracy]
MM_PER_INCH = 25.4
SWITCHES = frozenset({"CP", "MESSAGES"})  # that mean the same in AS [AS2015] 7
_LOCATIONS = frozenset({Type.POSE, Type.JOINTS})


class KawasakiAs(Post):
    """Writes AS."""

    name = "as"
    dialect = AS
    suffix = ".as"
    WORDS: ClassVar[dict[str, str]] = WORDS_IN_AS
    LACKS: ClassVar[frozenset[str]] = frozenset({"DECOMPOSE"})  # its angles differ
    LEFT_OUT: ClassVar[frozenset[str]] = frozenset(
        {"INTON", "INTOFF", "NULL", "NONULL", "SINGLE", "MULTIPLE"}
    )
    FUNCTIONS: ClassVar[dict[str, str]] = {"max": "MAXVAL", "min": "MINVAL"}
    LACKS_FUNCTIONS: ClassVar[frozenset[str]] = frozenset(
        {
            *("adc", "ioget", "pendant", "status", "$unpack", "bcd", "dcb", "identical", "state"),
            *("defined", "parameter", "tas", "last", "hand", "scale"),
        }
    )

    def __init__(self, found: Resolved, settled: Settled) -> None:
        """Write programs of one source."""
        super().__init__(found, settled)
        self._named = 0  # locations that are worked out before a call
        written = (step.statement for program in found.programs for step in program.steps)
        speeds = [s for s in written if isinstance(s, statements.SpeedStatement)]
        self._inches = any(level.unit == "IPS" for s in speeds for level in s.levels)

    # --- statements -----------------------------------------------------------------------------

    def _write_movet(self, node: statements.Simple) -> tuple[str, ...]:
        return self._with_hand(node, "JMOVE")

    def _write_movest(self, node: statements.Simple) -> tuple[str, ...]:
        return self._with_hand(node, "LMOVE")

    def _with_hand(self, node: statements.Simple, word: str) -> tuple[str, ...]:
        """MOVET: the hand opens or closes when the motion begins, as OPEN and CLOSE do."""
        target, opening = node.operands
        motion = f"{word} {self.listed((target,))}"
        if isinstance(opening, expressions.Number):
            return ("OPEN" if opening.value > 0.0 else "CLOSE", motion)
        return (f"IF {self.listed((opening,))} > 0 THEN", "OPEN", "ELSE", "CLOSE", "END", motion)

    def _hand(self, node: statements.Simple) -> tuple[str, ...]:
        """A number behind OPEN and its like names a clamp in AS, not a distance [AS2015] 6-2."""
        if any(node.operands):
            remedy = f"write {node.word} without the distance"
            raise self.lacking(node, f"{node.word} with a distance", remedy)
        return (self.rewritten(node),)

    _write_open = _write_openi = _write_close = _write_closei = _hand
    _write_relax = _write_relaxi = _hand

    def begun(self, start: Start) -> tuple[str, ...]:
        """TOOL and BASE take names of locations, and BASE the pose of the frame [AS2015] 6-112."""
        name = _own("begin.tool")
        return (f"POINT {name} = {self.pose(start.X_FT)}", f"TOOL {name}", "BASE NULL")

    def _write_ready(self, node: statements.Simple) -> tuple[str, ...]:
        """READY of the arm that was simulated: HOME of AS is wherever it was set."""
        return self.ready(node, "JMOVE")

    def _write_wait(self, node: statements.Simple) -> tuple[str, ...]:
        """WAIT needs a condition [AS2015] 6-47."""
        if not any(node.operands):
            raise self.lacking(node, "WAIT without a condition")
        return (self.rewritten(node),)

    def _write_return(self, node: statements.Simple) -> tuple[str, ...]:
        if any(node.operands):
            raise self.lacking(node, "RETURN that skips steps of the caller")
        return (self.rewritten(node),)

    def _write_pulse(self, node: statements.Simple) -> tuple[str, ...]:
        """PULSE needs a time [AS2015] 6-74."""
        if len(node.operands) < 2:
            raise self.lacking(node, "PULSE without a time", "write the time")
        return (self.rewritten(node),)

    def _write_accel(self, node: statements.SpeedStatement) -> tuple[str, ...]:
        """ACCEL and DECEL take one number each [AS2015] 6-17."""
        always = " ALWAYS" if node.always else ""
        given = zip(("ACCEL", "DECEL"), node.levels, strict=False)
        return tuple(f"{word} {self.expression(level.value)}{always}" for word, level in given)

    def _write_grasp(self, node: statements.Simple) -> tuple[str, ...]:
        """AS does not know how far a hand is open [AS2015] appendix 5."""
        return self.grasped(node)

    def _write_shift(self, node: statements.ShiftStatement) -> tuple[str, ...]:
        place = self.expression(node.target)
        return (f"POINT {place} = SHIFT({place} BY {self.listed(node.offsets)})",)

    def _write_tool(self, node: statements.Simple) -> tuple[str, ...]:
        """TOOL takes a name or a compound of names [AS2015] 6-113."""
        (tool,) = node.operands or (None,)
        if tool is None:
            return ("TOOL NULL",)
        text = self.listed((tool,))
        return self._named_frame("TOOL", text, named=_is_named(tool))

    def _write_base(self, node: statements.Simple) -> tuple[str, ...]:
        """BASE of AS takes the pose of the new frame, the inverse of what VAL-II is told."""
        if not any(node.operands):
            return ("BASE NULL",)
        dx, dy, dz, turn = (*node.operands, None, None, None, None)[:4]
        lengths = [self.listed((item,)) or "0" for item in (dx, dy, dz)]
        pose = f"-TRANS({', '.join(lengths)}, {self.listed((turn,)) or '0'}, 0, 0)"
        return self._named_frame("BASE", pose, named=False)

    def _named_frame(self, word: str, text: str, *, named: bool) -> tuple[str, ...]:
        if named:
            return (f"{word} {text}",)
        name = _own(f"new.{word.lower()}")
        return (f"POINT {name} = {text}", f"{word} {name}")

    def _write_speed(self, node: statements.SpeedStatement) -> tuple[str, ...]:
        (value, unit, *_), *more = node.levels
        if unit == "MONITOR":
            raise self.lacking(node, "SPEED MONITOR", "set the speed at the monitor")
        if more:
            raise self.lacking(node, "a speed of rotation in SPEED")
        text = self.expression(value)
        if unit == "IPS":
            text = f"{self.operand(value, self._table['*'])}*{MM_PER_INCH:g}"
        always = " ALWAYS" if node.always else ""
        return (f"SPEED {text}{'' if unit is None else ' MM/S'}{always}",)

    def _write_coarse(self, node: statements.Setting) -> tuple[str, ...]:
        return self._accuracy(node, COARSE_MM)

    def _write_fine(self, node: statements.Setting) -> tuple[str, ...]:
        return self._accuracy(node, FINE_MM)

    def _accuracy(self, node: statements.Setting, accuracy_mm: float) -> tuple[str, ...]:
        if node.value is not None:
            raise self.lacking(node, f"{node.word} with a percentage")
        return (f"ACCURACY {accuracy_mm:g}{' ALWAYS' if node.always else ''}",)

    def _write_react(self, node: statements.ReactStatement) -> tuple[str, ...]:
        """REACT branches after the present step; ON waits until the motion is complete."""
        raise self.lacking(node, "REACT", "react at once, by REACTI, which is ONI in AS")

    def _write_reacti(self, node: statements.ReactStatement) -> tuple[str, ...]:
        signal, program, priority = (*node.operands, None, None)[:3]
        if program is None or node.always:
            raise self.lacking(node, "REACTI ALWAYS" if node.always else "REACTI without a program")
        more = "" if priority is None else f", {self.expression(priority)}"
        return (f"ONI {self.listed((signal,))} CALL {key(self.text(program))}{more}",)

    def _write_enable(self, node: statements.Simple) -> tuple[str, ...]:
        return self._switched(node, "ON")

    def _write_disable(self, node: statements.Simple) -> tuple[str, ...]:
        return self._switched(node, "OFF")

    def _switched(self, node: statements.Simple, state: str) -> tuple[str, ...]:
        """A switch is set by its name, then ON or OFF [AS2015] 6-119."""
        names = [key(o.text).upper() for o in node.operands if isinstance(o, expressions.Name)]
        other = [name for name in names if name not in SWITCHES]
        if other or not names:
            raise self.lacking(node, f"the switch {', '.join(other)}" if other else node.word)
        return (f"{', '.join(names)} {state}",)

    def statement(self, node: statements.Statement) -> tuple[str, ...]:
        """Return the steps of a statement; locations that are passed to a program are marked."""
        if isinstance(node, statements.Structure) and node.word == "ANY":
            return ("ANY :",)  # [AS2015] 6-68
        if not isinstance(node, statements.CallStatement) or not node.arguments:
            return super().statement(node)
        before: list[str] = []
        passed = [self._passed(item, before) for item in node.arguments]
        return (*before, f"CALL {key(node.program.text)}({', '.join(passed)})")

    def _passed(self, item: expressions.Item | None, before: list[str]) -> str:
        """Return an argument; what is worked out and is a location gets a name first."""
        text = self.listed((item,))
        while isinstance(item, expressions.Parenthesised):
            item = item.inner
        if item is None or isinstance(item, expressions.FormatItem):
            return text
        if isinstance(item, expressions.Name | expressions.Element):
            return _by_reference(text) if self.type_of(item) in _LOCATIONS else text
        if not self.found.resolver.is_location(item):
            return text
        self._named += 1
        joints = isinstance(item, expressions.Application) and item.name.text[0] == "#"
        name = _own(f"{'#' if joints else ''}passed.{self._named}")
        before.append(f"POINT {name} = {text}")
        return _by_reference(name)

    def formal(self, formal: Formal) -> str:
        """Return a formal argument: with a dot, and marked where it is a location."""
        text = _own(super().formal(formal))
        return _by_reference(text) if self.type_of(formal.name) in _LOCATIONS else text

    def _write_auto(self, node: statements.Declare) -> tuple[str, ...]:
        """Variables with a dot are a program's own: AS declares none."""
        return (f"; {self.text(node)}",)

    # --- expressions ----------------------------------------------------------------------------

    def variable(self, node: expressions.Name) -> str:
        """Return a name; formals and a program's own variables have a dot, else AS has one of each.

        [manual language/dialects#to-as]
        """
        own = self.found.resolver.scope.formals[self.program]
        name = super().variable(node)
        return _own(name) if key(node.text) in own else name

    def infix(self, node: expressions.Infix) -> str:
        """Return an operation; locations are joined by `+`, and by `-` with an inverse."""
        if node.operator == "**":
            return self._power(node)
        if node.operator != ":":
            return super().infix(node)
        level = self._table["+"]
        right = node.right
        while isinstance(right, expressions.Parenthesised):
            right = right.inner
        if isinstance(right, expressions.Application) and right.name.text.lower() == "inverse":
            return f"{self.operand(node.left, level)}-{self._inverted(right)}"
        return f"{self.operand(node.left, level)}+{self.operand(node.right, level + 1)}"

    def _power(self, node: expressions.Infix) -> str:
        """`^` binds tighter than a minus before it [AS2015] 3.8.2, so both stand by themselves."""
        left, right = (self.operand(part, TIGHTEST) for part in (node.left, node.right))
        prefixed = isinstance(node.left, expressions.Prefix)
        return f"({left})^{right}" if prefixed else f"{left}^{right}"

    def operand(self, node: expressions.Expression, level: int) -> str:
        """Return an operand; joined locations bind like a sum."""
        if isinstance(node, expressions.Infix) and node.operator == ":":
            text = self.expression(node)
            return f"({text})" if self._table["+"] < level else text
        return super().operand(node, level)

    def function(self, node: expressions.Name) -> str:
        """Return the name of a function; BASE counts in the opposite sense."""
        if node.text.lower() == "base":
            return "(-BASE)"
        return super().function(node)

    def _apply_inverse(self, node: expressions.Application) -> str:
        return f"(-{self._inverted(node)})"

    def _inverted(self, node: expressions.Application) -> str:
        inner = node.arguments[0]
        assert inner is not None
        assert not isinstance(inner, expressions.FormatItem)
        return self.operand(inner, self._table["+"] + 1)

    def _apply_speed(self, node: expressions.Application) -> str:
        """SPEED yields what was set, in its unit, and AS has no inches."""
        if self._inches:
            headline = "SPEED would yield mm/s where it yields inches a second"
            raise CannotWrite(node.start, node.end, headline, "set the speed in MMPS")
        return f"SPEED({self.arguments(node)})"

    def _apply_sqr(self, node: expressions.Application) -> str:
        value = self._twice(node)
        return f"({value}*{value})"

    def _apply_tan(self, node: expressions.Application) -> str:
        value = self._twice(node)
        return f"(SIN({value})/COS({value}))"

    def _apply_fract(self, node: expressions.Application) -> str:
        value = self._twice(node)
        return f"({value} - INT({value}))"

    def _apply_sign(self, node: expressions.Application) -> str:
        """1 or -1: a true comparison is -1 in both languages."""
        value = self._twice(node)
        return f"(({value} < 0)*2 + 1)"

    def _apply_outside(self, node: expressions.Application) -> str:
        low, value, high = (f"({self.listed((item,))})" for item in node.arguments)
        self._once(node)
        return f"({value} < {low} OR {value} > {high})"

    def _apply_pos(self, node: expressions.Application) -> str:
        text, part, *start = node.arguments
        literal = part.value if isinstance(part, expressions.Text) else None
        if literal is None or literal.lower() != literal.upper():
            headline = "AS looks for strings whatever the case of their letters"
            raise CannotWrite(node.start, node.end, headline, "look for a sign that is no letter")
        first = self.listed(tuple(start)) if any(start) else "1"
        return f"INSTR({first}, {self.listed((text,))}, {self.listed((part,))})"

    def _twice(self, node: expressions.Application) -> str:
        """Return an argument that is written twice."""
        self._once(node)
        (inner,) = node.arguments
        assert inner is not None
        assert not isinstance(inner, expressions.FormatItem)
        return self.operand(inner, TIGHTEST)

    def _once(self, node: expressions.Application) -> None:
        """Refuse to work RANDOM and its like out twice."""
        waiting: list[object] = list(node.arguments)
        while waiting:
            part = waiting.pop()
            if isinstance(part, expressions.Application) or (
                isinstance(part, expressions.Name)
                and part.text.lower() in ("random", "here", "hand")
            ):
                headline = f"AS has no {node.name.text.upper()}, and its argument is a function"
                raise CannotWrite(
                    node.start, node.end, headline, "give the argument to a variable first"
                )
            if isinstance(part, tuple):
                waiting.extend(part)  # pyright: ignore[reportUnknownArgumentType]


def _is_named(item: expressions.Item) -> bool:
    """Return whether a location is a name, an element, or a compound of them."""
    match item:
        case expressions.Name(text):
            return text.lower() not in ("base", "tool", "here", "dest")
        case expressions.Element():
            return True
        case expressions.Infix(":", left, right):
            return _is_named(left) and _is_named(right)
        case _:
            return False


def _own(name: str) -> str:
    """Return the name of a variable that is a program's own."""
    return f".{name}"


def _by_reference(name: str) -> str:
    """Return a location as it is passed, and as it is received: the mark stands behind the dot."""
    return f".&{name[1:]}" if name.startswith(".") else f"&{name}"
