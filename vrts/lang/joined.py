"""Several files compiled as one: their texts end to end, and spans that lie in the single files."""

from bisect import bisect_right
from collections.abc import Iterator, Sequence

from vrts.base.diagnostic import Label
from vrts.base.source import SourceFile, Span


class Joined(SourceFile):
    """The text of several files. Offsets in it are told apart by `span_in`."""

    def __init__(self, files: Sequence[SourceFile]) -> None:
        """Join at least one file."""
        super().__init__(files[0].name, "\n".join(file.text for file in files))
        self.files = tuple(files)
        self.starts: list[int] = []
        at = 0
        for file in files:
            self.starts.append(at)
            at += len(file.text) + 1

    def span(self, start: int, end: int) -> Span:
        """Return the place of a range of offsets, in the file that holds its start."""
        number = bisect_right(self.starts, start) - 1
        file, base = self.files[number], self.starts[number]
        return Span(file, start - base, min(end - base, len(file.text)))


def span_in(source: SourceFile, start: int, end: int) -> Span:
    """Return a place in a source that may be joined."""
    return source.span(start, end) if isinstance(source, Joined) else Span(source, start, end)


def parts(source: SourceFile) -> Iterator[tuple[int, str]]:
    """Return where each file of a source begins, and its text."""
    if isinstance(source, Joined):
        yield from zip(source.starts, (file.text for file in source.files), strict=True)
    else:
        yield 0, source.text


def order(source: SourceFile, label: Label | None) -> tuple[int, int]:
    """Return a key that sorts labels by file and place."""
    if label is None:
        return 0, 0
    if isinstance(source, Joined):
        return source.files.index(label.span.source), label.span.start
    return 0, label.span.start
