"""Questions about names that only the whole compilation answers."""

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import replace
from itertools import chain

from vrts.base.diagnostic import Edit, Fix, Rule
from vrts.ir.values import Type
from vrts.lang.findings.arguments import check_arguments
from vrts.lang.findings.calls import check_error_returns, check_reactions, named_as_word
from vrts.lang.findings.clashes import clash
from vrts.lang.findings.given_texts import report_given_texts
from vrts.lang.findings.names.jumps_by_number import mend_jumps_by_number
from vrts.lang.findings.names.misused_words import UNDEFINED_VARIABLE, report_misused_words
from vrts.lang.findings.names.unset import check_unset
from vrts.lang.findings.names.untaught import (
    NOT_GIVEN,
    TEACH,
    UNDEFINED_LOCATION,
    report_untaught,
)
from vrts.lang.findings.never_given import Guess, guess, only_of_itself, part_of_location
from vrts.lang.findings.relatives.operands import check_operands
from vrts.lang.meaning.agreement import settle_types
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.no_texts import report_no_texts
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import NAME_TRUNCATED, SIGNIFICANT, is_truncated, key
from vrts.lang.problems import LIMIT
from vrts.lang.spelling import nearest
from vrts.lang.syntax.expressions import Application, Expression, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import CallStatement
from vrts.lang.vocabulary.lookup import hardly_a_name

UNDEFINED_PROGRAM = Rule("V206", "undefined-program")
UNUSED_NAME = Rule("V225", "unused-name")

MOST_NAMES = 2000  # with more names than this none is suggested


def check_usage(resolver: Resolver, programs: list[ProgramText]) -> None:
    """Report what the uses of each name do not agree on, and what is never given a value."""
    decided = settle_types(resolver, programs)
    strings = report_given_texts(resolver)
    report_no_texts(resolver, strings)
    check_operands(resolver, programs)
    suggestions = _Suggestions(resolver)
    bodies = sorted((p.start, p.finish[1]) for p in programs)
    clashes = report_misused_words(resolver, programs)  # nothing more is said of them
    for entry in resolver.scope.all_entries():
        if clash(resolver, entry):
            clashes.add(id(entry))
        _truncated(resolver, entry)
    for program in programs:
        for step in program.steps:
            node = step.statement
            if not isinstance(node, CallStatement):
                continue
            called = resolver.scope.programs.get(key(node.program.text))
            if called is None:
                _undefined_program(resolver, node.program, suggestions)
            else:
                check_arguments(resolver, program, node, called, decided)
        named_as_word(resolver, program)
        check_unset(resolver, program)
    for entry in resolver.scope.all_entries():
        meant = entry.name[0] == "$" and entry.name[1:] in strings  # `name = "Ada"` gives it one
        if id(entry) not in clashes and entry.name not in resolver.bad_names and not meant:
            _without_value(resolver, entry, suggestions)
            if not resolver.problems.any_error:
                _without_use(resolver, entry, suggestions, bodies)
    _mend_parts(resolver, suggestions.parts)
    mend_jumps_by_number(resolver, programs)
    check_error_returns(resolver.problems, programs)
    check_reactions(resolver.problems, resolver.scope)
    for name in resolver.called:
        if key(name.text) not in resolver.scope.programs:
            _undefined_program(resolver, name, suggestions)
    if not resolver.problems.any_error:  # which comes first: locations may be taught elsewhere
        report_untaught(resolver.problems, suggestions.untaught)


class _Suggestions:
    """Did you mean: for as many names as are shown, and among not too many others."""

    def __init__(self, resolver: Resolver) -> None:
        self.entries = resolver.scope.all_entries()
        self.programs = list(resolver.scope.programs)
        self.left = LIMIT
        self.untaught: list[Entry] = []  # locations of which nothing better is known
        self.parts: dict[str, list[Entry]] = {}  # `pick.x`, `pick.z`, by the location

    def name(self, entry: Entry, among: Callable[[Entry], bool]) -> str | None:
        """Return the name most like that of an entry."""
        if not self._may_ask(len(self.entries)):
            return None
        return nearest(entry.name, [other.name for other in self.entries if among(other)])

    def program(self, name: str) -> str | None:
        """Return the program whose name is most like another."""
        return nearest(name, self.programs) if self._may_ask(len(self.programs)) else None

    def _may_ask(self, count: int) -> bool:
        self.left -= 1
        return self.left >= 0 and count <= MOST_NAMES


