"""`overrides.toml` without the changes of one student."""

from collections.abc import Collection
from fractions import Fraction

from vrts.base.toml.reading import read_toml
from vrts.marking.by_hand.override_text import BEGINNING, override_text
from vrts.marking.by_hand.overrides import read_overrides
from vrts.marking.personal.raw_text import RawText
from vrts.pipeline.refused import Refused

HEADER = "[["


def without_changes(data: bytes, name: str, ids: Collection[str]) -> bytes:
    """Return a file of changes without those of a student; all others keep their bytes.

    Comments right above a change go with it. A file that has its changes in one array is written
    anew.

    Args:
        data: Of the file.
        name: Of the file.
        ids: Id and pseudonym of the student.

    Raises:
        Refused: The file has errors.
    """
    raw = RawText(data, name)
    text = raw.source.text
    top, problems = read_toml(raw.source)
    if top is None:
        raise Refused(problems.in_order())
    tables = top.tables("change")
    mine = [table.string("student") in ids for table in tables]
    if not any(mine):
        return data
    starts = [text.rfind("\n", 0, table.span.start) + 1 for table in tables]
    if not all(text.startswith(HEADER, start) for start in starts):
        found = read_overrides(raw.source, (), Fraction(10**6))
        if found.wrong:
            raise Refused(found.diagnostics)
        others = [made for who, every in found.changes.items() if who not in ids for made in every]
        return (BEGINNING + "\n" + "\n".join(map(override_text, others))).encode()
    begins = [_with_comments(text, start) for start in starts]
    ends = [*begins[1:], len(text)]
    pieces = zip(begins, ends, mine, strict=True)
    return raw.without((first, last) for first, last, cut in pieces if cut)


def _with_comments(text: str, start: int) -> int:
    """Return where the comments begin that stand right above a line."""
    while start > 0:
        before = text.rfind("\n", 0, start - 1) + 1
        if not text[before:start].lstrip().startswith("#"):
            break
        start = before
    return start
