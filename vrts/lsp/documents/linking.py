"""Which files of a folder belong together: one calls a program or uses data of the other."""

from collections.abc import Sequence

from vrts.lsp.documents.documents import Document


def group(document: Document, beside: Sequence[Document]) -> list[Document]:
    """Return the files that a file belongs together with, itself first.

    Files are joined where one calls a program that only the other has, and where one uses a name
    that it gives no value and a file of nothing but data does. Other files of the folder may hold
    the same names and mean something else: the work of other people, or an older version.
    """
    files = [document, *beside]
    joined = _joined(files)
    reached, waiting = {0}, [0]
    while waiting:
        for other in joined.get(waiting.pop(), ()):
            if other not in reached:
                reached.add(other)
                waiting.append(other)
    return [files[number] for number in sorted(reached)]


def _joined(files: Sequence[Document]) -> dict[int, set[int]]:
    """Return which files, by number, are joined with which; the way of the need does not count."""
    programs: dict[str, list[int]] = {}  # by what they define: numbers of files
    data: dict[str, list[int]] = {}
    for number, file in enumerate(files):
        for name in file.names.defined_programs:
            programs.setdefault(name, []).append(number)
        if not file.names.programs:
            for name in file.names.defined_variables:
                data.setdefault(name, []).append(number)
    joined: dict[int, set[int]] = {}
    for number, file in enumerate(files):
        names = file.names
        givers = {n for name in names.missing_programs for n in programs.get(name, ())}
        givers.update(n for name in names.missing_variables for n in data.get(name, ()))
        for giver in givers:
            joined.setdefault(number, set()).add(giver)
            joined.setdefault(giver, set()).add(number)
    return joined
