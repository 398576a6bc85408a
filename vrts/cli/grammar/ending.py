"""How every call ends: with the status of its command, whatever happens to it on the way."""

import errno
import os
import sys
import traceback
from contextlib import suppress

import click

from vrts.cli.shared.console import FAULT, INTERRUPTED, WRONG, WRONG_CALL, say

READER_GONE = 141  # as shells tell it of a program whose reader has left
OUT, ERR = 1, 2


def run(command: click.Command, name: str) -> int:
    """Carry out what was typed; return the exit status.

    A command that prints to a full or closed place ends with one sentence. A reader that has left,
    as `head` does, gets no word.
    """
    try:
        status = _carried_out(command, name)
        sys.stdout.flush()
        return status
    except BrokenPipeError:
        _forget(OUT)
        return READER_GONE
    except OSError as problem:  # of a stream: those of files are told where they happen
        if problem.filename is not None:
            return _fault()
        _forget(OUT)
        try:
            say(f"error: cannot write to stdout: {(problem.strerror or 'failed').lower()}")
        except OSError:  # stderr is the one that is full, or is full, too
            _forget(ERR)
        return WRONG_CALL
    except Exception:  # the last line of defence: a fault of ours has its own status
        return _fault()


def _carried_out(command: click.Command, name: str) -> int:
    try:
        found = command.main(prog_name=name, standalone_mode=False)
        return found if isinstance(found, int) else 0
    except click.ClickException as problem:
        problem.show()
        return problem.exit_code
    except click.Abort as problem:
        if isinstance(problem.__cause__, KeyboardInterrupt):
            say("interrupted")
            return INTERRUPTED
        say("ended: nothing more was typed")  # Ctrl-D where something was asked
        return WRONG
    except KeyboardInterrupt:
        say("interrupted")
        return INTERRUPTED
    except SystemExit as asked:
        if isinstance(asked.code, str):
            say(asked.code)
        return asked.code if isinstance(asked.code, int) else int(asked.code is not None)


def _fault() -> int:
    with suppress(OSError):
        traceback.print_exc()
        click.echo("vrts itself failed: please report the text above", err=True)
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
