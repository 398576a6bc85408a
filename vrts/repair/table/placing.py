"""What the steps beside a place speak for or against a step more there."""

import re
from collections.abc import Sequence

from vrts.lang.names import key
from vrts.lang.syntax.statements import CallStatement, For, If, Simple, While
from vrts.repair.table.asked import MOVES_TO, Asked
from vrts.repair.written import WrittenStep

HAND = frozenset({"OPEN", "OPENI", "CLOSE", "CLOSEI"})
EMPTY_LOOP = -0.9  # what speaks for a call in a loop with nothing in it
BESIDE_CALL = -0.5  # and for one more call of a program beside another
COUNTED = -0.6  # and for a call with what was counted just before
INSIDE = 4  # steps of a block in which a motion is looked for
ELEMENT = re.compile(r"(\w+)\[(\d+)\]")
BETWEEN = -0.7  # what speaks for an element of an array between its neighbours
NEXT = -0.4  # and for one behind the one before it
FIRST = -0.4  # and for the first, before another
AGAINST_SERIES = 0.2  # and against a place among others of the array that is not its own


def idle_hand(asked: Asked, line: int, text: str) -> bool:
    """Return whether a step of the hand does again what the hand did last, as the text stands."""
    if text not in ("OPENI", "CLOSEI"):
        return False
    last = ""
    for step in asked.written.steps:
        word = getattr(step.statement, "word", "")
        if step.line >= line:
            break
        last = word if word.startswith(("OPEN", "CLOSE")) else last
    return last[:4] == text[:4]


def opens(asked: Asked, k: int) -> bool:
    """Return whether nothing has moved before a step of the first program, and the step moves."""
    steps = asked.written.steps
    if steps[k].program or not _sets_off(asked, k):
        return False
    return not any(
        _sets_off(asked, j) or getattr(steps[j].statement, "word", "") in HAND for j in range(k)
    )


def is_first_of_hand(asked: Asked, step: WrittenStep) -> bool:
    """Return whether a step is the first of the hand, in the first program before it moves."""
    k = asked.written.steps.index(step)
    before = asked.written.steps[:k]
    return step.program == 0 and not any(
        _sets_off(asked, j) or getattr(each.statement, "word", "") in HAND
        for j, each in enumerate(before)
    )


def _sets_off(asked: Asked, k: int) -> bool:
    """Return whether a step moves the arm, or calls or repeats what does."""
    steps = asked.written.steps
    match steps[k].statement:
        case Simple(word) if word in MOVES_TO:
            return True
        case CallStatement(program):
            names = [each.name for each in asked.written.programs]
            return any(
                names[step.program] == key(program.text)
                and getattr(step.statement, "word", "") in MOVES_TO
                for step in steps
            )
        case For() | While() | If():
            return any(_sets_off(asked, j) for j in range(k + 1, min(k + INSIDE, len(steps))))
        case _:
            return False


def there(asked: Asked, beside: WrittenStep, line: int, text: str) -> bool:
    """Return whether a step of more than a word stands shortly before or behind a place already."""
    if " " not in text:
        return False
    steps = [each for each in asked.written.steps if each.program == beside.program]
    behind = [each for each in steps if each.line >= line][:2]
    before = [each for each in steps if each.line < line][-2:]
    return any(same(text, each.text) for each in (*before, *behind))


