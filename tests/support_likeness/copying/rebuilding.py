"""Copies that are built differently: another order, other loops, other subroutines."""

import re

from tests.support_likeness.copying.sheets import Copier, Sheet
from tests.support_likeness.students.program import (
    Line,
    Program,
    Unit,
    every,
    names_in,
    rename_lines,
)

INDEX = re.compile(r"\[(\d+)\]")
FREE = frozenset(  # words that do not mind which comes first, at full stop or with the hand still
    frozenset(pair)
    for pair in (
        ("SPEED", "OPENI"),
        ("SIGNAL", "SPEED"),
        ("SIGNAL", "OPENI"),
        ("SIGNAL", "SET"),
        ("SET", "SPEED"),
        ("SET", "OPENI"),
        ("SET", "MOVE"),
        ("TYPE", "SPEED"),
        ("TYPE", "SET"),
        ("DELAY", "SPEED"),
    )
)
PLAIN_TEXT = """
    APPRO APPROS MOVE MOVES DEPART DEPARTS OPENI CLOSEI OPEN CLOSE DELAY SPEED BREAK NOTE SET
"""
PLAIN = frozenset(PLAIN_TEXT.split())


def programs_moved(sheet: Sheet, by: Copier) -> bool:
    """Bring the programs below the main one into another order, and the locations."""
    units = sheet.program.units
    if len(units) < 3:
        return False
    rest = units[1:]
    while rest == units[1:]:
        by.draw.shuffle(rest)
    sheet.program.units = [units[0], *rest]
    rows = list(sheet.program.places.items())
    by.draw.shuffle(rows)
    sheet.program.places = dict(rows)
    return True


def steps_moved(sheet: Sheet, by: Copier) -> bool:
    """Bring goals into another order, and what else does not depend on its order."""
    program = sheet.program
    moved = _parts_moved(program.main, by) | _index_moved(program, by)
    for unit in program.units:
        _sets_moved(unit.body, by)
    for block in program.blocks():
        _neighbours_moved(block, by)
    return moved


def _neighbours_moved(block: list[Line], by: Copier) -> None:
    """Let neighbours of which neither needs the other change places, here and there."""
    for k in range(len(block) - 1):
        a, b = block[k], block[k + 1]
        free = a.part == b.part and not a.label and not b.label
        if free and frozenset((a.word, b.word)) in FREE and by.draw.random() < 0.6:
            block[k], block[k + 1] = b, a


def _parts_moved(main: Unit, by: Copier) -> bool:
    """Bring the blocks of goals in the main program into another order."""
    blocks: list[list[Line]] = []
    where: list[int] = []
    rest: list[Line | None] = []
    for line in main.body:
        if line.part and blocks and rest[-1] is None and blocks[-1][-1].part == line.part:
            blocks[-1].append(line)
        elif line.part:
            blocks.append([line])
            where.append(len(rest))
            rest.append(None)
        else:
            rest.append(line)
    if len(blocks) < 2:
        return False
    order = list(range(len(blocks)))
    while order == sorted(order):
        by.draw.shuffle(order)
    main.body = []
    turn = iter(order)
    for line in rest:
        main.body += blocks[next(turn)] if line is None else [line]
    return True


def _index_moved(program: Program, by: Copier) -> bool:
    """Give the elements of arrays other indices, all in the same way."""
    sets = [
        line
        for line in program.lines()
        if line.word == "SET" and INDEX.search(line.args[0]) is not None
    ]
    indices = sorted({INDEX.findall(line.args[0])[0] for line in sets})
    if len(indices) < 2:
        return False
    order = indices[:]
    while order == indices:
        by.draw.shuffle(order)
    other = dict(zip(indices, order, strict=True))
    for line in sets:
        line.args[0] = INDEX.sub(lambda m: f"[{other[m[1]]}]", line.args[0])
    return True


def _sets_moved(block: list[Line], by: Copier) -> None:
    """Shuffle neighbouring SETs that do not need each other."""
    at = 0
    while at < len(block):
        end = at
        while end < len(block) and block[end].word == "SET" and not block[end].label:
            end += 1
        run = block[at:end]
        targets = {names_in(line.args[0])[0] for line in run}
        free = not any(set(names_in(line.args[1])) & targets for line in run)
        if len(run) > 1 and free:
            by.draw.shuffle(run)
            block[at:end] = run
        at = end + 1


def loops_changed(sheet: Sheet, by: Copier) -> bool:
    """Write FOR as WHILE or with labels, and WHILE as FOR."""
    changed = False
    label = 10
    for block in list(sheet.program.blocks()):
        for line in list(block):
            if line.word not in ("FOR", "WHILE") or line.body is None:
                continue
            if line.word == "WHILE":
                new = _as_for(block, line)
            elif by.draw.random() < 0.2:
                new = _unrolled(line)
            else:
                new = _as_other(line, by, label)
            if new:
                label += 10
                at = next(k for k, one in enumerate(block) if one is line)
                block[at : at + 1] = new
                changed = True
    return changed


