"""Bytes of a file to program text. Never raises: what is no text is a diagnostic."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.source import SourceFile
from vrts.lang.reading.encodings import characters, shown

EMPTY_FILE = Rule("V101", "empty-file")
NOT_TEXT = Rule("V102", "not-text")
FILE_TOO_LARGE = Rule("V103", "file-too-large")

MAX_BYTES = 4_000_000
MAX_LINE = 10_000  # characters; no program line comes near this, whatever its comment
DROPPED = "\0\f\x1a"  # NUL, form feed and SUB, as paper tape and disks had them

_NOT_READ = str.maketrans("", "", DROPPED)


class _Container(NamedTuple):
    magic: bytes
    what: str


_CONTAINERS = (
    _Container(b"PK\x03\x04", "a zip archive or an office document"),
    _Container(b"\xd0\xcf\x11\xe0", "an old office document"),
    _Container(b"%PDF", "a PDF document"),
    _Container(b"{\\rtf", "a rich text document"),
    _Container(b"\x89PNG", "a picture"),
    _Container(b"\xff\xd8\xff", "a picture"),
    _Container(b"GIF8", "a picture"),
    _Container(b"\x1f\x8b", "a compressed file"),
)


def decode(data: bytes, name: str) -> SourceFile | Diagnostic:
    """Return the text of a file, or the one reason why it cannot be a program.

    UTF-8, UTF-16 and 8-bit code pages are read; CR and CR LF become LF; NUL, form feed and SUB
    are dropped.

    Args:
        data: The bytes of the file.
        name: What diagnostics call the file.
    """
    if len(data) > MAX_BYTES:
        return error(
            FILE_TOO_LARGE,
            f"`{name}` is too large for a program: {len(data) / 1e6:.1f} MB",
            notes=(f"the limit is {MAX_BYTES // 1_000_000} MB",),
            help=("check that this is the program and not a recording or an archive",),
            data={"bytes": len(data)},
        )
    for container in _CONTAINERS:
        if data.startswith(container.magic):
            return _not_text(name, f"`{name}` is {container.what}, not program text")
    found = characters(data)
    if found is None:
        return _not_text(name, f"`{name}` is not text")
    text = shown(found.text).replace("\r\n", "\n").replace("\r", "\n").translate(_NOT_READ)
    if not text.strip():
        return error(
            EMPTY_FILE,
            f"`{name}` is empty",
            help=("write at least `.PROGRAM name`, a step and `.END`",),
        )
    longest = max(map(len, text.split("\n")))
    if longest > MAX_LINE:
        return error(
            FILE_TOO_LARGE,
            f"`{name}` has a line of {longest:,} characters",
            notes=("a program line has at most 255 characters",),
            help=("check that this is the program and that its line ends are kept",),
            data={"longest_line": longest},
        )
    return SourceFile(name, text)


def _not_text(name: str, headline: str) -> Diagnostic:
    return error(
        NOT_TEXT,
        headline,
        help=("hand in the program as plain text, as an editor saves it (`name.v2`)",),
        data={"name": name},
    )
