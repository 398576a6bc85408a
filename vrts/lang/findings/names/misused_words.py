"""Words of the language where names stand: `TIMER = 0`, `t = TIMER`, `MOVE a: CLOSEI`, `OPEN HAND`.

As steps they are right, with a variable of that name; but nothing else gives it a value, or asks
for one, so that the word is surely meant.
"""

from vrts.base.diagnostic import Diagnostic, Rule, Severity
from vrts.ir.values import Type
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.roles import Role, role_of
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.steps.misread.hand_words import NAMES_OF_HAND
from vrts.lang.syntax.expressions import Element, Infix, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Assignment, Simple
from vrts.lang.vocabulary.function_forms import form_of
from vrts.lang.vocabulary.functions import FUNCTIONS, applied_functions
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.word import Word

UNDEFINED_VARIABLE = Rule("V205", "undefined-variable")

_HAND = frozenset({"OPEN", "OPENI", "CLOSE", "CLOSEI", "RELAX", "RELAXI"})
_ASKED = frozenset({"OPEN", "OPENI", "CLOSE", "CLOSEI"})
_GIVEN_BY_WORD = ("SPEED", "TIMER", "ACCEL", "DURATION", "DELAY", "DEPART", "DEPARTS")  # of V+
_SWITCHED = frozenset({"0", "1", "TRUE", "FALSE", "ON", "OFF", "HAND", "GRIPPER"})


def report_misused_words(resolver: Resolver, programs: list[ProgramText]) -> set[int]:
    """Report words in the places of names; return the ids of the entries that need no more."""
    if resolver.dialect.is_as or resolver.dialect.is_vplus:
        return _of_relatives(resolver)
    if resolver.dialect.tolerant or not resolver.dialect.has("2"):
        return set()
    told = _named_hands(resolver, programs)
    for entry in resolver.scope.entries.values():
        name = entry.name.upper()
        if name not in resolver.reserved or entry.passed or entry.asked or entry.slot is not None:
            continue
        word = INSTRUCTIONS.get(name)
        found = None
        if word is not None and entry.writes and not entry.reads:
            found = _given(resolver, entry, word)
        elif entry.reads and not resolver.scope.may_have_value(entry):
            found = _read(resolver, entry, word)
        if found is not None:
            _instead(resolver.problems, name, found)
            told.add(id(entry))
    return told


def _of_relatives(resolver: Resolver) -> set[int]:
    """Report `SIG[1004]` and `ABS -5` in V+ and AS: names of functions that nothing gives a value.

    Words of instructions are looked at where names without a value are told.
    """
    told: set[int] = set()
    for word in _GIVEN_BY_WORD if resolver.dialect.is_vplus else ():
        given = resolver.scope.entries.get(word.lower())
        if given is None or not given.writes or given.reads or given.asked or given.passed:
            continue
        found = _given(resolver, given, INSTRUCTIONS[word])
        if found is not None:
            resolver.problems.add(found)
            told.add(id(given))
    functions = applied_functions(resolver.dialect)
    for name in functions.keys() & resolver.scope.entries.keys():
        entry = resolver.scope.entries[name]
        if entry.passed or entry.asked or entry.slot is not None or not entry.reads:
            continue
        if resolver.scope.may_have_value(entry) or name in resolver.bad_names:
            continue
        found = _read(resolver, entry, None)
        if found is not None and found.fix is not None:
            resolver.problems.add(found)
            told.add(id(entry))
    return told


def _instead(problems: Problems, name: str, found: Diagnostic) -> None:
    """Say it in the place of the warning that the word names a variable."""
    start = f"{name} is a word of the language"
    for at, told in enumerate(problems.found):
        if told.rule == KEYWORD_AS_NAME and told.headline.startswith(start):
            problems.found[at] = found
            return


def _warning(
    problems: Problems, at: Place, headline: str, help_: str, instead: str | None
) -> Diagnostic:
    return Diagnostic(
        KEYWORD_AS_NAME,
        Severity.WARNING,
        headline,
        problems.label(*at),
        notes=("as it stands, this is a variable of that name",),
        help=(help_,),
        fix=problems.replace(*at, instead, sure=False) if instead is not None else None,
    )


def _given(resolver: Resolver, entry: Entry, word: Word) -> Diagnostic | None:
    """`TIMER = 0`, `SPEED = 50`: an instruction with `=`."""
    role = role_of(resolver.scope.programs.values(), min(entry.writes))
    if role is None or not isinstance(role.step, Assignment):
        return None
    step = role.step
    value = resolver.problems.source.text[step.value.start : step.value.end]
    at = (step.start, step.end)
    name = word.text
    if name == "TIMER":
        instead = f"TIMER 1 = {value}"
        return _warning(
            resolver.problems,
            at,
            "TIMER needs the number of a timer",
            f"write `{instead}`: there are several, from 1 on",
            instead,
        )
    if (len(word.operands) == 1 and word.terminal != "SET") or name in _HAND:
        instead = f"{name} {value}"
        if name in _HAND and value.upper() in _SWITCHED:
            instead = f"{name.removesuffix('I')}I"
        return _warning(
            resolver.problems,
            at,
            f"{name} takes no `=`",
            f"write `{instead}`",
            instead,
        )
    return _warning(resolver.problems, at, f"{name} takes no `=`", f"write `{word.usage}`", None)


