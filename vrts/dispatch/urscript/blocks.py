"""Structure words as blocks of URScript."""

from typing import NamedTuple

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import condition_of
from vrts.dispatch.saying.stretches import step_of
from vrts.dispatch.urscript.steps import Steps
from vrts.dispatch.urscript.values import number
from vrts.ir import instructions as ir
from vrts.ir.expressions import Place

INDENT = "  "


class Open(NamedTuple):
    """A structure that is not closed yet."""

    word: str
    place: Place | None = None  # that a FOR counts with
    increment: str = ""
    groups: int = 0  # VALUE groups of a CASE so far
    variable: str = ""  # that keeps what a CASE chooses by


class Blocks:
    """Writes the structure words of one program, and knows what is open."""

    def __init__(self, steps: Steps) -> None:
        """Write with the expressions of the program's steps."""
        self.steps, self.values = steps, steps.values
        self.open: list[Open] = []
        self.named = 0

    @property
    def depth(self) -> int:
        """How far lines are moved in."""
        return len(self.open)

    def lines(self, word: str, found: list[ir.Instruction]) -> list[str]:
        """Return what a structure word becomes; whoever ends a loop lets other threads run."""
        match word:
            case "IF":
                text = self.values.condition(condition_of(found))
                self.open.append(Open(word))
                return [f"if {text}:"]
            case "WHILE":
                text = self.values.condition(condition_of(found))
                self.open.append(Open(word))
                return [f"while {text}:", INDENT + self.steps.mode.passes]
            case "DO":
                self.open.append(Open(word))
                return ["while True:", INDENT + self.steps.mode.passes]
            case "UNTIL":
                text = self.values.condition(condition_of(found))
                self.open.pop()
                return [f"  if {text}:", "    break", "  end", "end"]
            case "FOR":
                return self._for(found)
            case "CASE":
                case = next(i for i in found if isinstance(i, ir.BeginCase))
                self.named += 1
                chosen = f"case_{self.named}"
                self.open.append(Open(word, variable=chosen))
                return [f"local {chosen} = {self.values.real(case.selector)}"]
            case "VALUE":
                return self._group(found)
            case "ANY" | "ELSE":
                if self.open[-1].word == "CASE" and not self.open[-1].groups:
                    raise CannotSay("a CASE without VALUE", "leave it out")
                return ["else:"]
            case "END":
                return self._end()
            case _:
                raise CannotSay(f"URScript has nothing that means {word}")

    def _for(self, found: list[ir.Instruction]) -> list[str]:
        loop = next(i for i in found if isinstance(i, ir.BeginFor))
        by = step_of(loop)
        self.named += 1
        last = f"last_{self.named}"
        variable = self.values.place(loop.place)
        rows = [
            self.steps.given(loop.place, self.values.real(loop.first)),
            f"local {last} = {self.values.real(loop.last)}",
            f"while {variable} {'<=' if by > 0.0 else '>='} {last}:",
            INDENT + self.steps.mode.passes,
        ]
        self.open.append(Open("FOR", loop.place, number(by)))
        return rows

    def _group(self, found: list[ir.Instruction]) -> list[str]:
        group = next(i for i in found if isinstance(i, ir.TestCase))
        now = self.open[-1]
        tests = " or ".join(f"({now.variable} == {self.values.real(v)})" for v in group.values)
        word = "elif" if now.groups else "if"
        self.open[-1] = now._replace(groups=now.groups + 1)
        return [f"{word} {tests}:"]

    def _end(self) -> list[str]:
        now = self.open.pop()
        if now.word == "CASE" and not now.groups:
            raise CannotSay("a CASE without VALUE", "leave it out")
        if now.word == "FOR" and now.place is not None:
            more = f"{self.values.place(now.place)} + {now.increment}"
            return [INDENT + self.steps.given(now.place, more), "end"]
        return ["end"]

    def pass_over(self, word: str, depth: int) -> None:
        """Keep what is open in order behind a structure word that was refused."""
        if word in ("IF", "WHILE", "DO", "FOR", "CASE") and len(self.open) == depth:
            self.open.append(Open(word, groups=1))
        elif word in ("END", "UNTIL") and len(self.open) == depth and self.open:
            self.open.pop()


def never_empty(rows: list[str]) -> list[str]:
    """Return lines of which every block holds one."""
    found: list[str] = []
    opened: str | None = None  # indent of the line that began a block, while nothing stands in it
    for row in rows:
        words = row.strip()
        if not words.startswith("#"):
            if opened is not None and words.rstrip(":").split(" ")[0] in ("end", "elif", "else"):
                found.append(opened + INDENT + "sync()")
            opened = row[: len(row) - len(row.lstrip())] if words.endswith(":") else None
        found.append(row)
    return found
