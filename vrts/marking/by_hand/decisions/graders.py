"""Who decides: a name as people write it, and an id that is safe as the name of a file."""

import hashlib
import re
import unicodedata
from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.base.safe_names import RESERVED
from vrts.pipeline.refused import Refused
from vrts.report.plain import one_line

GRADER_NAME = Rule("V848", "grader-name")

ID = re.compile(r"[a-z0-9][a-z0-9-]{0,39}\Z")
LONGEST_ID = 40
LONGEST_NAME = 200


class Grader(NamedTuple):
    """Somebody who decides."""

    id: str  # lower case, ASCII; the name of the file
    name: str  # as people call them


def grader_called(name: str, known: Mapping[str, str]) -> Grader:
    """Return who is called so: who is known by this very name, else somebody new.

    Names that differ get ids that differ, also where they look alike as ids. Two persons of the
    same name have to write something beside it.

    Args:
        name: As people write it.
        known: Names by id.

    Raises:
        Refused: It is no name.
    """
    plain = one_line(unicodedata.normalize("NFC", name)).strip()
    if not plain or len(plain) > LONGEST_NAME or not any(c.isalnum() for c in plain):
        headline = f"`{plain[:40]}` is no name of a grader"
        remedy = 'write who decides, such as `--who "R. Huber"`, with letters, up to 200 of them'
        raise Refused((error(GRADER_NAME, headline, help=(remedy,)),))
    for identifier in sorted(known):
        if known[identifier] == plain:
            return Grader(identifier, plain)
    first = _slug(plain)
    identifier, number = first, 1
    while identifier in known:
        number += 1
        end = f"-{number}"
        identifier = first[: LONGEST_ID - len(end)].rstrip("-") + end
    return Grader(identifier, plain)


def _slug(name: str) -> str:
    """Return a name as an id; where hardly anything of it is ASCII, a digest keeps it unique."""
    folded = unicodedata.normalize("NFKD", name.replace("ß", "ss"))
    plain = re.sub(r"[^a-z0-9]+", "-", folded.encode("ascii", "ignore").decode().lower()).strip("-")
    letters = sum(c.isalnum() for c in name)
    if len(plain.replace("-", "")) * 2 < letters or plain.upper() in RESERVED:
        digest = hashlib.sha256(name.encode()).hexdigest()[:8]
        plain = f"{plain}-{digest}" if plain else f"grader-{digest}"
    return plain[:LONGEST_ID].strip("-")
