"""The one exception of the public API."""

from collections.abc import Callable, Sequence
from functools import wraps
from typing import ParamSpec, TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.report.screen.text import diagnostic_text

P = ParamSpec("P")
T = TypeVar("T")


class VrtsError(Exception):
    """What was asked for cannot be done. Its text says why, as the commands say it.

    Attributes:
        codes: Codes of the diagnostics, such as `("V301",)`; empty for a wrong call.
    """

    codes: tuple[str, ...]

    def __init__(self, text: str, codes: Sequence[str] = ()) -> None:
        """Keep the text and the codes."""
        super().__init__(text)
        self.codes = tuple(codes)


def refusal(diagnostics: Sequence[Diagnostic]) -> VrtsError:
    """Return the error that says what diagnostics say; warnings only where nothing else is."""
    errors = [one for one in diagnostics if one.is_error] or list(diagnostics)
    text = "\n\n".join(text_of(one) for one in errors)
    return VrtsError(text, [one.rule.code for one in errors])


def wrong_call(message: str, *hints: str) -> VrtsError:
    """Return the error that says what is wrong with a call, and what to do."""
    return VrtsError("\n".join((message, *(f"help: {hint}" for hint in hints))))


def refuse(reason: str, **given: object) -> None:
    """Refuse what would change nothing.

    Args:
        reason: Why it would, as a sentence about what has it already.
        given: Values of arguments by their names; None: it is not given.

    Raises:
        VrtsError: One is given.
    """
    names = [f"`{name}`" for name, value in given.items() if value is not None]
    if names:
        raise wrong_call(reason, f"leave out {', '.join(names)}")


def text_of(diagnostic: Diagnostic) -> str:
    """Return a diagnostic as the commands show it, without colour."""
    return diagnostic_text(diagnostic, color=False)


def reason_of(problem: OSError) -> str:
    """Return in words why the system refused."""
    return (problem.strerror or "it failed").lower()


def public(function: Callable[P, T]) -> Callable[P, T]:
    """Let a function of the public API raise nothing but `VrtsError` where input is wrong."""

    @wraps(function)
    def guarded(*args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return function(*args, **kwargs)
        except CannotRead as problem:
            raise wrong_call(problem.message, *problem.hints) from problem
        except Refused as problem:
            raise refusal(problem.diagnostics) from problem
        except OSError as problem:
            where = "" if problem.filename is None else f": `{problem.filename}`"
            raise VrtsError(f"{reason_of(problem)}{where}") from problem

    return guarded
