"""A change that earns the full mark, with what comes of it, as a line of JSON and back."""

import json
from typing import NamedTuple

from vrts.lsp.answers.formatting import Edit


class Mend(NamedTuple):
    """What a search for such a change came to."""

    said: str  # what may be told of it; "" where there is nothing
    future: str = ""  # what comes of the change: mark, time, what remains between things
    edits: tuple[Edit, ...] = ()  # none where no change stands out, or the task allows no edit


NOTHING = Mend("")


def line_of_mend(mend: Mend) -> bytes:
    """Return a line that says what was found."""
    return json.dumps(mend).encode() + b"\n"


def mend_of(line: bytes) -> Mend:
    """Return what was found from the line that it was written as; nothing of an empty one."""
    if not line:
        return NOTHING
    said, future, edits = json.loads(line)
    return Mend(said, future, tuple(Edit(*each) for each in edits))