def _as_other(line: Line, by: Copier, label: int) -> list[Line]:
    """Return a FOR as a WHILE, or as a jump."""
    i, first, last = line.args
    body = line.body or []
    begin = Line("LET", [i, first], part=line.part)
    more = Line("LET", [i, f"{i}+1"], part=line.part)
    if by.draw.random() < 0.6 or not body or body[0].label:
        return [begin, Line("WHILE", [f"{i} <= {last}"], line.note, line.part, body=[*body, more])]
    body[0].label = f"{label}"
    for one in body:
        one.part = line.part
    return [begin, *body, more, Line("IFGOTO", [f"{i} <= {last}", f"{label}"], part=line.part)]


def _unrolled(line: Line) -> list[Line]:
    """Return the rounds of a FOR one after the other."""
    i, first, last = line.args
    found: list[Line] = []
    for k in range(int(first), int(last) + 1):
        body = Program([Unit("x", [], line.body or [])], {}).copy().units[0].body
        rename_lines(body, {i: f"{k}"})
        for one in body:
            one.part = line.part
        found += body
    return found


def _as_for(block: list[Line], line: Line) -> list[Line]:
    """Return a WHILE that counts as a FOR; nothing where it does not."""
    match = re.fullmatch(r"(\w+) <= (\w+)", line.args[0])
    body = line.body or []
    if match is None or not body or body[-1].args != [match[1], f"{match[1]}+1"]:
        return []
    begins = [one for one in block if one.word == "LET" and one.args[0] == match[1]]
    if not begins:
        return []
    block.remove(begins[-1])
    return [
        Line("FOR", [match[1], begins[-1].args[1], match[2]], line.note, line.part, body=body[:-1])
    ]


def cut_up(sheet: Sheet, by: Copier) -> bool:
    """Split programs into more, or write subroutines where they are called."""
    program = sheet.program
    if by.draw.random() < 0.5:
        inlined = _inlined(program)
        return _split(program, by) or inlined
    split = _split(program, by)
    return (by.draw.random() < 0.5 and _split(program, by)) or split or _inlined(program)


def _inlined(program: Program) -> bool:
    """Write subroutines where they are called."""
    changed = False
    for unit in program.units[1:]:
        if any(line.label or line.word in ("CALL", "IFGOTO") for line in every(unit.body)):
            continue
        body = unit.body[:-1] if unit.body[-1:] and unit.body[-1].word == "RETURN" else unit.body
        if any(line.word == "RETURN" for line in every(body)):
            continue
        for block in list(program.blocks()):
            for line in list(block):
                if line.word == "CALL" and line.args[0] == unit.name:
                    at = next(k for k, one in enumerate(block) if one is line)
                    block[at : at + 1] = _filled_in(body, unit, line)
                    changed = True
        program.units.remove(unit) if changed else None
    return changed


def _filled_in(body: list[Line], unit: Unit, call: Line) -> list[Line]:
    """Return the lines of a subroutine with what a call gives it."""
    given = dict(zip(unit.params, call.args[1:], strict=True))
    lines = Program([Unit("x", [], body)], {}).copy().units[0].body
    rename_lines(lines, given)
    for line in lines:
        line.part = call.part
    if lines and call.label:
        lines[0].label = call.label
    return lines


def _split(program: Program, by: Copier) -> bool:
    """Put runs of plain lines into programs of their own."""
    changed = False
    for unit in list(program.units):
        for first, size in _runs(unit.body):
            cut = by.draw.randrange(3, min(size, 8) + 1)
            run = unit.body[first : first + cut]
            used = {name for line in run for arg in line.args for name in names_in(arg)}
            params = [name for name in unit.params if name in used]
            words = by.author.naming.things
            name = by.fresh(program, by.draw.choice(words["pick"] + words["place"]))
            renamed = {name: f"{name[:12]}_s" for name in params}
            rename_lines(run, renamed)
            part = run[0].part if len({line.part for line in run}) == 1 else ""
            program.units.append(Unit(name, [renamed[one] for one in params], run))
            call = Line("CALL", [name, *params], part=part)
            unit.body[first : first + cut] = [call]
            changed = True
            break
    return changed


def _runs(body: list[Line]) -> list[tuple[int, int]]:
    """Return where plain lines of one goal stand together: first and how many, longest first."""
    found: list[tuple[int, int]] = []
    at = 0
    while at < len(body):
        end = at
        while (
            end < len(body)
            and body[end].word in PLAIN
            and not body[end].label
            and body[end].part == body[at].part
        ):
            end += 1
        if end - at >= 4:
            found.append((at, end - at))
        at = max(end, at + 1)
    return sorted(found, key=lambda one: -one[1])
