"""Lines as somebody wrote them: names, words and comment together, whatever the numbers are."""

import re
from collections.abc import Iterator
from itertools import islice

from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.symbols import Readable

MOST_LINES = 4_000  # of a file
LONGEST = 200  # characters of a line that are compared

_NUMBER = re.compile(r"(?<![A-Za-z0-9_.])[-+]?\d+(?:\.\d*)?")
_DATA = ("locations", "reals", "strings")


def line_features(file: Readable) -> Iterator[Feature]:
    """Yield the lines of a file without numbers and layout; not those of data sections."""
    line_of = file.source.line_of
    data = {
        number
        for section in file.sections
        if section.kind in _DATA
        for number in range(line_of(section.header.start), line_of(section.finish[0]) + 1)
    }
    for number, line in enumerate(islice(file.source.lines(), MOST_LINES), start=1):
        said = " ".join(_NUMBER.sub("#", line[: 2 * LONGEST]).lower().split())[:LONGEST]
        if said and said != ".end" and number not in data:
            yield Feature(Channel.LINES, "line", (said,), number)