def _truncated(resolver: Resolver, entry: Entry) -> None:
    if all(len(name) <= SIGNIFICANT for name in entry.spellings) and all(
        end - start <= SIGNIFICANT for start, end in chain(entry.reads, entry.writes)
    ):
        return
    text = resolver.problems.source.text
    used: dict[str, Place] = {}  # where a program uses each spelling first
    steps = [at for at in entry.writes if text[at[0] : at[1]].lower() in entry.spellings]
    for place in sorted([*entry.reads, *steps]):
        name = text[place[0] : place[1]].partition("[")[0].rstrip()  # without its index
        used.setdefault(name.lower(), (place[0], place[0] + len(name)))
    spelled = {**entry.spellings, **used}
    long = [(at, name) for name, at in spelled.items() if is_truncated(name)]
    if not long:
        return
    long.sort()
    at, name = long[0]
    problems = resolver.problems
    if len(long) > 1:
        problems.warning(
            NAME_TRUNCATED,
            f"`{name}` and `{long[1][1]}` are the same variable",
            *at,
            secondary=(problems.label(*long[1][0], "the other name"),),
            notes=(f"only the first {SIGNIFICANT} characters of a name count",),
            help=(f"make them differ in their first {SIGNIFICANT} characters",),
        )
    else:
        problems.warning(
            NAME_TRUNCATED,
            f"only `{entry.name}` counts of `{name}`",
            *at,
            notes=(f"only the first {SIGNIFICANT} characters of a name count",),
            help=("choose a shorter name",),
        )


def _without_value(resolver: Resolver, entry: Entry, suggestions: _Suggestions) -> None:
    handed = () if entry.reads or resolver.problems.any_error else _handed(resolver, entry)
    if not entry.reads and not handed:
        return
    if resolver.scope.may_have_value(entry) and not only_of_itself(entry):
        return
    entry.reads.extend(handed)
    problems = resolver.problems
    if all(problems.source.line_of(at) in resolver.wrong_lines for at, _ in entry.reads):
        return  # the lines were reported
    location = entry.type in (Type.POSE, Type.JOINTS)
    mixed = not location and Type.POSE in entry.types
    if mixed and any(problems.source.line_of(at) in resolver.wrong_lines for at, _ in entry.reads):
        return  # a location that is used as a number in a line that was reported
    at = min(entry.reads)
    kind = "location" if location else "string" if entry.type is Type.STRING else "variable"
    upper = entry.name.upper()
    declared = entry.automatic or bool(entry.stored)
    if not declared and hardly_a_name(problems.source.text[at[0] : at[1]], resolver.dialect):
        for at in entry.reads:
            _keyword(resolver, at, upper, "a value")
        return
    part = part_of_location(resolver, entry)
    if part is not None and part[0] in suggestions.parts:
        suggestions.parts[part[0]].append(entry)  # of a location that was told
        return
    found = guess(
        resolver, entry, at, lambda: suggestions.name(entry, lambda other: _could_be(other, entry))
    )
    if location and found == (TEACH, at, None):
        suggestions.untaught.append(entry)
        return
    if upper in resolver.reserved and found.help.endswith("write it alone"):
        _mend_reserved(resolver, upper, found)
        return
    more = len(entry.reads) - 1
    if part is not None:
        suggestions.parts[part[0]] = [entry]
    problems.warning(
        UNDEFINED_LOCATION if location else UNDEFINED_VARIABLE,
        f"the {kind} `{entry.name}` is never given a value in this file",
        *found.at,
        notes=(
            *((f"used {more} more {'time' if more == 1 else 'times'}",) if more else ()),
            NOT_GIVEN,
        ),
        help=(found.help,),
        # it may have a value in the controller's memory, so this is a guess
        fix=problems.replace(*found.at, found.instead, sure=False) if found.instead else None,
        data={"name": entry.name},
    )


def _handed(resolver: Resolver, entry: Entry) -> tuple[Place, ...]:
    """Return where a name is handed to programs that all only look at it: `CALL fetch(feader)`."""
    formals = [resolver.scope.formal(passed) for passed in entry.passed]
    if entry.array is not None or entry.slot is not None:
        return ()
    if not all(formal is not None and formal.reads for formal in formals):
        return ()
    return tuple(passed.at for passed in entry.passed if passed.at[1])


def _mend_reserved(resolver: Resolver, upper: str, found: Guess) -> None:
    """`MOVE READY`: say in the one warning about READY what it is."""
    fix = resolver.problems.replace(*found.at, upper, sure=False) if found.instead else None
    for at, told in enumerate(resolver.problems.found):
        if told.rule == KEYWORD_AS_NAME and told.headline.startswith(f"{upper} "):
            resolver.problems.found[at] = replace(told, help=(found.help,), fix=fix)


