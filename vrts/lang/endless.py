"""Loops whose condition nothing in them can change."""

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.scope import Scope
from vrts.lang.structure import Block
from vrts.lang.syntax import (
    Application,
    CallNamed,
    CallStatement,
    Device,
    Element,
    Expression,
    Goto,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
    ProgramText,
    ReactStatement,
    Rest,
    Simple,
    Statement,
    Text,
    Until,
    While,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS

ENDLESS_LOOP = Rule("V222", "endless-loop")

MOST_STEPS = 1000  # of a loop; longer ones are not looked into
MOST_CALLED = 50  # programs that are followed from one loop
_STARTERS = frozenset({"PCEXECUTE", "REACTE"})
_ENDINGS = frozenset({"RETURN", "STOP", "HALT", "PAUSE", "EXIT"})


def check_loops(problems: Problems, scope: Scope, program: ProgramText, found: list[Block]) -> None:
    """Warn of WHILE and DO loops that never end once they have begun.

    Not to be asked where `runs_beside`: another program may change what a loop waits for.
    """
    for block in found:
        if block.word in ("WHILE", "DO"):
            _loop(problems, scope, program, block)


def runs_beside(programs: list[ProgramText]) -> bool:
    """Return whether a reaction or a second program may run between the steps of another."""
    return any(
        isinstance(step.statement, ReactStatement)
        or (isinstance(step.statement, Simple) and step.statement.word in _STARTERS)
        for program in programs
        for step in program.steps
    )


def _loop(problems: Problems, scope: Scope, program: ProgramText, block: Block) -> None:
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
    inside = [step.statement for step in program.steps[block.opener : block.end + 1]]
    changed = _changed(scope, inside, set())
    if changed is None:
        return
    keys = {key(name.text) for name in names}
    if changed & keys or any(scope.entry(program.name, k).type is not Type.REAL for k in keys):
        return
    ordered = list(dict.fromkeys(key(name.text) for name in names))
    shown = " or ".join(f"`{name}`" for name in ordered)
    first = ordered[0]
    problems.warning(
        ENDLESS_LOOP,
        "this loop never ends once it has begun"
        if block.word == "WHILE"
        else "this loop ends after one pass or never",
        node.condition.start,
        node.condition.end,
        f"nothing in the loop changes {shown}",
        help=(f"change {shown} in the loop, as in `{first} = {first}+1`",),
    )


def _changed(scope: Scope, steps: list[Statement | None], seen: set[str]) -> set[str] | None:
    """Return the names that steps and the programs they call may give a value.

    None when they may also leave the loop, or call a program that is not in the file.
    """
    changed: set[str] = set()
    for node in steps:
        if isinstance(node, Goto) and not seen:
            return None
        if isinstance(node, Rest | Device | CallNamed):
            return None
        if isinstance(node, Simple) and node.word == "PROMPT":
            changed |= {key(v.text) for v in node.operands if isinstance(v, Name)}
        if isinstance(node, Simple) and node.word in _ENDINGS - ({"RETURN"} if seen else set()):
            return None
        target = getattr(node, "target", None)
        if isinstance(target, Name | Element):
            changed.add(key((target if isinstance(target, Name) else target.name).text))
        if not isinstance(node, CallStatement):
            continue
        for argument in node.arguments:
            if isinstance(argument, Name | Element):
                changed.add(key((argument if isinstance(argument, Name) else argument.name).text))
        name = key(node.program.text)
        called = scope.programs.get(name)
        if called is None or len(seen) > MOST_CALLED or len(called.steps) > MOST_STEPS:
            return None
        if name not in seen:
            inner = _changed(scope, [s.statement for s in called.steps], seen | {name})
            if inner is None:
                return None
            changed |= inner
    return changed


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
