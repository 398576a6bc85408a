"""What a copier does to somebody else's program so that it looks like another."""

from collections.abc import Callable
from random import Random

from tests.support_judge.layout import Layout, some_layout
from tests.support_judge.people import REMARKS, SAYS, Person, remark, some_person
from tests.support_judge.places import GOALS, OBJECTS
from tests.support_judge.source import (
    Body,
    Free,
    Loop,
    Node,
    Place,
    Program,
    Source,
    Step,
    loops,
    mapped,
    renamed,
    steps,
)  # fmt: skip
from tests.support_judge.splitting import split

Disguise = Callable[[Random, Source], Source]
KEPT = {"main", "dish_grip", "pizza_grip", "stand_mid"}


def rename(rng: Random, source: Source) -> Source:
    """Give everything another name, and say most remarks in other words."""
    person = some_person(rng)
    other = list(person.words)
    rng.shuffle(other)
    family = rng.randrange(1, len(OBJECTS))
    names: dict[str, str] = {}
    taken = set(KEPT)

    def name(old: str, wanted: str) -> None:
        if old in names or old in KEPT:
            return
        while wanted in taken or wanted == old:
            wanted += rng.choice("12xab")
        names[old] = wanted
        taken.add(wanted)

    cans = [one for one in source.places if one.values[3:] == (90.0, 90.0, 0.0)]
    for place in source.places:
        digits = "".join(sign for sign in place.name if sign.isdigit())
        patterns = OBJECTS if place.values[1] < -400 or place.values[1] > 430 else GOALS
        plain = place in cans and digits
        name(
            place.name,
            patterns[family].format(n=digits)
            if plain
            else rng.choice(("pos", "loc", "pt", "x")) + place.name[:3],
        )
    for program in source.programs:
        name(program.name, other.pop() if other else f"prog{len(names)}")
        for parameter in program.parameters:
            name(parameter, other.pop() if other else f"arg{len(names)}")
    for one in _own_names(source):
        name(one, other.pop() if other else f"var{len(names)}")
    return mapped(renamed(source, names), lambda node: _reworded(rng, person, node))


def _own_names(source: Source) -> list[str]:
    """Return names that steps give values to, arrays without their brackets."""
    found: list[str] = []
    for program in source.programs:
        for step in steps(program.body):
            if step.word in ("=", "SET"):
                found.append(step.operands[0].partition("[")[0])
        found += [loop.variable for loop in loops(program.body)]
    return list(dict.fromkeys(found))


def _reworded(rng: Random, person: Person, node: Node) -> Body:
    if not isinstance(node, Step):
        return (node,)
    if node.word == ";":
        return () if rng.random() < 0.5 else (node._replace(note=f"Teil {rng.randint(1, 4)}"),)
    if node.word == "TYPE":
        return (node._replace(operands=(f'"{rng.choice(SAYS)}"',)),)
    if node.note:
        about = next((key for key, said in REMARKS.items() if node.note in said), "home")
        return (node._replace(note=rng.choice(REMARKS[about]) if rng.random() < 0.6 else ""),)
    return (node,)


def reorder_programs(rng: Random, source: Source) -> Source:
    """Put the programs of the file, and its places, into another order."""
    programs, places = list(source.programs), list(source.places)
    while len(programs) > 1 and tuple(programs) == source.programs:
        rng.shuffle(programs)
    rng.shuffle(places)
    return source._replace(programs=tuple(programs), places=tuple(places))


def reorder_steps(rng: Random, source: Source) -> Source:
    """Do things in another order where the task allows it."""

    def change(node: Node) -> Body:
        if not isinstance(node, Free) or len(node.pieces) < 2:
            return (node,)
        pieces = list(node.pieces)
        while tuple(pieces) == node.pieces and len(set(pieces)) > 1:
            rng.shuffle(pieces)
        return (Free(tuple(pieces)),)

    return _numbered(mapped(source, change))


def _numbered(source: Source) -> Source:
    """Let the elements of arrays of places count upward again, in their new order."""

    def change(node: Node) -> Body:
        if not isinstance(node, Free):
            return (node,)
        pieces: list[Body] = []
        number = 0
        for piece in node.pieces:
            number += any(_is_element(one) for one in piece)
            pieces.append(tuple(_as_element(one, number) for one in piece))
        return (Free(tuple(pieces)),)

    return mapped(source, change)


