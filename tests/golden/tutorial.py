"""Follow the tutorial of an example as a reader does, and compare what it shows.

A comment `<!-- file: NAME -->` before a fenced block means that the reader writes this file, and
`<!-- file: NAME above LINE -->` that what begins with this line is kept below it. A block `console`
shows commands (`$ vrts …`) with their output, standard output and error together. A line `…` in a
shown output stands for any number of lines, also for none.
"""

import os
import re
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from tests.places import ROOT
from tests.support_commands import vrts_shown

ELLIPSIS = "…"

_BLOCK = re.compile(
    r"^(?:<!-- file: (?P<file>\S+)(?: above (?P<kept>\S+))? -->\n)?"
    r"```(?P<language>\w+)\n(?P<body>.*?)^```$",
    re.M | re.S,
)


class Shown(NamedTuple):
    """A command of the tutorial and what came of it."""

    command: str
    line: int  # of the command in the tutorial, from 1
    shown: str  # output in the tutorial
    real: str  # output now
    start: int  # of `shown` in the tutorial
    end: int

    @property
    def fits(self) -> bool:
        """Whether the tutorial shows the truth."""
        return matches(self.shown, self.real)


def matches(shown: str, real: str) -> bool:
    """Return whether a shown output, perhaps with lines left out, is the real one."""
    lines = shown.splitlines()
    pattern = "".join(
        r"(?:.*\n)*" if line.strip() == ELLIPSIS else re.escape(line.rstrip()) + r"\n"
        for line in lines
    )
    text = "".join(line.rstrip() + "\n" for line in real.splitlines())
    return re.fullmatch(pattern, text) is not None


def follow(tutorial: str, example: Path) -> Iterator[Shown]:
    """Follow a tutorial in a copy of its example's folder.

    Args:
        tutorial: Text of the tutorial.
        example: The folder.
    """
    with TemporaryDirectory() as temporary:
        folder = Path(temporary) / example.name
        shutil.copytree(example, folder)
        for block in _BLOCK.finditer(tutorial):
            if block["file"]:
                _write(folder / block["file"], block["body"], block["kept"])
            elif block["language"] == "console":
                yield from _commands(tutorial, block, folder)


def rewritten(tutorial: str, example: Path) -> str:
    """Return the tutorial with every output that is not true any more replaced by the real one."""
    for shown in reversed(list(follow(tutorial, example))):
        if not shown.fits:
            tutorial = tutorial[: shown.start] + shortened(shown.real) + tutorial[shown.end :]
    return tutorial


def shortened(output: str) -> str:
    """Return an output up to a sketch in dots or a fence, which a tutorial cannot show well."""
    lines: list[str] = []
    for line in output.splitlines():
        if line.startswith("```") or any("\u2800" <= character <= "\u28ff" for character in line):
            lines.append(ELLIPSIS)
            break
        lines.append(line.rstrip())
    return "".join(line + "\n" for line in lines)


def _write(path: Path, text: str, kept: str | None) -> None:
    """Write a file; keep what begins with a line of the present one below the text."""
    if kept is not None:
        present = path.read_text(encoding="utf-8").splitlines(keepends=True)
        text += "".join(present[[line.strip() for line in present].index(kept) :])
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _commands(tutorial: str, block: re.Match[str], folder: Path) -> Iterator[Shown]:
    marks = list(re.finditer(r"^\$ (.*)\n", block["body"], re.M))
    offset = block.start("body")
    for i, found in enumerate(marks):
        start = offset + found.end()
        last = i + 1 == len(marks)
        end = offset + (len(block["body"]) if last else marks[i + 1].start())
        yield Shown(
            command=found[1],
            line=tutorial.count("\n", 0, offset + found.start()) + 1,
            shown=tutorial[start:end],
            real=_run(found[1], folder),
            start=start,
            end=end,
        )


def _run(command: str, folder: Path) -> str:
    command, _, given = command.partition(" < ")  # a file in the place of the keyboard
    program, *arguments = shlex.split(command)
    assert program == "vrts", command
    environment = {
        **os.environ,
        "NO_COLOR": "1",
        "PYTHONPATH": str(ROOT),
        "PYTHONIOENCODING": "utf-8",
        "COLUMNS": "100",
    }
    typed = (folder / given).read_bytes() if given else b""
    return vrts_shown(*arguments, cwd=folder, env=environment, stdin=typed)
