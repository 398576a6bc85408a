"""Loops whose condition nothing in them can change."""

from collections.abc import Sequence

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.findings.remarks import STEP_IN_REMARK
from vrts.lang.meaning.scope import Scope
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
)
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import (
    Bad,
    CallNamed,
    CallStatement,
    Device,
    Goto,
    ReactStatement,
    Rest,
    Simple,
    Statement,
    Until,
    While,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS

ENDLESS_LOOP = Rule("V222", "endless-loop")

MOST_STEPS = 1000  # of a loop; longer ones are not looked into
MOST_CALLED = 50  # programs that are followed from one loop
MOST_LOOKED_AT = 1_000_000  # steps of all loops; after that no more loops are looked into
_STARTERS = frozenset({"EXECUTE", "PCEXECUTE", "REACTE"})
_ENDINGS = frozenset({"STOP", "HALT", "PAUSE", "EXIT"})


class LoopCheck:
    """Warns of WHILE and DO loops that never end once they have begun.

    Not to be asked where `runs_beside`: another program may change what a loop waits for.
    """

    def __init__(self, problems: Problems, scope: Scope) -> None:
        self.problems = problems
        self.scope = scope
        self.left = MOST_LOOKED_AT

    def check(self, program: ProgramText, found: list[Block]) -> None:
        """Warn of the loops of a program."""
        for block in found:
            if block.word in ("WHILE", "DO") and self.left > 0:
                self._loop(program, block)

    def _loop(self, program: ProgramText, block: Block) -> None:
        """A loop whose condition nothing in the loop can change."""
        at = block.opener if block.word == "WHILE" else block.end
        node = program.steps[at].statement
        if not isinstance(node, While | Until):
            return
        names: list[Name] = []
        if not _fixed(node.condition, names) or not names:
            return
        if block.end - block.opener > MOST_STEPS:
            return
        body = program.steps[block.opener : block.end]
        if any(isinstance(step.statement, Bad) for step in body):
            return  # nobody knows what that changes
        changed = self._changed(program.steps[block.opener : block.end + 1])
        if changed is None:
            return
        keys = {key(name.text) for name in names}
        entries = [self.scope.entry(program.name, name) for name in keys]
        if changed & keys or {entry.type for entry in entries} != {Type.REAL}:
            return
        if not all(self.scope.may_have_value(entry) for entry in entries):
            return  # told there: a name that is never given a value
        if self._told(body):
            return
        ordered = list(dict.fromkeys(key(name.text) for name in names))
        shown = " or ".join(f"`{name}`" for name in ordered)
        first = ordered[0]
        self.problems.warning(
            ENDLESS_LOOP,
            "this loop never ends once it has begun"
            if block.word == "WHILE"
            else "this loop ends after one pass or never",
            node.condition.start,
            node.condition.end,
            f"nothing in the loop changes {shown}",
            help=(f"change {shown} in the loop, as in `{first} = {first}+1`",),
        )

    def _told(self, body: Sequence[Step]) -> bool:
        """Whether a step of a loop stands in a remark, which was told: it may be the change."""
        places = [step.statement for step in body if step.statement is not None]
        first, last = places[0].start, places[-1].end
        end = self.problems.source.text.find("\n", last)
        span = self.problems.span(first, end if end >= 0 else last)
        return any(
            told.rule == STEP_IN_REMARK
            and told.primary is not None
            and span.start <= told.primary.span.start < span.end
            for told in self.problems.found
        )

    def _changed(self, inside: Sequence[Step]) -> set[str] | None:
        """Return the names that steps and the programs they call may give a value.

        None when they may also leave the loop, or call a program that is not in the file.
        """
        changed: set[str] = set()
        called: list[str] = []  # programs, each once, in the order they are met
        if not self._collect(inside, changed, called, leaves=True):
            return None
        for name in called:  # grows
            program = self.scope.programs.get(name)
            if program is None or len(program.steps) > MOST_STEPS:
                return None
            if not self._collect(program.steps, changed, called, leaves=False):
                return None
        return changed

    def _collect(
        self, steps: Sequence[Step], changed: set[str], called: list[str], *, leaves: bool
    ) -> bool:
        """Add what steps change and call; False when they may end what is going on.

        GOTO and RETURN leave a loop only where they stand in it, not in what it calls.
        """
        self.left -= len(steps)
        if self.left < 0:
            return False
        for step in steps:
            node = step.statement
            if isinstance(node, Rest | Device | CallNamed) or (leaves and isinstance(node, Goto)):
                return False
            if isinstance(node, Simple):
                if node.word in _ENDINGS or (leaves and node.word == "RETURN"):
                    return False
                if node.word == "PROMPT":
                    changed |= {key(v.text) for v in node.operands if isinstance(v, Name)}
            target = getattr(node, "target", None)
            if isinstance(target, Name | Element):
                changed.add(_key_of(target))
            if isinstance(node, CallStatement):
                changed |= {_key_of(a) for a in node.arguments if isinstance(a, Name | Element)}
                name = key(node.program.text)
                if name not in called:
                    called.append(name)
                if len(called) > MOST_CALLED:
                    return False
        return True


def _key_of(node: Name | Element) -> str:
    return key((node if isinstance(node, Name) else node.name).text)


def runs_beside(programs: list[ProgramText]) -> bool:
    """Return whether a reaction or a second program may run between the steps of another."""
    return any(_starts(step.statement) for program in programs for step in program.steps)


def _starts(node: Statement | None) -> bool:
    if isinstance(node, (Simple, Device, Bad)):
        return node.word in _STARTERS
    return isinstance(node, ReactStatement)


def _fixed(node: Expression, names: list[Name]) -> bool:
    """Whether an expression depends on plain variables only; collects them."""
    match node:
        case Number() | Text():
            return True
        case Name():
            lower = node.text.lower()
            if lower in CONSTANTS:
                return True
            names.append(node)
            return not (lower in FUNCTIONS and FUNCTIONS[lower].bare) and node.text[0] not in "$#"
        case Parenthesised(inner):
            return _fixed(inner, names)
        case Prefix(_, operand):
            return _fixed(operand, names)
        case Infix():
            return _fixed(node.left, names) and _fixed(node.right, names)
        case Application() | Element():
            return False
