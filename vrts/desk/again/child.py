"""A process that marks again, told by one line of JSON, and telling by such lines.

It inherits a lock in the folder: so every desk knows that a marking goes on, also when the desk
that began it has died. It ends when its desk closes its input, after the submission that is being
marked; what is marked is kept.
"""

import os
import select
import sys
from contextlib import suppress
from pathlib import Path

import msgspec

from vrts.desk.again.marked import mark_again
from vrts.desk.again.spoken import LONGEST, Asked, Said
from vrts.desk.book.shelf import sentence
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused


def main() -> None:
    """Mark, and end."""
    line = sys.stdin.buffer.readline(LONGEST)
    if not line:  # the desk changed its mind
        _say(Said(0, 0, ended=True))
        return
    asked = msgspec.json.decode(line, type=Asked)
    folder = Path(asked.folder)
    try:
        count = mark_again(folder, asked.students, _told, _stopped)
        _say(Said(count, count, ended=True))
    except (CannotRead, Refused) as problem:
        _say(Said(0, 0, ended=True, problem=sentence(problem)))
    except OSError as problem:
        _say(Said(0, 0, ended=True, problem=f"the folder cannot be written: {problem}"))


def _told(done: int, every: int) -> None:
    _say(Said(done, every))


def _stopped() -> bool:
    """Return whether the desk has closed the input; it says nothing more by it."""
    ready, _, _ = select.select([0], [], [], 0)
    return bool(ready) and not os.read(0, 1)


def _say(said: Said) -> None:
    with suppress(BrokenPipeError):  # the desk has died: the marking stops as if it had said so
        sys.stdout.buffer.write(msgspec.json.encode(said) + b"\n")
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    main()
