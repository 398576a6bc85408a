"""Mistakes in names, arguments, indices, loops, conditions and expressions."""

from itertools import pairwise
from random import Random

from tests.mutants.kinds.sites import (
    MOTIONS,
    Kind,
    constants,
    known_places,
    locations,
    of,
    parts,
    parts_of,
    put,
    simple,
)
from tests.mutants.reading import Written, WrittenProgram
from vrts.lang.syntax.expressions import Application, Element, Infix, Name, Number
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    If,
    SetLocation,
    Until,
    While,
)

OTHER_WAY = {
    "<": (">", "<=", "=="), "<=": ("<", ">=", "=="), ">": ("<", ">=", "=="),
    ">=": (">", "<=", "=="), "==": ("<>", "<", ">"), "<>": ("==", "<", ">"),
    "+": ("-", "*"), "-": ("+",), "*": ("/", "+"), "/": ("*",), "AND": ("OR",), "OR": ("AND",),
}  # fmt: skip


def location(written: Written, chance: Random) -> str | None:
    """Another location than the one meant."""
    site = of(chance, _used(written))
    if site is None:
        return None
    program, name = site
    others = [n for n in known_places(written, program) if n.lower() != name.text.lower()]
    return put(written.text, (name.start, name.end, chance.choice(others)))


def misspelt(written: Written, chance: Random) -> str | None:
    """A name mistyped in one place: a letter left out, doubled, exchanged; a wrong number."""
    rows = [row.target for row in locations(written) if isinstance(row.target, Name)]
    name = of(chance, [*(name for _, name in _used(written)), *rows])
    if name is None or len(name.text) < 3:
        return None
    letters = list(name.text)
    at = chance.randrange(1, len(letters) - 1)
    match chance.randrange(4):
        case 0:
            del letters[at]
        case 1:
            letters.insert(at, letters[at])
        case 2:
            letters[at], letters[at + 1] = letters[at + 1], letters[at]
        case _:
            letters.append(chance.choice("s1"))
    return put(written.text, (name.start, name.end, "".join(letters)))


def argument(written: Written, chance: Random) -> str | None:
    """A wrong number as an argument of a CALL."""
    sites = [n for _, call in parts_of(written, CallStatement) for n in _numbers(call)]
    site = of(chance, sites)
    if site is None:
        return None
    value = site.value * chance.choice((-1, 0.1, 0.25, 0.5, 2, 3, 10))
    return put(written.text, (site.start, site.end, f"{value:g}"))


def exchanged_arguments(written: Written, chance: Random) -> str | None:
    """Two arguments of a CALL exchanged, or two formal arguments."""
    calls = [call.arguments for _, call in parts_of(written, CallStatement)]
    formals = [tuple(formal.name for formal in program.formals) for program in written.programs]
    pairs = [
        (one.start, one.end, two.start, two.end)
        for items in (*calls, *formals)
        for one, two in pairwise(items)
        if one is not None and two is not None
    ]
    pair = of(chance, pairs)
    if pair is None:
        return None
    start, end, start2, end2 = pair
    text = written.text
    return put(text, (start, end, text[start2:end2]), (start2, end2, text[start:end]))


def program(written: Written, chance: Random) -> str | None:
    """A CALL of another program, or with another number of arguments."""
    site = of(chance, [call for _, call in parts_of(written, CallStatement)])
    if site is None:
        return None
    name = site.program
    others = [p.name for p in written.programs if p.name != name.text.lower()]
    return put(written.text, (name.start, name.end, chance.choice(others)))


def index(written: Written, chance: Random) -> str | None:
    """A wrong index: of another element, one too far, a number for the variable of the loop."""
    sites = [
        inner
        for _, element in parts_of(written, Element)
        for inner in element.subscripts
        if isinstance(inner, Name | Number)
    ]
    site = of(chance, sites)
    if site is None:
        return None
    if isinstance(site, Number):
        new = f"{site.value + chance.choice((-1, 1)):g}"
    else:
        new = chance.choice((f"{site.text}+1", f"{site.text}-1", "1", "2"))
    return put(written.text, (site.start, site.end, new))


def missing_index(written: Written, chance: Random) -> str | None:
    """An index forgotten."""
    site = of(chance, [element for _, element in parts_of(written, Element)])
    return site and put(written.text, (site.name.end, site.end, ""))


