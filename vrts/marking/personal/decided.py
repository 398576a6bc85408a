"""Graders' files without what they decided about one student.

Records keep their numbers, since others name them. Of a record about this student alone only its
number and its time stay, and that it is forgotten; of one about several the student is taken out.
Lines that say nothing of the student keep their bytes.
"""

from collections.abc import Collection, Mapping

import msgspec

from vrts.marking.by_hand.decisions.ledger import ENDING, lines_of
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Excuse,
    Extend,
    Finish,
    Forgotten,
    Give,
    Line,
    Undo,
)

_DECODER = msgspec.json.Decoder(Line)
_Place = tuple[str, int]  # file, and line


def without_student(files: Mapping[str, bytes], ids: Collection[str]) -> dict[str, bytes]:
    """Return the files in which something changes, without a student.

    Args:
        files: Bytes of all graders' files, by name; they have no errors.
        ids: Of the student.
    """
    texts = {name: _lines(data) for name, data in files.items()}
    lines = {
        (name, k): _DECODER.decode(line)
        for name, every in texts.items()
        for k, line in enumerate(every)
        if k
    }
    names = {
        (name, k): f"{name.removesuffix(ENDING)}:{said.number}" for (name, k), said in lines.items()
    }
    now: dict[_Place, Line] = {place: _without(said, ids) for place, said in lines.items()}
    gone = {
        names[place]
        for place, said in now.items()
        if isinstance(said, Forgotten) and said is not lines[place]
    }
    more = bool(gone)
    while more:  # an undo of what is forgotten may be undone in turn
        found: set[str] = set()
        for place, said in now.items():
            after = _about_rest(said, gone)
            if after is not said:
                now[place] = after
                if isinstance(after, Forgotten):
                    found.add(names[place])
        gone |= found
        more = bool(found)
    changed: dict[str, bytes] = {}
    for name, every in texts.items():
        told = [
            line if k == 0 or now[name, k] is lines[name, k] else msgspec.json.encode(now[name, k])
            for k, line in enumerate(every)
        ]
        data = b"".join(line + b"\n" for line in told)
        if any(old is not new for old, new in zip(every, told, strict=True)):
            changed[name] = data
        elif not data.startswith(files[name]):
            changed[name] = data  # half a line, about nobody knows whom
    return changed


def _lines(data: bytes) -> list[bytes]:
    """Return the lines of a file; the last also where its end is missing, if it is whole."""
    whole, rest = lines_of(data)
    if not rest:
        return whole
    try:
        _DECODER.decode(rest)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return whole  # a crash has left it: it does not count
    return [*whole, rest]


def _without(said: Line, ids: Collection[str]) -> Line:
    """Return a record without a student; the same where it is not about them."""
    match said:
        case Comment() | Finish():
            return _forgotten(said) if said.student in ids else said
        case Give() | ChangeMark():
            if not any(one in ids for one in (*said.students, *said.programs)):
                return said
            left = {one: digest for one, digest in said.programs.items() if one not in ids}
            return _only(msgspec.structs.replace(said, programs=left), ids)
        case Extend() | Excuse() | Assign():
            return _only(said, ids)
        case Decide() if said.students:
            return _only(said, ids)
        case _:
            return said


def _only(
    said: Give | ChangeMark | Extend | Excuse | Assign | Decide, ids: Collection[str]
) -> Line:
    left = tuple(one for one in said.students if one not in ids)
    if not left:
        return _forgotten(said)
    return said if left == said.students else msgspec.structs.replace(said, students=left)


def _about_rest(said: Line, gone: Collection[str]) -> Line:
    """Return a record without others that are forgotten; the same where it names none."""
    match said:
        case Undo():
            left = tuple(name for name in said.records if name not in gone)
            if not left:
                return _forgotten(said)
            return said if left == said.records else msgspec.structs.replace(said, records=left)
        case Decide():
            over = tuple(name for name in said.over if name not in gone)
            if said.keep in gone or not over:
                return _forgotten(said)
            return said if over == said.over else msgspec.structs.replace(said, over=over)
        case _:
            return said


def _forgotten(said: Decision) -> Forgotten:
    return Forgotten(said.number, said.at)
