"""Variables that count a FOR loop and are changed in it: by hand, by another loop, by a CALL."""

from collections.abc import Callable, Collection, Sequence

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.meaning.scope import Scope
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Expression, Infix, Name, Number
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    Simple,
    Statement,
)

LOOP_VARIABLE = Rule("V246", "loop-variable-changed")

_MAY_COUNT = (For, CallStatement, Assignment, Simple)  # statements that may change a number
_SPARE = ("i", "j", "k", "m", "n", "row", "column")  # names for another variable


class _Open:
    """The structures around a step, the outermost first."""

    def __init__(self) -> None:
        self._blocks: list[tuple[Block, str, For | None]] = []
        self._loops: dict[str, list[tuple[int, For]]] = {}  # by name: at which depth, which loop

    def __bool__(self) -> bool:
        return bool(self._blocks)

    def enter(self, block: Block, node: Statement | None) -> None:
        """Go into a structure that a step opens."""
        loop = node if isinstance(node, For) and _name(node.target) else None
        name = "" if loop is None else _name(loop.target)
        if loop is not None:
            self._loops.setdefault(name, []).append((len(self._blocks), loop))
        self._blocks.append((block, name, loop))

    def leave_before(self, at: int) -> None:
        """Leave all that have ended when a step is come to."""
        while self._blocks and self._blocks[-1][0].end <= at:
            _, name, loop = self._blocks.pop()
            if loop is not None:
                self._loops[name].pop()
                if not self._loops[name]:
                    del self._loops[name]

    @property
    def innermost(self) -> tuple[str, For | None]:
        """The variable and the loop, where the innermost structure is a FOR that has one."""
        return self._blocks[-1][1:]

    def loop(self, name: str) -> For | None:
        """Return the innermost loop that a variable counts."""
        found = self._loops.get(name)
        return found[-1][1] if found else None

    def counting(self, names: Collection[str]) -> list[str]:
        """Return which of some variables count loops, by the outermost loop of each."""
        return sorted(self._loops.keys() & names, key=lambda name: self._loops[name][0][0])


