"""The grade book of an assignment: final marks as `vrts grade export` writes them.

It is that command which is called, in a process of its own: what is exported from the board is what
is exported in a terminal, with the same refusals.
"""

import asyncio
import os
import signal
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Final, Literal, NamedTuple

import msgspec

from vrts.live.editing.owned_process import begun

MOST_S: Final = 300.0  # for one grade book [s]
LONGEST_FILE: Final = 4 * 1024 * 1024  # bytes of a teacher's file
LONGEST_WORDS: Final = 4000  # of a refusal
LONGEST_NAME: Final = 200
UNSAFE: Final = "V753"  # code of what keeps marks back until somebody decides
GIVEN: Final = "given.csv"
WRITTEN: Final = "grades.csv"
TOO_LONG: Final = "the marking is so large that it took too long: use `vrts grade export`"


class Wanted(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/board/grades`: which grade book."""

    assignment: str
    to: Literal["csv", "moodle", "canvas"]
    fill: bytes = b""  # the teacher's worksheet or grade book; base64
    column: Annotated[str, msgspec.Meta(max_length=LONGEST_NAME)] = (
        ""  # title of the column for the marks; empty: as the command finds it
    )
    despite: bool = False  # whether unsafe marks are taken


class Refusal(NamedTuple):
    """Why there is none."""

    code: Literal["unsafe", "export"]
    text: str  # what the command says


async def grade_book(marked: Path, wanted: Wanted, home: Path) -> bytes | Refusal:
    """Return a file for a grade book, or why there is none.

    Args:
        marked: The folder that `vrts course mark` wrote.
        wanted: Which file.
        home: Folder of the server, where files for the moment are put.

    Raises:
        OSError: There is no room, or no process begins.
    """
    with TemporaryDirectory(dir=home, prefix="grades-") as name:
        folder = Path(name)
        written = folder / WRITTEN
        words = ["grade", "export", str(marked), f"--to={wanted.to}", f"--output={written}"]
        if wanted.fill:
            given = folder / GIVEN
            await asyncio.to_thread(given.write_bytes, wanted.fill)
            words.append(f"--fill={given}")
        if wanted.column:
            words.append(f"--column={wanted.column}")
        if wanted.despite:
            words.append("--despite=all")
        status, said = await _carried_out((*words, "--color=never"), folder)
        if status == 0:
            return await asyncio.to_thread(written.read_bytes)
    for place in (folder, marked.parent):  # nobody has to know where the server keeps them
        said = said.replace(f"{place}{os.sep}", "")
    text = said.strip()[:LONGEST_WORDS]
    return Refusal("unsafe" if UNSAFE in text else "export", text)


async def _carried_out(words: tuple[str, ...], folder: Path) -> tuple[int, str]:
    """Carry a command of vrts out, and return its exit status and what it says on stderr."""
    process = await begun(("-m", "vrts.cli.main", *words), folder, {})
    try:
        async with asyncio.timeout(MOST_S):
            _, said = await process.communicate()
    except TimeoutError:
        return -1, TOO_LONG
    finally:
        if process.returncode is None:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            await process.wait()
    return process.returncode or 0, said.decode("utf-8", "replace")