def bound(written: Written, chance: Random) -> str | None:
    """A wrong bound of a loop: one too few or too many, from 0, the two exchanged."""
    loop = of(chance, [loop for _, loop in parts_of(written, For)])
    if loop is None or not (isinstance(loop.first, Number) and isinstance(loop.last, Number)):
        return None
    first, last = loop.first, loop.last
    if chance.random() < 0.2:
        one, two = f"{first.value:g}", f"{last.value:g}"
        return put(written.text, (first.start, first.end, two), (last.start, last.end, one))
    site = chance.choice((first, last))
    value = site.value + chance.choice((-1, 1, 2))
    return put(written.text, (site.start, site.end, f"{value:g}"))


def loop_step(written: Written, chance: Random) -> str | None:
    """A wrong step of a loop."""
    loop = of(chance, [loop for _, loop in parts_of(written, For)])
    if loop is None:
        return None
    return put(written.text, (loop.last.end, loop.end, f" STEP {chance.choice((2, 3, -1, 0.5))}"))


def compound(written: Written, chance: Random) -> str | None:
    """A compound location turned round, or a part of it left out."""
    sites = [node for _, node in parts_of(written, Infix) if node.operator == ":"]
    site = of(chance, sites)
    if site is None:
        return None
    text = written.text
    left = text[site.left.start : site.left.end]
    right = text[site.right.start : site.right.end]
    new = chance.choice((f"{right}:{left}", left, right))
    return put(text, (site.start, site.end, new))


def inverse(written: Written, chance: Random) -> str | None:
    """INVERSE forgotten, or written where it should not be."""
    calls = [n for _, n in parts_of(written, Application) if n.name.text.upper() == "INVERSE"]
    inner = [n for _, n in parts_of(written, Infix) if n.operator == ":"]
    names = [n for infix in inner for n in (infix.left, infix.right) if isinstance(n, Name)]
    site = of(chance, [*calls, *names])
    if site is None:
        return None
    if isinstance(site, Name):
        return put(written.text, (site.start, site.end, f"INVERSE({site.text})"))
    kept = site.arguments[0]
    assert kept is not None
    return put(written.text, (site.start, site.end, written.text[kept.start : kept.end]))


def target(written: Written, chance: Random) -> str | None:
    """A SET or an assignment of another variable than the one meant."""
    sites = [
        (owner, step.target)
        for owner, step in [*parts_of(written, SetLocation), *parts_of(written, Assignment)]
        if isinstance(step.target, Name)
    ]
    site = of(chance, sites)
    if site is None:
        return None
    owner, name = site
    others = [n for n in known_places(written, owner) if n.lower() != name.text.lower()]
    return put(written.text, (name.start, name.end, chance.choice(others)))


def operator(written: Written, chance: Random) -> str | None:
    """A wrong operator: + for -, < for <=, == for <>, OR for AND."""
    sites = [node for _, node in parts_of(written, Infix) if node.operator in OTHER_WAY]
    site = of(chance, sites)
    if site is None:
        return None
    start = site.operator_start
    end = site.right.start
    word = written.text[start:end]
    new = chance.choice(OTHER_WAY[site.operator])
    return put(written.text, (start, end, new + word[len(word.rstrip()) :]))


def constant(written: Written, chance: Random) -> str | None:
    """A wrong number in a condition or an assignment: one off, or of the wrong sign."""
    sites = [
        number
        for kind in (If, While, Until, Assignment)
        for _, node in parts_of(written, kind)
        for number in constants(node)
    ]
    site = of(chance, sites)
    if site is None:
        return None
    new = chance.choice((site.value + 1, site.value - 1, site.value * 10, -site.value))
    return put(written.text, (site.start, site.end, f"{new:g}"))


def _used(written: Written) -> list[tuple[WrittenProgram, Name]]:
    """Return the locations that motions, SET and CALL name, each with its program."""
    nodes: list[tuple[WrittenProgram, object]] = [
        *((owner, node.operands) for owner, node in simple(written, *MOTIONS)),
        *((owner, node.arguments) for owner, node in parts_of(written, CallStatement)),
        *((owner, node.value) for owner, node in parts_of(written, SetLocation)),
    ]
    return [
        (owner, part)
        for owner, node in nodes
        for part in parts(node)
        if isinstance(part, Name) and part.text in known_places(written, owner)
    ]


def _numbers(call: CallStatement) -> list[Number]:
    return [node for node in call.arguments if isinstance(node, Number)]


NAMES: dict[str, Kind] = {
    "location": location,
    "misspelt": misspelt,
    "argument": argument,
    "exchanged-arguments": exchanged_arguments,
    "program": program,
    "index": index,
    "missing-index": missing_index,
    "bound": bound,
    "loop-step": loop_step,
    "compound": compound,
    "inverse": inverse,
    "target": target,
    "operator": operator,
    "constant": constant,
}