def _mend_parts(resolver: Resolver, parts: dict[str, list[Entry]]) -> None:
    """Give the one warning about `pick.x`, `pick.y` the edits of all their places."""
    problems = resolver.problems
    for of, entries in parts.items():
        edits: list[Edit] = []
        for entry in entries:
            _, function = part_of_location(resolver, entry) or ("", "")
            if function:
                for place in sorted(set(entry.reads)):
                    edits += problems.replace(*place, f"{function}({of})").edits
        for at, told in enumerate(problems.found):
            if edits and told.rule == UNDEFINED_VARIABLE and told.data["name"] == entries[0].name:
                others = ", ".join(f"`{entry.name}`" for entry in entries[1:])
                notes = (f"likewise {others}", *told.notes) if others else told.notes
                fix = Fix.from_edits(sorted(edits, key=lambda edit: edit.span.start), sure=False)
                problems.found[at] = replace(told, notes=notes, fix=fix)


def _keyword(resolver: Resolver, at: Place, upper: str, wanted: str) -> None:
    """Report a keyword where a name belongs, and nothing says that it is one."""
    resolver.problems.error(
        KEYWORD_AS_NAME,
        f"{upper} is a word of the language, and no name",
        *at,
        f"{wanted} belongs here",
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"a step may begin with {upper}; variables and programs have other names",),
    )


def _without_use(
    resolver: Resolver, entry: Entry, suggestions: _Suggestions, bodies: list[tuple[int, int]]
) -> None:
    """Note a number or string that only ever gets values, by `=`."""
    if entry.reads or entry.passed or entry.asked or entry.slot is not None or not entry.writes:
        return
    if entry.type not in (Type.REAL, Type.STRING) or entry.changed or not entry.values:
        return
    if all(_is_taken_away(value) for value in entry.values):
        return
    if not all(_inside(bodies, at) for at, _ in entry.writes):
        return  # data that stands ready
    problems = resolver.problems
    part = part_of_location(resolver, entry)
    if part is not None:
        problems.warning(
            UNUSED_NAME,
            f"`{entry.name}` is a variable of its own: `{part[0]}` does not change",
            *min(entry.writes),
            help=(f"to move the location write `SET {part[0]} = SHIFT({part[0]} BY dx, dy, dz)`",),
            data={"name": entry.name},
        )
        return
    meant = suggestions.name(entry, lambda other: other is not entry and bool(other.reads))
    problems.note(
        UNUSED_NAME,
        f"`{entry.name}` is given a value and never used in this file",
        *min(entry.writes),
        help=(f"did you mean `{meant}`?",) if meant else (),
        data={"name": entry.name},
    )


def _is_taken_away(value: Expression) -> bool:
    """Whether a value is what `$DECODE` takes from a string: often only to be rid of it."""
    return isinstance(value, Application) and value.name.text.upper() == "$DECODE"


def _inside(bodies: list[tuple[int, int]], at: int) -> bool:
    """Return whether an offset lies in one of the programs, which are in order."""
    number = bisect_right(bodies, (at, at)) - 1
    return number >= 0 and bodies[number][0] <= at < bodies[number][1]


def _could_be(other: Entry, entry: Entry) -> bool:
    if other is entry or not (other.writes or other.slot is not None):
        return False
    return other.type is entry.type or Type.DYNAMIC in (other.type, entry.type)


def _undefined_program(resolver: Resolver, name: Name, suggestions: _Suggestions) -> None:
    problems = resolver.problems
    if "" in resolver.scope.programs:
        return  # it may be the one whose header has no name
    if hardly_a_name(name.text, resolver.dialect):
        _keyword(resolver, (name.start, name.end), name.text.upper(), "the name of a program")
        return
    meant = suggestions.program(key(name.text))
    entry = resolver.scope.entries.get(key(name.text))
    help_ = f"did you mean `{meant}`?" if meant else f"write `.PROGRAM {name.text}`"
    sure = True
    if name.text.endswith("."):
        meant = name.text.rstrip(".")
        sure = key(meant) in resolver.scope.programs
        help_ = f"the `.` belongs to the name: take it out, and write `CALL {meant}`"
    if entry is not None and entry.writes and entry.type is Type.POSE:
        meant, help_ = None, f"`{name.text}` is a location: write `MOVE {name.text}`"
    problems.warning(
        UNDEFINED_PROGRAM,
        f"there is no program `{name.text}` in this file",
        name.start,
        name.end,
        notes=("the controller says *Undefined program or variable name* when it gets here",),
        help=(help_,),
        fix=problems.replace(name.start, name.end, meant, sure=sure) if meant else None,
        data={"name": name.text.lower()},
    )
