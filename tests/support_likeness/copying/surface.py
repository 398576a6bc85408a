"""Copies that look different: names, layout, comments, values, and lines that do nothing."""

import re

from tests.support_likeness.copying.sheets import Copier, Sheet
from tests.support_likeness.students.naming import TAKEN
from tests.support_likeness.students.program import Line, Program, Unit, Values, names_of, rename

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
ENDS = re.compile(r"^(.*?)[._]?(\d*)$")
HEIGHTS = ("APPRO", "APPROS", "DEPART", "DEPARTS")


def renamed(sheet: Sheet, by: Copier) -> bool:
    """Give everything another name; things with numbers keep these."""
    program, draw = sheet.program, by.draw
    things = by.author.naming.things
    words = [word for key in things for word in things[key] if len(word) > 1]
    draw.shuffle(words)
    stems: dict[str, str] = {}
    names: dict[str, str] = {}
    old = {name.upper() for name in names_of(program)}
    used: set[str] = set()
    for name in names_of(program):
        if name.lower() == "main":
            continue
        match = ENDS.match(name)
        assert match is not None
        stem, number = match[1], match[2]
        if stem not in stems:
            stems[stem] = words.pop() if words else f"q{len(stems)}"
        new, k = f"{stems[stem]}{number}"[:13], 0
        while new.upper() in used | old | TAKEN:
            k += 1
            new = f"{stems[stem]}_{k}{number}"[-13:].lstrip("_")
        used.add(new.upper())
        names[name] = new
    rename(program, names)
    return True


def restyled(sheet: Sheet, by: Copier) -> bool:
    """Rewrite layout, case and comments, and what is printed."""
    program, draw = sheet.program, by.draw
    if sheet.layout == by.author.layout:
        return False
    sheet.layout = by.author.layout
    program.head = [by.said("head")] if draw.random() < 0.6 else []
    dense = draw.choice((0.0, 0.1, 0.3, 0.6))
    for block in program.blocks():
        kept: list[Line] = []
        for line in block:
            about = about_of(line)
            line.note = by.said(about) if about and draw.random() < dense else ""
            if line.word in ("NOTE", "BLANK"):
                if draw.random() < 0.5:
                    continue
                line.word, line.args = "NOTE", [by.said("part")]
            if line.word == "TYPE" and line.args[0].startswith('"'):
                line.args = [f'"{by.said("done")}"']
            kept.append(line)
        block[:] = kept
    for unit in program.units:
        unit.notes = []
    return True


def about_of(line: Line) -> str:
    """Return what one would say behind a line; empty: nothing."""
    match line.word:
        case "APPRO" | "APPROS":
            return "above"
        case "MOVES":
            return "down"
        case "CLOSEI" | "CLOSE":
            return "grip"
        case "OPENI" | "OPEN":
            return "open"
        case "DEPARTS" | "DEPART":
            return "up"
        case "SPEED":
            return "slow"
        case "MOVE":
            return "safe"
        case _:
            return ""


def shifted(sheet: Sheet, by: Copier) -> bool:
    """Shift what was taught by some millimetres, all of it or some, and heights by more."""
    program, draw = sheet.program, by.draw
    some = draw.choice((1.0, 1.0, 0.5))
    lift = draw.choice((-4, -3, -2, 2, 3, 4)) * by.strength
    lifted = {"grip", "put"}
    for name, values in program.places.items():
        role = program.roles.get(name, "")
        if not role:
            continue  # a frame of the text: it would move what is computed with it
        thing, _, use = role.partition(".")
        x, y, z, o, a, t = values
        cans = use in lifted and not thing.startswith(("dish", "stand", "pizza", "oven"))
        if cans:
            z += lift
        if draw.random() < some:
            free = thing.startswith("safe") or "+" in role
            far = (
                (12.0, 12.0, 15.0) if free else (3.0, 0.6, 0.0) if use == "grip" else (2.5, 2.5, 0)
            )
            if not cans and not free:
                far = (0.5, 0.4, 0.0) if use in lifted else (1.5, 1.5, 1.0)
            dx, dy, dz = (draw.uniform(-one, one) * by.strength for one in far)
            x, y, z = round(x + dx, 2), round(y + dy, 2), z + round(dz, 2)
        program.places[name] = (x, y, z, o, a, t)
    _shift_computed(program, by, lift)
    for line in program.lines():
        last = line.args[-1] if line.args else ""
        is_height = line.word in HEIGHTS and NUMBER.fullmatch(last) and float(last) >= 70
        if is_height and draw.random() < some:
            line.args[-1] = f"{float(last) + draw.choice((-10, -5, 5, 10, 15)):g}"
    return True


