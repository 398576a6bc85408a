"""Names that are used as two things: a number and a location, an array and a single value."""

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.findings.mixed_kinds import Remedy, a_location_is_wanted, a_number_is_wanted
from vrts.lang.meaning.agreement import type_of_argument
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.roles import role_of
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Expression, FormatItem, Infix, Item, Name
from vrts.lang.syntax.statements import Simple

REAL_AND_LOCATION = Rule("V201", "real-and-location")
ARRAY_AND_SCALAR = Rule("V213", "array-and-scalar")

_WORDS = {Type.REAL: "a number", Type.POSE: "a location"}


def clash(resolver: Resolver, entry: Entry) -> bool:
    """Report a name whose uses do not agree; return whether there is one."""
    if Type.REAL in entry.types and Type.POSE in entry.types:
        return _real_and_location(resolver, entry)
    if entry.array is not None and entry.scalar is not None:
        _array_and_scalar(resolver, entry, entry.array, entry.scalar)
        return True
    return False


def _real_and_location(resolver: Resolver, entry: Entry) -> bool:
    problems = resolver.problems
    if resolver.dialect.is_as and entry.slot is None:
        entry.both = True  # numbers and locations of AS have names of their own
        return False
    lines = {problems.source.line_of(place[0]) for place in entry.types.values()}
    if lines & resolver.wrong_lines:
        return True  # said there
    wrong, at, known = _wrong_one(resolver, entry)
    right = Type.POSE if wrong is Type.REAL else Type.REAL
    remedy = _remedy(resolver, wrong, at, known)
    if entry.given.get(Type.POSE) is None and any(_counts(entry, v) for v in entry.values):
        count = f"{entry.name}.count"
        help_ = f"give the number another name, as in `{count} = {count}+1`, wherever it is meant"
        remedy = remedy._replace(help=(help_,), fix=None)
    later = entry.given.get(Type.REAL)
    if later is not None and _was_location_before(resolver, entry, later):
        wrong, at, right = Type.REAL, later, Type.POSE
        help_ = f"give the number another name: `{entry.name}` is a location above"
        remedy = Remedy("a number here", (help_,))
    problems.error(
        REAL_AND_LOCATION,
        f"`{entry.name}` is used both as a number and as a location",
        *at,
        remedy.label,
        secondary=(problems.label(*entry.types[right], f"{_WORDS[right]} here"),),
        notes=("numbers and locations share their names", "VAL-II says *Mixing of types*"),
        help=remedy.help,
        fix=remedy.fix,
        data={"name": entry.name},
    )
    resolver.wrong_lines.add(problems.source.line_of(at[0]))
    return True


def _was_location_before(resolver: Resolver, entry: Entry, given: Place) -> bool:
    """Whether a name is only a location above the step that first gives it a number."""
    if entry.given.get(Type.POSE) is not None or len(entry.values) != len(entry.writes):
        return False
    if any(_counts(entry, value) for value in entry.values):
        return False  # a count of what stands there, which is told so
    location = entry.types[Type.POSE]
    programs = resolver.scope.programs.values()
    return entry.types[Type.REAL] == given and any(
        p.start <= location[0] < given[0] < p.finish[1] for p in programs
    )


def _counts(entry: Entry, value: Expression) -> bool:
    """Whether a value adds to what a name holds: `part+1` for `part`."""
    if not isinstance(value, Infix) or value.operator not in ("+", "-"):
        return False
    return isinstance(value.left, Name) and key(value.left.text) == entry.name


def _wrong_one(resolver: Resolver, entry: Entry) -> tuple[Type, Place, bool]:
    """Return as what a name should not be used, where it is, and whether that is known."""
    number, location = entry.types[Type.REAL], entry.types[Type.POSE]
    given_number, given_location = (entry.given.get(kind) for kind in (Type.REAL, Type.POSE))
    if given_location is not None and given_number is None:
        return Type.REAL, number, True
    if given_number is not None and given_location is None and _only_asked(resolver, entry):
        return Type.REAL, given_number, True  # PROMPT alone takes it for a number
    if given_number is not None and given_location is None:
        return Type.POSE, location, True
    if given_number is not None and given_location is not None:
        if not _in_program(resolver, given_location):
            return Type.REAL, given_number, True  # a location that stands ready
        if not _in_program(resolver, given_number):
            return Type.POSE, given_location, True
    later = Type.REAL if number > location else Type.POSE
    return later, entry.types[later], False


def _only_asked(resolver: Resolver, entry: Entry) -> bool:
    """Whether PROMPT alone takes a name for a number: `PROMPT "Where? ", goal`, `MOVE goal`."""
    role = role_of(resolver.scope.programs.values(), entry.types[Type.REAL])
    asked = role is not None and isinstance(role.step, Simple) and role.step.word == "PROMPT"
    return asked and len(entry.writes) == 1


def _remedy(resolver: Resolver, wrong: Type, at: Place, known: bool) -> Remedy:
    """Return what helps at a place; where neither use is known to be right, another name."""
    role = role_of(resolver.scope.programs.values(), at) if known else None
    if role is None:
        return Remedy(f"{_WORDS[wrong]} here", ("give one of them another name",))

    def type_of(node: Item) -> Type:
        if not isinstance(node, FormatItem) and resolver.is_location(node):
            return Type.POSE
        return type_of_argument(resolver, role.program, node)

    wanted = a_number_is_wanted if wrong is Type.REAL else a_location_is_wanted
    return wanted(resolver.problems, role, type_of)


def _array_and_scalar(resolver: Resolver, entry: Entry, array: Place, scalar: Place) -> None:
    problems = resolver.problems
    if problems.source.line_of(scalar[0]) in resolver.wrong_lines:
        return  # `LEN(values)`: said there
    first, second = sorted((array, scalar), key=lambda place: (_in_program(resolver, place), place))
    given = _given_without_index(resolver, entry)
    if given is not None:  # and read with one: an element is meant there
        first, second = array, given
    help_ = f"write an index, as in `{entry.name}[1]`, or give one of them another name"
    if entry.type is Type.STRING:
        help_ = f"`$MID({entry.name}, 1, 1)` takes a character out of a string; "
        help_ += "give an array of strings another name"
    problems.error(
        ARRAY_AND_SCALAR,
        f"`{entry.name}` is used both with and without an index",
        *second,
        secondary=(problems.label(*first, "first used here"),),
        help=(help_,),
        data={"name": entry.name},
    )


def _given_without_index(resolver: Resolver, entry: Entry) -> Place | None:
    """Return where an array that is read by its index is given one value, and no element is."""
    text = resolver.problems.source.text
    if entry.type is Type.STRING:
        return None  # a character of it is meant
    if entry.passed or entry.asked or len(entry.values) != len(entry.writes) or not entry.values:
        return None
    indexed = all(text[start:end].rstrip().endswith("]") for start, end in entry.reads)
    if not entry.reads or not indexed or len(entry.writes) > 1:
        return None
    place = entry.writes[0]
    return place if _in_program(resolver, place) else None


def _in_program(resolver: Resolver, place: Place) -> bool:
    programs = resolver.scope.programs.values()
    return any(program.start <= place[0] < program.finish[1] for program in programs)