def _is_element(node: Node) -> bool:
    return isinstance(node, Step) and node.word == "SET" and "[" in node.operands[0]


def _as_element(node: Node, number: int) -> Node:
    if not isinstance(node, Step) or not _is_element(node):
        return node
    return node._replace(
        operands=(node.operands[0].partition("[")[0] + f"[{number}]", node.operands[1])
    )


def fill(rng: Random, source: Source) -> Source:
    """Add steps, remarks, places and a program that do nothing to the matter."""
    person = some_person(rng)._replace(chatty=0.5)

    def change(node: Node) -> Body:
        if not isinstance(node, Step) or rng.random() > 0.35:
            return (node,)
        return (
            (node, _filler(rng))
            if rng.random() < 0.7
            else (_filler(rng), node._replace(note=remark(rng, person, "home")))
        )

    out = mapped(source, change)
    extra = Place(
        rng.choice(("reserve", "test1", "extra", "unused", "old_pos")),
        (850.0, 50.0 * rng.randint(-3, 3), 120.0, 90.0, 90.0, 0.0),
    )
    programs = out.programs
    if rng.random() < 0.5:
        programs = (
            *programs,
            Program(
                rng.choice(("test", "old", "reset", "check1")),
                (),
                (Step("TYPE", ('"test"',)), Step("BREAK")),
            ),
        )
    return out._replace(programs=programs, places=(*out.places, extra))


def _filler(rng: Random) -> Step:
    kind = rng.randrange(6)
    match kind:
        case 0:
            return Step("TYPE", (f'"step {rng.randint(1, 9)}"',))
        case 1:
            return Step(
                "=", (rng.choice(("state", "count1", "temp", "x9", "flag")), str(rng.randint(0, 5)))
            )
        case 2:
            return Step("DELAY", (rng.choice(("0.1", "0.05", "0.2")),))
        case 3:
            return Step(
                ";", (), rng.choice(("next", "ok", "check this", "see lecture", "continue"))
            )
        case 4:
            return Step("BREAK")
        case _:
            return Step("SET", (rng.choice(("tmp1", "lastpos", "here0")), "HERE"))


def shift(rng: Random, source: Source) -> Source:
    """Change all numbers a little: heights, speeds, and places by a few millimetres."""

    def number(text: str, by: int) -> str:
        if not text.replace(".", "").isdigit():
            return text
        off = rng.choice([n for n in range(-by, by + 1) if n])
        return (
            str(max(5, int(text) + off))
            if "." not in text
            else f"{float(text) + 0.05 * rng.choice((1, 2, -1)):g}"
        )

    def change(node: Node) -> Body:
        if not isinstance(node, Step):
            return (node,)
        match node.word:
            case "SPEED":
                value, _, rest = node.operands[0].partition(" ")
                value = str(min(100, int(number(value, 6))))
                return (node._replace(operands=(f"{value} {rest}".strip(),)),)
            case "APPRO" | "APPROS" | "DEPART" | "DEPARTS" | "=":
                return (
                    node._replace(operands=(*node.operands[:-1], number(node.operands[-1], 12))),
                )
            case "CALL":
                return (node._replace(operands=tuple(number(one, 12) for one in node.operands)),)
            case "DELAY":
                return (node._replace(operands=(number(node.operands[0], 1),)),)
            case _:
                return (node,)

    def moved(place: Place) -> Place:
        if place.name in ("rim", "pizza", "stone"):
            return place
        x, y, z, *turn = place.values
        off = tuple(rng.randint(-3, 3) for _ in range(3))
        return Place(place.name, (x + off[0], y + off[1], z + off[2], *turn))

    out = mapped(source, change)
    return out._replace(places=tuple(map(moved, out.places)))


def for_to_while(_: Random, source: Source) -> Source:
    """Say FOR as WHILE."""
    return mapped(
        source, lambda node: (node._replace(kind="WHILE"),) if isinstance(node, Loop) else (node,)
    )


DISGUISES: dict[str, Disguise] = {
    "rename": rename, "reorder programs": reorder_programs, "reorder steps": reorder_steps,
    "filler": fill, "shift": shift, "for to while": for_to_while, "split": split,
}  # fmt: skip


def new_layout(rng: Random, old: Layout, names: tuple[str, ...]) -> Layout:
    """Return the layout of a copy: who renames lays it out anew half of the time."""
    return some_layout(rng) if "rename" in names and rng.random() < 0.5 else old