def fits(text: str, before: WrittenStep | None, step: WrittenStep | None) -> float:
    """Return what the steps beside speak for or against a step between them."""
    above = _words(before)
    below = _words(step)
    new = text.replace(",", " ").split()
    word = new[0]
    if same(text, before.text if before else "") or same(text, step.text if step else ""):
        return 0.8
    moves_in = above[:1] in (["MOVES"], ["MOVE"])
    if new[1:2] == ["="] and below[:1] == ["END"]:
        return -0.3
    if new[1:2] == ["="] and len(new) == 3 and ["="] in (above[1:2], below[1:2]):
        return -0.4
    if word == "CALL" and above[:1] == ["FOR"] and below[:1] == ["END"]:
        return EMPTY_LOOP
    if word == "CALL" and any(_is_like_call(new, each) for each in (above, below)):
        return BESIDE_CALL
    if word == "CALL" and above[1:2] == ["="] and text.endswith(f"({above[0]})"):
        return COUNTED
    if word == "SET":
        if above[:1] == ["SET"]:
            return -0.3
        return -0.2 if before is None or below[:1] == ["SET"] else 0.2
    if word in ("CLOSEI", "OPENI"):
        if above[:1] in (["CLOSEI"], ["OPENI"]):
            return 0.6
        if moves_in and below[:1] in (["DEPARTS"], ["DEPART"], ["MOVES"], ["MOVE"], ["APPRO"]):
            return -0.35
        return 0.0
    if word in ("DEPARTS", "DEPART"):
        return -0.45 if above[:1] in (["CLOSEI"], ["OPENI"]) else 0.4
    if word in ("MOVES", "MOVE") and len(new) > 1:
        if below[:1] in (["CLOSEI"], ["OPENI"]) and new[1] in above:
            return -0.5
        if below[:1] in (["CLOSEI"], ["OPENI"]):
            return -0.2
        return 0.1
    if word in ("APPRO", "APPROS") and len(new) > 1:
        return -0.45 if below[:1] in (["MOVES"], ["SPEED"]) and new[1] in below else 0.1
    if word == "BREAK":
        return 0.0 if above[:1] in (["MOVES"], ["MOVE"], ["APPRO"], ["DEPARTS"]) else 0.5
    return 0.1


def in_place(
    text: str, before: WrittenStep | None, step: WrittenStep, after: WrittenStep | None
) -> float:
    """Return what speaks for or against a place where a step more would do as well beside it."""
    new = text.replace(",", " ").split()
    above, below = _words(before), _words(step)
    if new[0] in ("APPRO", "APPROS") and len(new) > 1:
        slower = below[:1] == ["SPEED"] and below[-1] != "ALWAYS"
        if slower and _words(after)[:1] in (["MOVES"], ["MOVE"]) and new[1] in _words(after):
            return -0.6
        if above[:1] == ["SPEED"] and above[-1] != "ALWAYS" and below[:1] == ["MOVES"]:
            return 0.3
    if new[0] == "MOVES" and len(new) == 2 and above[:1] == ["SPEED"] and below[:1] == ["CLOSEI"]:
        return -0.3
    if new[0] == "SET":
        return _in_series(new[1], above, below)
    return 0.0


def _is_like_call(new: Sequence[str], beside: Sequence[str]) -> bool:
    """Return whether two steps call the same program."""
    names = [each[1].partition("(")[0] for each in (new, beside) if each[:1] == ["CALL"]]
    return len(names) == 2 and names[0] == names[1]


def _in_series(target: str, above: Sequence[str], below: Sequence[str]) -> float:
    """Return what speaks for a place beside the elements of an array just before and behind."""
    mine = ELEMENT.fullmatch(target)
    beside = [
        ELEMENT.fullmatch(step[1]) if step[:1] == ["SET"] and len(step) > 1 else None
        for step in (above, below)
    ]
    if mine is None:
        return 0.0
    number = int(mine[2])
    if beside[0] is None or beside[0][1] != mine[1]:
        first = beside[1] is not None and beside[1][1] == mine[1] and int(beside[1][2]) > number
        return FIRST if first else 0.0
    if int(beside[0][2]) != number - 1:
        return AGAINST_SERIES
    between = beside[1] is not None and beside[1][1] == mine[1] and int(beside[1][2]) == number + 1
    return BETWEEN if between else NEXT


def _words(step: WrittenStep | None) -> list[str]:
    return [] if step is None else step.text.replace(",", " ").split()


def same(a: str, b: str) -> bool:
    """Return whether two steps say the same."""
    return a.split() == b.split()
