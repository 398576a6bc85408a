"""What log points write: text with expressions in braces."""

import re
from collections.abc import Mapping

from vrts.debug.evaluating import CannotTell, evaluate
from vrts.debug.passages import Instant
from vrts.engine.run import Run
from vrts.ir.values import Value
from vrts.lang.dialect import Dialect
from vrts.monitor.listings import value_text

_BRACES = re.compile(r"\{([^{}]*)\}")


def filled(message: str, run: Run, at: Instant, dialect: Dialect, seen: Mapping[str, Value]) -> str:
    """Return a message with the values that its expressions have at an instant.

    Args:
        message: Text with expressions in braces.
        run: A run that can go on.
        at: When it is written.
        dialect: Of the program.
        seen: Arguments and automatic variables of the program that writes it.
    """

    def value(found: re.Match[str]) -> str:
        try:
            known = evaluate(run, at, found[1], dialect, seen)
        except CannotTell as problem:
            return f"<{problem}>"
        return known if isinstance(known, str) else value_text(known).strip()

    return _BRACES.sub(value, message)