def _read(resolver: Resolver, entry: Entry, word: Word | None) -> Diagnostic | None:
    """`t = TIMER`, `d = ABS -5`, `MOVE a: CLOSEI`."""
    problems = resolver.problems
    at = min(entry.reads)
    role = role_of(resolver.scope.programs.values(), at)
    if role is None:
        return None
    joined = isinstance(role.around, Infix) and role.around.operator == ":" and role.place
    if word is not None and joined:
        return _parted(problems, role, word)
    if word is not None and word.text in _ASKED and entry.type is not Type.POSE:
        return _asked_of_hand(problems, at, word)
    signature = FUNCTIONS.get(entry.name)
    if signature is None or entry.type is Type.POSE or not signature.required:
        return None
    form = form_of(signature)
    name = signature.name.upper()
    element = isinstance(role.node, Element) and bool(role.node.subscripts)
    if name == "TIMER" and not element:
        form = instead = "TIMER(1)"
        return _warning(problems, at, "TIMER needs a number behind it", f"write `{form}`", instead)
    if isinstance(role.node, Element) and role.node.subscripts:  # `DX[p]`
        node = role.node
        inside = problems.source.text[node.name.end : node.end].strip()[1:-1]
        resolver.wrong_lines.add(problems.source.line_of(at[0]))
        instead = f"{name}({inside})"
        headline = f"{name} takes parentheses, not brackets"
        return _warning(problems, (node.start, node.end), headline, f"write `{instead}`", instead)
    around = role.around
    if isinstance(around, Infix) and around.operator == "-" and not role.place:
        behind = problems.source.text[around.operator_start : around.right.end]
        instead = f"{name}({behind})"
        place = (at[0], around.right.end)
        headline = f"{name} without parentheses: a variable, and what follows is taken from it"
        return _warning(problems, place, headline, f"write `{instead}`", instead)
    return _warning(problems, at, f"{name} without parentheses", f"write `{form}`", None)


def _asked_of_hand(problems: Problems, at: Place, word: Word) -> Diagnostic:
    """`IF CLOSE THEN`, `WAIT OPEN`: an instruction asked how the hand stands."""
    closed = word.text.startswith("CLOSE")
    return _warning(
        problems,
        at,
        f"{word.text} moves the hand, and does not tell how it stands",
        "HAND tells how far the hand is open: write "
        + ("`HAND == 0` for quite closed" if closed else "`HAND > 0` for open"),
        None,
    )


def _parted(problems: Problems, role: Role, word: Word) -> Diagnostic:
    """`MOVE a: CLOSEI`, in which the colon makes a compound."""
    source = problems.source
    step, colon = role.step, role.around.operator_start
    before = source.text[step.start : colon].strip()
    behind = source.text[colon + 1 : step.end].strip()
    begin = source.text.rfind("\n", 0, step.start) + 1
    indent = " " * (step.start - begin)
    return _warning(
        problems,
        (step.start + len(before), step.end),
        f"`:` makes a compound of locations: it does not part {before.split()[0].upper()}"
        f" from {word.text}",
        f"write each on a line of its own: `{before}`, then `{behind}`",
        f"\n{indent}{behind}",
    )


def _named_hands(resolver: Resolver, programs: list[ProgramText]) -> set[int]:
    """Report `OPEN GRIPPER`, which takes an opening in mm."""
    told: set[int] = set()
    for program in programs:
        for step in program.steps:
            node = step.statement
            if not isinstance(node, Simple) or node.word not in _HAND or not node.operands:
                continue
            operand = node.operands[0]
            if not isinstance(operand, Name) or operand.text.lower() not in NAMES_OF_HAND:
                continue
            if operand.text.upper() != "HAND":  # which is a function
                entry = resolver.scope.entry(program.name, key(operand.text))
                if resolver.scope.may_have_value(entry) or entry.slot is not None:
                    continue
                told.add(id(entry))
            _named_hand(resolver.problems, node, operand)
    return told


def _named_hand(problems: Problems, node: Simple, operand: Name) -> None:
    word = node.word.removesuffix("I")
    note = "HAND is how far the hand is open now" if operand.text.upper() == "HAND" else ""
    problems.warning(
        UNDEFINED_VARIABLE,
        f"{node.word} has no name behind it: there is only one hand",
        operand.start,
        operand.end,
        "taken for an opening in mm",
        notes=(note,) if note else (),
        help=(f"write `{word}I`: it acts at once, and waits for the hand",),
        fix=problems.replace(node.start, node.end, f"{word}I", sure=False),
        data={"name": operand.text.lower()},
    )
