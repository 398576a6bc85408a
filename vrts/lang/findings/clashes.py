"""Names that are used as two things: a number and a location, an array and a single value."""

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place

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
    wrong, help_ = _wrong_one(entry)
    right = Type.POSE if wrong is Type.REAL else Type.REAL
    problems.error(
        REAL_AND_LOCATION,
        f"`{entry.name}` is used both as a number and as a location",
        *entry.types[wrong],
        f"{_WORDS[wrong]} here",
        secondary=(problems.label(*entry.types[right], f"{_WORDS[right]} here"),),
        notes=("numbers and locations share their names", "VAL-II says *Mixing of types*"),
        help=(help_,),
        data={"name": entry.name},
    )
    return True


def _wrong_one(entry: Entry) -> tuple[Type, str]:
    """Return as what a name should not be used, by what it is given, and what helps."""
    number, location = entry.types[Type.REAL], entry.types[Type.POSE]
    given_number = bool(entry.values) or number in entry.writes
    if number in entry.reads and entry.writes and not given_number:
        name = entry.name
        return Type.REAL, f"`DX({name})`, `DY({name})` and `DZ({name})` are its coordinates"
    if location in entry.reads and number in entry.writes:
        return Type.POSE, "name a location, or write `TRANS(x, y, z, o, a, t)`"
    later = Type.REAL if number > location else Type.POSE
    return later, "give one of them another name"


def _array_and_scalar(resolver: Resolver, entry: Entry, array: Place, scalar: Place) -> None:
    problems = resolver.problems
    first, second = sorted((array, scalar), key=lambda place: (_in_program(resolver, place), place))
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


def _in_program(resolver: Resolver, place: Place) -> bool:
    programs = resolver.scope.programs.values()
    return any(program.start <= place[0] < program.finish[1] for program in programs)
