"""How every call ends: with the status of its command, whatever happens to it on the way."""

import errno
import os
import sys
import traceback
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

import click

from vrts.cli.shared.console import (
    FAULT,
    INTERRUPTED,
    WRONG,
    WRONG_CALL,
    CannotSay,
    reason_of,
    sentence_of,
    warn,
)

HUNG_UP = 129  # as shells tell it of a program whose terminal has gone
READER_GONE = 141  # as shells tell it of a program whose reader has left
OUT, ERR = 1, 2
OF_STREAMS = (errno.EBADF, errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


class ReaderLeft(Exception):  # noqa: N818 -- names the situation
    """Whoever read a pipe of ours reads no more: click would take it for something wrong."""


class Ending(click.Group):
    """The group of all commands, which tells a reader that has left from what is wrong."""

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **extra: Any,
    ) -> click.Context:
        """Read the words of the call."""
        with _reader_may_leave():
            return super().make_context(info_name, args, parent, **extra)

    def invoke(self, ctx: click.Context) -> Any:
        """Carry out the command."""
        with _reader_may_leave():
            return super().invoke(ctx)


@contextmanager
def _reader_may_leave() -> Generator[None]:
    try:
        yield
    except BrokenPipeError as problem:
        raise ReaderLeft from problem


def run(command: click.Command, name: str) -> int:
    """Carry out what was typed; return the exit status.

    A command that prints to a full or closed place ends with one sentence. A reader that has left,
    as `head` does, gets no word.
    """
    try:
        status = _carried_out(command, name)
        sys.stdout.flush()
        return status
    except (BrokenPipeError, ReaderLeft):
        _forget(OUT)
        return READER_GONE
    except CannotSay as problem:
        return _cannot_say(str(problem), problem.__cause__)
    except OSError as problem:
        if problem.filename is None and problem.errno in OF_STREAMS:  # that click wrote to
            return _cannot_say(f"cannot write to stdout: {reason_of(problem)}", problem)
        return _wrong_call(sentence_of(problem))
    except Exception:  # the last line of defence: a fault of ours has its own status
        return _fault()


def _cannot_say(sentence: str, problem: BaseException | None) -> int:
    """Say that a stream takes no more; return the exit status."""
    _forget(OUT)
    if isinstance(problem, OSError) and problem.errno == errno.EIO:
        _forget(ERR)
        return HUNG_UP
    return _wrong_call(sentence)


def _wrong_call(sentence: str) -> int:
    """Say what the system refused; return the exit status."""
    try:
        warn(f"error: {sentence}")
    except CannotSay:  # stderr is full, too: the status alone is left
        _forget(ERR)
    return WRONG_CALL


def _carried_out(command: click.Command, name: str) -> int:
    try:
        found = command.main(prog_name=name, standalone_mode=False)
        return found if isinstance(found, int) else 0
    except click.ClickException as problem:
        problem.show()
        return problem.exit_code
    except click.Abort as problem:
        if isinstance(problem.__context__, KeyboardInterrupt):
            warn("interrupted")
            return INTERRUPTED
        warn("ended: nothing more was typed")  # Ctrl-D where something was asked
        return WRONG
    except KeyboardInterrupt:
        warn("interrupted")
        return INTERRUPTED
    except SystemExit as asked:
        if isinstance(asked.code, str):
            warn(asked.code)
        return asked.code if isinstance(asked.code, int) else int(asked.code is not None)


def _fault() -> int:
    try:
        traceback.print_exc()
        click.echo("vrts itself failed: please report the text above", err=True)
    except OSError:  # nobody can read it
        _forget(ERR)
    return FAULT


def open_streams() -> None:
    """Put something where stdin, stdout or stderr are closed, so that no file takes their place.

    Nothing comes from a closed stdin, words to a closed stderr are for nobody, and results to a
    closed stdout fail as they do elsewhere.
    """
    for number, flags in ((0, os.O_RDONLY), (OUT, os.O_RDONLY), (ERR, os.O_WRONLY)):
        try:
            os.fstat(number)
        except OSError as problem:
            if problem.errno != errno.EBADF:
                raise
            os.open(os.devnull, flags)  # takes the lowest number that is free: this one
    if sys.stdin is None:
        sys.stdin = open(0, encoding="utf-8", closefd=False)  # noqa: SIM115
    if sys.stdout is None:
        sys.stdout = open(OUT, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
    if sys.stderr is None:
        sys.stderr = open(ERR, "w", encoding="utf-8", closefd=False)  # noqa: SIM115


def _forget(number: int) -> None:
    """Let what is still to be written to a stream go nowhere."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, number)
    os.close(nowhere)
