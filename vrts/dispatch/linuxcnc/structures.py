"""Structure words of VAL-II as O-words: IF, WHILE, DO, FOR and CASE."""

from typing import NamedTuple

from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.linuxcnc.steps import Steps
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import condition_of, constant
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Slot

OPENERS = frozenset({"IF", "WHILE", "DO", "FOR", "CASE"})
CLOSERS = frozenset({"END", "UNTIL"})


class Open(NamedTuple):
    """A structure that is not closed yet."""

    word: str  # IF, WHILE, FOR, CASE, DO
    label: int
    variable: str = ""  # that a FOR counts with
    increment: str = ""
    groups: int = 0  # VALUE groups of a CASE so far


class Structures:
    """Writes the structure words of one program, and knows what is open."""

    def __init__(self, steps: Steps) -> None:
        """Write with the expressions of the program's steps."""
        self.steps = steps
        self.open: list[Open] = []

    @property
    def depth(self) -> int:
        """How far lines are moved in."""
        return len(self.open)

    def write(self, word: str, found: list[ir.Instruction]) -> None:
        """Write a structure word.

        Args:
            word: The word.
            found: The instructions that its step became.

        Raises:
            CannotSay: G-code has no such structure.
        """
        match word:
            case "IF":
                condition = self.steps.values.condition(condition_of(found))
                label = self._opened("IF")
                self.steps.lines.append(f"o{label} if {condition}")
            case "WHILE":
                self._while(condition_of(found))
            case "DO":
                self.steps.lines.append(f"o{self._opened('DO')} do")
            case "UNTIL":
                condition = self.steps.values.condition(condition_of(found))
                self.steps.lines.append(f"o{self.open.pop().label} while [{condition} EQ 0]")
            case "FOR":
                self._for(found)
            case "CASE":
                self._case(found)
            case "VALUE":
                self._group(found)
            case "ANY" | "ELSE":
                self.steps.lines.append(f"o{self.open[-1].label} else")
            case "END":
                self._end()
            case _:
                raise CannotSay(f"G-code has nothing that means {word}")

    def pass_over(self, word: str, depth: int) -> None:
        """Keep what is open in order behind a structure word that was refused.

        Args:
            word: The word.
            depth: How much was open before it.
        """
        if word in OPENERS and len(self.open) == depth:
            self.open.append(Open(word, 0, groups=1))
        elif word in CLOSERS and len(self.open) == depth:
            self.open.pop()

    def _opened(self, word: str) -> int:
        label = self.steps.label()
        self.open.append(Open(word, label))
        return label

    def _while(self, condition: Expression) -> None:
        lines = self.steps.lines
        begun = len(lines)
        text = self.steps.values.condition(condition)
        first, lines[begun:] = lines[begun:], []
        label = self._opened("WHILE")
        if not first:
            lines.append(f"o{label} while {text}")
            return
        inner = self.steps.label()
        lines.extend((f"o{label} while [1]", *first, f"o{inner} if [{text} EQ 0]"))
        lines.extend((f"  o{label} break", f"o{inner} endif"))

    def _for(self, found: list[ir.Instruction]) -> None:
        loop = next(i for i in found if isinstance(i, ir.BeginFor))
        if isinstance(loop.place.variable, Slot):
            raise CannotSay("a FOR counts with an argument", "count with another variable")
        by = 1.0 if loop.increment is None else constant(loop.increment)
        if by is None or by == 0.0:
            raise CannotSay("the step of a FOR is worked out in the run", "write a number")
        values, lines = self.steps.values, self.steps.lines
        first, last = values.real(loop.first), values.real(loop.last)
        label = self.steps.label()
        variable = values.place(loop.place)
        lines.append(f"{variable} = {first}")
        if constant(loop.last) is None:
            lines.append(f"#<last{label}> = {last}")
            last = f"#<last{label}>"
        lines.append(f"o{label} while [{variable} {'LE' if by > 0.0 else 'GE'} {last}]")
        self.open.append(Open("FOR", label, variable, number(by)))

    def _case(self, found: list[ir.Instruction]) -> None:
        case = next(i for i in found if isinstance(i, ir.BeginCase))
        label = self._opened("CASE")
        self.steps.lines.append(f"#<case{label}> = {self.steps.values.real(case.selector)}")

    def _group(self, found: list[ir.Instruction]) -> None:
        group = next(i for i in found if isinstance(i, ir.TestCase))
        now = self.open[-1]
        before = len(self.steps.lines)
        values = [self.steps.values.real(value) for value in group.values]
        if len(self.steps.lines) > before and now.groups:
            raise CannotSay("a VALUE is worked out in the run", "write numbers")
        tests = " OR ".join(f"[#<case{now.label}> EQ {value}]" for value in values)
        word = "elseif" if now.groups else "if"
        self.steps.lines.append(f"o{now.label} {word} [{tests}]")
        self.open[-1] = now._replace(groups=now.groups + 1)

    def _end(self) -> None:
        lines, now = self.steps.lines, self.open.pop()
        if now.word == "FOR":
            lines.append(f"  {now.variable} = [{now.variable} + {now.increment}]")
        if now.word == "CASE" and not now.groups:
            raise CannotSay("a CASE without VALUE", "leave it out")
        ending = {"FOR": "endwhile", "WHILE": "endwhile"}.get(now.word, "endif")
        lines.append(f"o{now.label} {ending}")
