"""What commands share: colour, diagnostics on stderr, files written, exit statuses."""

import os
import secrets
import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import click

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

HOLDS, WRONG, WRONG_CALL, UNDETERMINED, FAULT = 0, 1, 2, 3, 70
INTERRUPTED = 130  # by Ctrl-C, as shells tell it

UNAVAILABLE = {
    "coal": "this needs the package pin, which has no wheel for this machine (Windows): run vrts"
    " on Linux, on a Mac or in WSL; `vrts compile` and `vrts explain` work everywhere",
    "rerun": "recordings need the package rerun-sdk, which has no wheel for this machine (Intel"
    " Macs); everything else works without it",
}

Command = TypeVar("Command", bound=Callable[..., Any])

STDOUT = "-"  # in place of the name of a file that is written
QUIET, COLOR, ASIDE = "vrts.quiet", "vrts.color", "vrts.aside"  # in the context of click


class CannotSay(Exception):  # noqa: N818 -- names the situation
    """A stream of the command takes no more: its disk is full, or it is closed."""

    def __init__(self, stream: str, reason: str) -> None:
        """Say which stream, and why."""
        super().__init__(f"cannot write to {stream}: {reason}")


def is_quiet() -> bool:
    """Return whether only what is wrong is to be said."""
    return bool(_typed(QUIET, False))


def _typed(key: str, default: object) -> object:
    context = click.get_current_context(silent=True)
    return default if context is None else context.meta.get(key, default)


def use_color(choice: str, *, err: bool = False) -> bool:
    """Return whether to write colour to a stream."""
    if choice != "auto":
        return choice == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    stream = sys.stderr if err else sys.stdout
    return stream.isatty() and os.environ.get("TERM") != "dumb"


def say(text: str) -> None:
    """Write to stderr what is good to know: `--quiet` is silent then."""
    if not is_quiet():
        warn(text)


def note(text: str) -> None:
    """Say something beside the matter, as a note."""
    say(f"note: {text}")


def warn(text: str) -> None:
    """Write to stderr what has to be known; names in it may be anybody's."""
    from vrts.report.plain import plain_text

    _err(plain_text(text))


def _err(rendered: str) -> None:
    """Write to stderr what a renderer made, colours as given."""
    with _told("stderr"):
        click.echo(rendered, err=True, color=True)


def out(text: str, *, end: bool = True) -> None:
    """Write results to stdout, colours as given; to stderr where a file goes to stdout."""
    aside = bool(_typed(ASIDE, False))
    with _told("stderr" if aside else "stdout"):
        click.echo(text, nl=end, err=aside, color=True)


def out_bytes(data: bytes) -> None:
    """Write the bytes of a file to stdout, as they are."""
    with _told("stdout"):
        sys.stdout.buffer.write(data)
        sys.stdout.flush()


@contextmanager
def _told(stream: str) -> Generator[None]:
    """Tell that a stream failed from all else that the system may refuse."""
    try:
        yield
    except BrokenPipeError:
        raise
    except OSError as problem:
        raise CannotSay(stream, reason_of(problem)) from problem


def reason_of(problem: OSError) -> str:
    """Return in words why the system refused."""
    return (problem.strerror or str(problem) or "it failed").lower()


def sentence_of(problem: OSError) -> str:
    """Return in words why the system refused, and for which file."""
    if problem.filename is not None:
        return f"{reason_of(problem)}: `{problem.filename}`"
    return reason_of(problem) if _is_somewhere() else "the working folder is gone"


def _is_somewhere() -> bool:
    try:
        return bool(os.getcwd())
    except FileNotFoundError:
        return False


def show_diagnostics(found: Sequence[Diagnostic], color: str) -> None:
    """Write diagnostics to stderr, and count them."""
    from vrts.report.screen.text import diagnostic_text

    for diagnostic in found:
        if not (is_quiet() and diagnostic.severity is Severity.NOTE):
            _err(diagnostic_text(diagnostic, color=use_color(color, err=True)) + "\n")
    errors = sum(diagnostic.is_error for diagnostic in found)
    notes = sum(diagnostic.severity is Severity.NOTE for diagnostic in found)
    counts = ((errors, "error"), (len(found) - errors - notes, "warning"), (notes, "note"))
    words = [f"{n} {word}{'' if n == 1 else 's'}" for n, word in counts if n]
    if words:
        say(", ".join(words))


def fail(message: str, hints: Sequence[str] = (), status: int = WRONG_CALL) -> NoReturn:
    """Say in one sentence what is wrong with the call, and end."""
    warn(f"error: {message}")
    for hint in hints:
        warn(f"help: {hint}")
    sys.exit(status)


def was_interrupted(problem: BaseException) -> bool:
    """Return whether Ctrl-C ended it.

    Where it comes while a folder is taken away, Python may close the folder twice, and says that.
    """
    return isinstance(problem, KeyboardInterrupt) or (
        isinstance(problem, OSError) and isinstance(problem.__context__, KeyboardInterrupt)
    )


def guarded(function: Command) -> Command:
    """Turn what the pipeline raises into words and an exit status."""

    @wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except CannotRead as problem:
            fail(problem.message, problem.hints)
        except Refused as problem:
            show_diagnostics(problem.diagnostics, str(kwargs.get("color", _typed(COLOR, "auto"))))
            sys.exit(WRONG)
        except KeyboardInterrupt:
            warn("interrupted")
            sys.exit(INTERRUPTED)
        except BrokenPipeError:
            raise
        except ModuleNotFoundError as missing:
            if missing.name not in UNAVAILABLE:
                raise
            fail(UNAVAILABLE[missing.name], status=WRONG)
        except OSError as problem:
            if was_interrupted(problem):
                warn("interrupted")
                sys.exit(INTERRUPTED)
            fail(sentence_of(problem))

    return wrapped  # type: ignore[return-value]


def write_file(path: Path, data: bytes, *, private: bool = False) -> None:
    """Write a file whole or not at all, beside where it goes.

    `-` is stdout. A link stays a link, a file keeps its mode and its owner, and a pipe or a
    device is written to. What is private is ours alone afterwards, whatever was there.
    """
    if str(path) == STDOUT:
        out_bytes(data)
        return
    if path.exists() and not path.is_file():
        path.write_bytes(data)
        return
    file = path.resolve()
    draft = file.with_name(f".{secrets.token_hex(8)}.part")  # nobody else's file
    try:
        draft.touch(0o600 if private else 0o666, exist_ok=False)
        draft.write_bytes(data)
        if private or not file.exists() or _like(draft, file.stat()):
            draft.replace(file)
        else:
            file.write_bytes(data)  # somebody else's file that we may write to stays theirs
    except OSError as problem:
        problem.filename = str(path)  # of the draft nobody has heard
        raise
    finally:
        draft.unlink(missing_ok=True)


def _like(draft: Path, before: os.stat_result) -> bool:
    """Give a file the mode and the owner of another; return whether that was allowed."""
    now = draft.stat()
    if (now.st_uid, now.st_gid) != (before.st_uid, before.st_gid):
        try:
            os.chown(draft, before.st_uid, before.st_gid)
        except PermissionError:
            return False
    draft.chmod(before.st_mode & 0o7777)
    return True