def _shift_computed(program: Program, by: Copier, lift: float) -> None:
    """Shift the numbers of TRANS."""
    for line in program.lines():
        if line.word != "SET" or not line.args[1].startswith("TRANS("):
            continue
        role = program.roles.get(line.args[0], "")
        thing, _, use = role.partition(".")
        values = [float(one) for one in NUMBER.findall(line.args[1])]
        if use in ("grip", "put") and thing.startswith(("can", "base")):
            values[0] += by.draw.uniform(-2.5, 2.5) * by.strength
            values[2] += lift
        line.args[1] = f"TRANS({','.join(f'{round(one, 2):g}' for one in values)})"


def filled(sheet: Sheet, by: Copier) -> bool:
    """Add lines that do nothing, motions that lead nowhere, variables and programs for nobody."""
    program, draw = sheet.program, by.draw
    spare = by.fresh(program, draw.choice(("x", "tmp", "test", "wert", "flag", "counter", "hulp")))
    first = program.main.body
    first.insert(0, Line("LET", [spare, draw.choice(("0", "1", "10"))]))
    size = sum(1 for _ in program.lines())
    for _ in range(int(size * draw.uniform(0.15, 0.45)) + 2):
        block = draw.choice([unit.body for unit in program.units if unit.body])
        at = draw.randrange(1, len(block) + 1)
        block.insert(at, _nothing(by, spare, block[at - 1]))
    if draw.random() < 0.6:
        name = by.fresh(program, draw.choice(("test", "old", "extra", "check", "probe")))
        unused = [
            Line("TYPE", [f'"{by.said("done")}"']),
            Line("DELAY", ["1"]),
            Line("LET", [spare, f"{spare}*2"]),
        ]
        program.units.append(Unit(name, [], unused))
    if program.places:
        x, y, z, *turn = draw.choice(list(program.places.values()))
        values: Values = (x - 50, y + 30, z + 200, turn[0], turn[1], turn[2])
        program.places[by.fresh(program, draw.choice(("p0", "old", "dummy", "xx")))] = values
    return True


def _nothing(by: Copier, spare: str, before: Line) -> Line:
    """Return a line that changes nothing that counts, to stand below another."""
    draw = by.draw
    if before.word == "MOVE" and draw.random() < 0.5:
        return Line("MOVE", [*before.args], part=before.part)
    if before.word in ("DEPARTS", "DEPART") and draw.random() < 0.6:
        return Line("DEPARTS", [draw.choice(("5", "10", "15"))], part=before.part)
    kind = draw.randrange(6)
    if kind == 0:
        return Line("DELAY", [draw.choice(("0.1", "0.05", "0.2"))], part=before.part)
    if kind == 1:
        return Line("LET", [spare, f"{spare}+1"], part=before.part)
    if kind == 2:
        inner = [Line("TYPE", [f'"{by.said("done")}"'])]
        return Line("IF", [f"{spare} > 1000"], part=before.part, body=inner)
    if kind == 3:
        return Line("TYPE", [f'"{by.said("part")}"'], part=before.part)
    if kind == 4:
        return Line(
            "NOTE", [by.said(draw.choice(("above", "down", "up", "fast")))], part=before.part
        )
    return Line("SIGNAL", [f"-{draw.randrange(5, 9)}"], part=before.part)
