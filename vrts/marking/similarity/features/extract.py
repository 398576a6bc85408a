"""All features of one program."""

from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

from vrts.marking.similarity.features.code import code_features
from vrts.marking.similarity.features.counts import Counts, words_counted
from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.features.habits import habit_features
from vrts.marking.similarity.features.lines import line_features
from vrts.marking.similarity.features.motion import motion_features
from vrts.marking.similarity.features.text import text_features
from vrts.marking.similarity.features.values import value_features
from vrts.marking.similarity.symbols import Readable, Reader, readable
from vrts.marking.submission.sketch import Sketch
from vrts.pipeline.compiling.programs import compile_bytes

CHANNELS = tuple(Channel)
MOST_FEATURES = 20_000  # of a program
MOST_LINES = 20_000  # of a program that is compiled: some findings take time by the square


class Program(NamedTuple):
    """A program, and what its run did."""

    data: bytes
    sketch: Sketch | None = None  # None: nobody executed it, or it did not run


class Digests(NamedTuple):
    """A program as numbers: for each channel the digests of its features, each once, sorted."""

    channels: tuple[tuple[int, ...], ...]
    words: Counts  # of the language


def features_of(program: Program, name: str, reader: Reader) -> Iterator[Feature]:
    """Yield the features of a program; of what is no text there are none."""
    file = readable(program.data, name)
    if file is not None:
        yield from _features(program, file, name, reader)


def _features(program: Program, file: Readable, name: str, reader: Reader) -> Iterator[Feature]:
    yield from text_features(file, reader)
    yield from line_features(file)
    yield from value_features(file)
    yield from habit_features(file)
    if program.sketch is not None:
        yield from motion_features(program.sketch)
    if len(file.source.line_starts) > MOST_LINES:
        return
    compilation = compile_bytes(program.data, name).compilation
    if compilation is not None and compilation.module is not None:
        yield from code_features(compilation.module)


def digests_of(program: Program, name: str, reader: Reader) -> Digests:
    """Return a program as numbers."""
    file = readable(program.data, name)
    if file is None:
        return Digests(((),) * len(CHANNELS), ())
    found: dict[Channel, set[int]] = {channel: set() for channel in CHANNELS}
    for feature in islice(_features(program, file, name, reader), MOST_FEATURES):
        found[feature.channel].add(feature.digest)
    channels = tuple(tuple(sorted(found[channel])) for channel in CHANNELS)
    return Digests(channels, words_counted(file))
