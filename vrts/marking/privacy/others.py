"""Ids of other folders in a marking without names: pseudonyms too, and a table of who is who.

The key is that of the marking, so a student who comes again has one pseudonym in both years. What
is a pseudonym already stays as it is.
"""

import re
from collections.abc import Iterable, Mapping, Sequence

from vrts.marking.intake.tables.table_text import table_bytes
from vrts.marking.layout import COMPARED, Layout
from vrts.marking.privacy.pseudonyms import (
    COLUMN,
    GROUP,
    KEY,
    LENGTH,
    LETTERS,
    pseudonym,
    write_names,
)

_ONE = rf"[{LETTERS}]{{{GROUP}}}"
_PSEUDONYM = re.compile("-".join([_ONE] * (LENGTH // GROUP)))


def is_nameless(layout: Layout) -> bool:
    """Return whether a class was marked without names."""
    return (layout.staff / KEY).is_file()


def called(identifier: str, key: bytes) -> str:
    """Return what somebody of another folder is called here."""
    known = _PSEUDONYM.fullmatch(identifier)
    return identifier if known else pseudonym(identifier, key)


def write_others(who: Iterable[Sequence[str]], ids: Mapping[str, str], layout: Layout) -> None:
    """Write who of other folders is who, for the owner only.

    Args:
        who: Folder and pseudonym of those whom the pages name.
        ids: By `FOLDER/PSEUDONYM`, the id there, of all.
        layout: Of the marking.
    """
    lines = [[COLUMN, "folder", "id"]]
    lines += [[name, folder, ids[f"{folder}/{name}"]] for folder, name in who]
    write_names(layout.staff / COMPARED, table_bytes(lines))
