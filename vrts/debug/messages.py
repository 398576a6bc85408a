"""What log points write: text with expressions in braces."""

import re

from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.evaluating import CannotTell
from vrts.debug.passages import Instant
from vrts.engine.memory.trace import Activation
from vrts.monitor.listings import value_text

_BRACES = re.compile(r"\{([^{}]*)\}")


def filled(
    message: str,
    expressions: Expressions,
    at: Instant,
    activation: Activation | None,
    hear: Hear = nobody,
) -> str:
    """Return a message with the values that its expressions have at an instant.

    Args:
        message: Text with expressions in braces.
        expressions: Of the run.
        at: When it is written.
        activation: The program that writes it, which sees its arguments and automatic variables.
        hear: Who is heard meanwhile.
    """

    def value(found: re.Match[str]) -> str:
        try:
            known = expressions.of(found[1]).value(at, activation, hear)
        except CannotTell as problem:
            return f"<{problem}>"
        return known if isinstance(known, str) else value_text(known).strip()

    return _BRACES.sub(value, message)