class CountingCheck:
    """Looks at the FOR loops of a compilation.

    `changed_by` tells which variables the CALL of a program may change; None: it is not known.
    """

    def __init__(
        self,
        problems: Problems,
        scope: Scope,
        changed_by: Callable[[str], frozenset[str] | None],
    ) -> None:
        self.problems = problems
        self.scope = scope
        self.changed_by = changed_by

    def check(self, program: ProgramText, found: Sequence[Block]) -> None:
        """Warn of what changes the variable of a FOR loop around it."""
        loops = [block for block in found if block.word == "FOR"]
        if not loops:
            return
        opened = {block.opener: block for block in found}
        first = min(block.opener for block in loops)
        last = max(block.end for block in loops)
        around = _Open()
        for at in range(first, last):
            around.leave_before(at)
            node = program.steps[at].statement
            if around and isinstance(node, _MAY_COUNT):
                self._step(program, node, around)
            if at in opened:
                around.enter(opened[at], node)

    def _step(self, program: ProgramText, node: Statement, around: _Open) -> None:
        if isinstance(node, For):
            name = _name(node.target)
            outer = around.loop(name)
            if outer is not None:
                self._inner(program, node, name, outer)
            return
        if isinstance(node, CallStatement):
            self._call(program, node, around)
            return
        name, loop = around.innermost
        if loop is None:
            return  # under a condition: it may well be meant
        if isinstance(node, Assignment) and _name(node.target) == name:
            self._by_hand(node, name, loop)
        elif isinstance(node, Simple) and node.word == "PROMPT":
            for operand in node.operands:
                if isinstance(operand, Name) and key(operand.text) == name:
                    self._prompted(operand, name, loop)

    def _inner(self, program: ProgramText, node: For, name: str, loop: For) -> None:
        spare = next(
            (n for n in _SPARE if n not in self.scope.entries and n not in program_names(program)),
            f"{name}2",
        )
        self.problems.warning(
            LOOP_VARIABLE,
            f"`{name}` counts the loop around this one, too",
            node.target.start,
            node.target.end,
            "changes it",
            secondary=(self.problems.label(loop.start, loop.end, f"`{name}` counts this loop"),),
            notes=(
                "the outer loop goes on from where the inner one ends: too few passes, or no end",
            ),
            help=(f"count with another variable here, as in `FOR {spare} = ...`",),
        )

    def _by_hand(self, node: Assignment, name: str, loop: For) -> None:
        problems = self.problems
        written = problems.source.text[node.start : node.end]
        self.problems.warning(
            LOOP_VARIABLE,
            f"`{name}` counts this loop, and is changed in it",
            node.start,
            node.end,
            "in each pass",
            secondary=(problems.label(loop.start, loop.end, f"`{name}` counts this loop"),),
            notes=("FOR changes its variable by itself at the end of each pass",),
            help=(f"remove `{written}`, or give another variable the value",),
            fix=_removed(problems, node) if _one_more(node.value, name, loop) else None,
        )

    def _prompted(self, node: Name, name: str, loop: For) -> None:
        problems = self.problems
        problems.warning(
            LOOP_VARIABLE,
            f"`{name}` counts this loop, and is changed in it",
            node.start,
            node.end,
            "in each pass",
            secondary=(problems.label(loop.start, loop.end, f"`{name}` counts this loop"),),
            help=("read the answer into another variable",),
        )

    def _call(self, program: ProgramText, node: CallStatement, around: _Open) -> None:
        called = key(node.program.text)
        changed = self.changed_by(called)
        if changed is None:
            return
        passed = self._passed(node)
        formals = self.scope.formals[program.name]
        for name in around.counting(changed | passed.keys()):
            loop = around.loop(name)
            if name in formals or loop is None:
                continue
            secondary = (self.problems.label(loop.start, loop.end, f"`{name}` counts this loop"),)
            if name in passed:
                text = passed[name].text
                self.problems.warning(
                    LOOP_VARIABLE,
                    f"`{called}` changes its argument: here that is `{name}`, which counts a loop",
                    passed[name].start,
                    passed[name].end,
                    secondary=secondary,
                    help=(f"pass only the value: write `({text})`",),
                    fix=self.problems.replace(
                        passed[name].start, passed[name].end, f"({text})", sure=False
                    ),
                )
            else:
                self.problems.warning(
                    LOOP_VARIABLE,
                    f"`{called}` changes `{name}`, which counts this loop",
                    node.start,
                    node.end,
                    secondary=secondary,
                    notes=("all programs share their variables, except for their arguments",),
                    help=(f"use another variable in `{called}`, or another one to count here",),
                )
            return

    def _passed(self, node: CallStatement) -> dict[str, Name]:
        """Return the arguments that a program gets by their names, and changes."""
        program = self.scope.programs.get(key(node.program.text))
        found: dict[str, Name] = {}
        if program is None:
            return found
        for argument, formal in zip(node.arguments, program.formals, strict=False):
            if isinstance(argument, Name) and formal.name.text:
                entry = self.scope.formals[program.name].get(key(formal.name.text))
                if entry is not None and entry.writes:
                    found.setdefault(key(argument.text), argument)
        return found


def program_names(program: ProgramText) -> set[str]:
    """Return the names of the arguments of a program."""
    return {key(formal.name.text) for formal in program.formals if formal.name.text}


def _name(node: Expression) -> str:
    return key(node.text) if isinstance(node, Name) else ""


def _one_more(value: Expression, name: str, loop: For) -> bool:
    """Whether this is the `i = i+1` that other languages want in their loops."""
    match value:
        case Infix("+", Name(text), Number(number)):
            return key(text) == name and number == 1.0 and loop.increment is None
        case _:
            return False


def _removed(problems: Problems, node: Statement) -> Fix | None:
    """Return the edit that takes out a line on which a step stands alone."""
    text = problems.source.text
    start = text.rfind("\n", 0, node.start) + 1
    finish = text.find("\n", node.end) + 1
    alone = finish and not text[start : node.start].strip() and not text[node.end : finish].strip()
    return problems.replace(start, finish, "", sure=False) if alone else None
