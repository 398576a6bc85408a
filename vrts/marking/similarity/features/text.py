"""The text of a program as rows of symbols, whether or not it is right."""

from collections.abc import Iterator

from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.symbols import Readable, Reader

LENGTH = 9  # symbols in a row: about two steps
MOST = 4_000  # symbols of a program


def text_features(file: Readable, reader: Reader) -> Iterator[Feature]:
    """Yield the rows of symbols of each program in a file."""
    room = MOST
    for part in reader.parts(file):
        symbols = part.symbols[:room]
        room -= len(symbols)
        for k in range(len(symbols) - LENGTH + 1):
            yield Feature(Channel.TEXT, "row", symbols[k : k + LENGTH], part.lines[k])
