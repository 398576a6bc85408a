"""How loops are left: never, though steps stand behind them, or always in their first pass."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

from vrts.base.diagnostic import Label, Rule
from vrts.ir import instructions as i
from vrts.ir.expressions import Function
from vrts.ir.module import Program
from vrts.lang.findings.endless import ENDLESS_LOOP
from vrts.lang.findings.ways.breaks import BREAK_IN_LOOP
from vrts.lang.findings.ways.reached import ENDING, Endless, Reached, following
from vrts.lang.meaning.structure import Block, label_key
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Expression, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    Case,
    For,
    Goto,
    If,
    SetLocation,
    Simple,
    Statement,
    Structure,
    Until,
    ValueGroup,
    While,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS

ONE_PASS = Rule("V245", "one-pass-loop")

MOST_LOOKED_AT = 20_000  # instructions of loops that may only compute; no more are looked at then
_MARKS = (i.Jump, i.NextFor, i.TestFor, i.TestCase, i.Return)  # what END, ELSE, VALUE leave behind
_LAST = (i.Stop, i.Halt)  # written below an endless loop by habit
_COMPUTING = (Assignment, SetLocation, If, While, Until, For, Goto, Case, ValueGroup, Structure)
_DECIDING = (If, While, Until, For, Goto, Case, ValueGroup)
_F = Function
_ASKING = frozenset(  # functions that tell of what is outside of the program
    {_F.HERE, _F.HERE_JOINTS, _F.DEST, _F.DEST_JOINTS, _F.HAND, _F.SIG, _F.BITS, _F.TIMER, _F.SPEED}
    | {_F.SWITCH, _F.PARAMETER, _F.ADC, _F.PENDANT, _F.PRIORITY, _F.STATE, _F.STATUS, _F.ERROR}
    | {_F.DEFINED, _F.TAS, _F.CAS, _F.TIME, _F.ERROR_TEXT, _F.TIME_TEXT, _F.DATE_TEXT, _F.OPAQUE}
)


class LeavingCheck:
    """Looks at the loops of one program whose instructions are known."""

    def __init__(
        self, problems: Problems, text: ProgramText, program: Program, reached: Reached
    ) -> None:
        self.problems = problems
        self.text = text
        self.program = program
        self.reached = reached
        self.tests = {loop.test: loop for loop in reached.endless}
        self.told: set[int] = set()  # instructions that were told to be never reached
        self.left = MOST_LOOKED_AT

    @cached_property
    def steps(self) -> dict[int, Statement | None]:
        """Steps by their numbers."""
        return {step.number: step.statement for step in self.text.steps}

    def check(self, found: Sequence[Block], *, alone: bool) -> set[int]:
        """Warn of loops that are never left, or at once; return what was told never to be reached.

        Where a program runs beside another (not `alone`), what only computes may be of use.
        """
        idle = self._idle_jumps() if alone else ()
        for loop in self.reached.endless:
            if self._meant_to_break(loop, found):
                self.told.update(self._stretch(loop.behind))
                continue
            if loop.test in self.reached.instructions and not self._behind(loop) and alone:
                condition = "UNTIL n == 10" if loop.goes_on != loop.test + 1 else "WHILE n < 10 DO"
                self._computing(loop.goes_on, loop.condition, condition)
        for node, at in self._standing():
            self._stands(node, at)
        for node, at in idle:
            if self._computing(at, node, f"IF n < 10 GOTO {label_key(node.label)}"):
                self.told.update(self._stretch(at + 1))
        for block in found:
            if block.word in ("FOR", "WHILE"):
                self._one_pass(block)
        return self.told

    # --- loops that never end -------------------------------------------------------------------

    def _behind(self, loop: Endless) -> bool:
        """Warn where steps behind a loop are never reached; return whether there are any."""
        code = self.program.instructions
        stretch = self._stretch(loop.behind)
        lost = [at for at in stretch if not isinstance(code[at], _MARKS)]
        if lost and isinstance(code[lost[0]], _LAST):
            self.told.update(stretch)
            lost = []
        lost = lost or [at for at in stretch if isinstance(code[at], i.NextFor)]
        if not lost:
            return False
        self.told.update(stretch)
        condition = loop.condition
        while_ = loop.goes_on == loop.test + 1
        self.problems.warning(
            ENDLESS_LOOP,
            "this loop never ends: what stands behind it is never reached",
            condition.start,
            condition.end,
            "never lets it end",
            secondary=(Label(self.program.origins[lost[0]].span, "never reached"),),
            help=(
                f"write a condition, as in `{'WHILE n < 10 DO' if while_ else 'UNTIL n == 10'}`",
                "or leave the loop by `IF n == 10 GOTO 20`, with the label 20 behind it",
            ),
        )
        return True

    def _meant_to_break(self, loop: Endless, found: Sequence[Block]) -> bool:
        """Return whether a BREAK in a loop was told, by which its writer meant to leave it."""
        breaks = [
            told.primary.span.start
            for told in self.problems.found
            if told.rule == BREAK_IN_LOOP and told.primary is not None
        ]
        if not breaks:
            return False
        for block in found:
            opener, end = (self.text.steps[at].statement for at in (block.opener, block.end))
            if opener is None or end is None:
                continue
            start = opener.start if opener.start <= loop.condition.start else loop.condition.start
            if start <= loop.condition.start <= end.end and any(
                start <= at <= end.end for at in breaks
            ):
                return True
        return False

    def _stretch(self, at: int) -> list[int]:
        """Return the instructions from one on that are never reached."""
        stretch: list[int] = []
        while at < len(self.program.instructions) and at not in self.reached.instructions:
            stretch.append(at)
            at += 1
        return stretch

    def _idle_jumps(self) -> list[tuple[Goto, int]]:
        """Return the jumps back without a condition, and their instructions."""
        if all(step.label is None for step in self.text.steps):
            return []
        found: list[tuple[Goto, int]] = []
        code = self.program.instructions
        for step in self.text.steps:
            if isinstance(step.statement, Goto) and step.statement.condition is None:
                at = self.program.steps[step.number - 1]
                jump = code[at]
                if isinstance(jump, i.Jump) and jump.target <= at and self._is_reached(at):
                    found.append((step.statement, at))
        return found

    def _standing(self) -> list[tuple[Goto, int]]:
        """Return the jumps of steps to themselves, and their instructions."""
        found: list[tuple[Goto, int]] = []
        for step in self.text.steps:
            node = step.statement
            if step.label is None or not isinstance(node, Goto) or node.condition is not None:
                continue
            at = self.program.steps[step.number - 1]
            jump = self.program.instructions[at]
            if isinstance(jump, i.Jump) and jump.target == at and self._is_reached(at):
                found.append((node, at))
        return found

    def _stands(self, node: Goto, at: int) -> None:
        """Warn of `10 GOTO 10` with steps behind it that are never reached."""
        code = self.program.instructions
        stretch = self._stretch(at + 1)
        lost = [behind for behind in stretch if not isinstance(code[behind], _MARKS)]
        if not lost or isinstance(code[lost[0]], _LAST):
            return
        self.told.update(stretch)
        self.problems.warning(
            ENDLESS_LOOP,
            "this step jumps to itself for ever: what stands behind it is never reached",
            node.start,
            node.end,
            secondary=(Label(self.program.origins[lost[0]].span, "never reached"),),
            help=(
                "to wait for a signal write `WAIT SIG(1001)`",
                f"or go on by a condition, as in `IF SIG(-1001) GOTO {label_key(node.label)}`",
            ),
        )

    def _is_reached(self, at: int) -> bool:
        return at in self.reached.instructions

    def _computing(self, head: int, at_fault: Expression | Goto, condition: str) -> bool:
        """Warn of a loop for ever in which nothing waits, moves, or asks what is outside."""
        seen: set[int] = set()
        waiting = [head]
        decided: set[str] = set()  # names that conditions look at
        given: set[str] = set()
        computes = False  # a loop without any step is a way to stand still
        while waiting:
            at = waiting.pop()
            if at in seen:
                continue
            self.left -= 1
            instruction = self.program.instructions[at]
            node = self.steps.get(self.program.origins[at].step)
            leaves = type(instruction) in ENDING and not isinstance(instruction, i.Jump | i.NextFor)
            if leaves or self.left < 0 or not _only_computes(node):
                return False
            seen.add(at)
            waiting += following(self.program, at, self.tests)
            computes = computes or not isinstance(node, Goto | While | Until | Structure)
            if isinstance(node, _DECIDING):
                decided |= set(_names(node))
            target = getattr(node, "target", None)
            if isinstance(target, Name):
                given.add(key(target.text))
        if not computes or decided - given:
            return False  # something else may give them a value
        self.problems.warning(
            ENDLESS_LOOP,
            "this loop never ends, and nothing in it moves the arm or waits",
            at_fault.start,
            at_fault.end,
            "for ever",
            help=(
                f"write a condition that ends it, as in `{condition}`",
                "or wait in it, as in `WAIT SIG(1001)`",
            ),
        )
        return True

    # --- loops left in their first pass ---------------------------------------------------------

    def _one_pass(self, block: Block) -> None:
        opener, end = self.text.steps[block.opener], self.text.steps[block.end]
        first = self.program.steps[opener.number - 1]
        last = self.program.steps[end.number - 1]
        reached = self.reached.instructions
        if first not in reached or last in reached or opener.statement is None:
            return
        code = self.program.instructions
        leaving = -1
        for at in range(first, last):
            if at not in reached and not isinstance(code[at], _MARKS):
                return  # a step that is told to be never reached
            if at in reached and type(code[at]) in ENDING:
                leaving = at
        if leaving < 0:
            return
        word = _word(self.steps.get(self.program.origins[leaving].step))
        if not word:
            return
        self.problems.warning(
            ONE_PASS,
            "this loop never makes a second pass",
            opener.statement.start,
            opener.statement.end,
            "always left in its first pass",
            secondary=(Label(self.program.origins[leaving].span, f"{word} ends it"),),
            help=(f"put {word} under a condition, as in `IF SIG(1001) ...`, or remove the loop",),
        )


def _word(node: Statement | None) -> str:
    """Return the word of a step that leaves a loop."""
    if isinstance(node, Goto):
        return "GOTO"
    return node.word if isinstance(node, Simple) else ""


def _only_computes(node: Statement | None) -> bool:
    typed = isinstance(node, Simple) and node.word == "TYPE"
    if not (typed or isinstance(node, _COMPUTING)):
        return False
    return not any(_asks(name.text, applied=applied) for name, applied in _used(node))


def _asks(name: str, *, applied: bool) -> bool:
    """Return whether a name is a function that asks what is outside."""
    function = FUNCTIONS.get(name.lower())
    if function is None:
        return False
    return (applied or function.bare != "") and function.function in _ASKING


def _names(node: Statement) -> Iterator[str]:
    return (
        key(name.text)
        for name, applied in _used(node)
        if not applied and name.text.lower() not in CONSTANTS
    )


def _used(node: Any) -> Iterator[tuple[Name, bool]]:
    """Return the names in a step, and whether each is applied to arguments."""
    waiting: list[Any] = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Name):
            yield part, False
        elif isinstance(part, Application):
            yield part.name, True
            waiting += [a for a in part.arguments if a is not None]
        else:
            waiting += [inner for inner in part if isinstance(inner, tuple)]
