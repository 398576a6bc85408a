"""Adds changes by hand to the text of `overrides.toml`: what stands in it stays as it is."""

import json
from collections.abc import Collection, Sequence
from fractions import Fraction
from pathlib import Path

from vrts.base.source import SourceFile
from vrts.check.rules.scheme import TOTAL
from vrts.marking.by_hand.overrides import NONE, Override, Overrides, read_overrides
from vrts.marking.layout import write_atomically
from vrts.pipeline.files import read_bytes, read_toml_source
from vrts.pipeline.refused import Refused

BEGINNING = """\
# Changes of marks by hand. Marking reads this file and never writes over it.
# Every [[change]] has a student, either delta (points to add) or mark (in place of the mark after
# lateness), a reason, who decides, and a date. Those of one student are made one after the other.
# `mark` settles whatever makes the mark unsafe, delta what it names: settles = ["late"]. Both do so
# only while the `program` is the one with this sha256.
"""


def load_overrides(path: Path, known: Collection[str], total: Fraction = TOTAL) -> Overrides:
    """Return the changes in a file; none where it is not there.

    Raises:
        Refused: The file has errors.
        CannotRead: It cannot be read.
    """
    if not path.exists():
        return NONE
    found = read_overrides(read_toml_source(path), known, total)
    if found.wrong:
        raise Refused(found.diagnostics)
    return found


def add_overrides(
    path: Path, added: Sequence[Override], known: Collection[str], total: Fraction = TOTAL
) -> Overrides:
    """Write changes at the end of a file, and return all that are in it now.

    Raises:
        Refused: The file has errors, or would have them; it is left as it was.
        CannotRead: It cannot be read.
    """
    load_overrides(path, known, total)
    before = read_bytes(path) if path.exists() else BEGINNING.encode()
    gap = b"\n" if before.endswith(b"\n") or not before else b"\n\n"
    after = before + gap + "\n".join(map(override_text, added)).encode()
    text = after.decode("utf-8-sig").replace("\r\n", "\n")
    found = read_overrides(SourceFile(path.name, text), known, total)
    if found.wrong:
        raise Refused(found.diagnostics)
    write_atomically(path, after)
    return found


def override_text(override: Override) -> str:
    """Return one change as TOML."""
    points = (
        f"delta = {_number(override.delta)}"
        if override.delta is not None
        else f"mark = {_number(override.mark or Fraction(0))}"
    )
    return (
        f"[[change]]\nstudent = {_quoted(override.student)}\n{points}\n"
        f"reason = {_quoted(override.reason)}\nwho = {_quoted(override.who)}\n"
        f"date = {_quoted(override.date)}\n{_settles(override)}{_program(override)}"
    )


def _settles(override: Override) -> str:
    if not override.settles:
        return ""
    return f"settles = [{', '.join(map(_quoted, override.settles))}]\n"


def _program(override: Override) -> str:
    return f"program = {_quoted(override.program)}\n" if override.program else ""


def _quoted(text: str) -> str:
    plain = text.encode("utf-8", "replace").decode()
    return json.dumps(plain, ensure_ascii=False).replace("\x7f", "\\u007f")


def _number(points: Fraction) -> str:
    """Return points so that they are read back the same; what is marked is a tenth or so."""
    number = float(points)
    return str(int(number)) if number.is_integer() else repr(number)
