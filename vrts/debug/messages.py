"""What log points write: text with expressions in braces."""

import re

from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.evaluating import CannotTell
from vrts.debug.passages import Instant
from vrts.engine.memory.trace import Activation
from vrts.monitor.listings import value_text

_BRACES = re.compile(r"\{([^{}]*)\}")


class Message:
    """A text with expressions in braces, taken apart once and filled at many instants."""

    def __init__(self, text: str, expressions: Expressions) -> None:
        """Take the text, and the expressions of the run."""
        parts = _BRACES.split(text)  # texts and, between them, expressions
        self._first = parts[0]
        self._asked = [
            (expressions.of(asked), behind)
            for asked, behind in zip(parts[1::2], parts[2::2], strict=True)
        ]

    def filled(
        self,
        at: Instant,
        activation: Activation | None,
        hear: Hear = nobody,
        *,
        process: bool = False,
    ) -> str:
        """Return it with the values that its expressions have at an instant.

        Args:
            at: When it is written.
            activation: The program that writes it, and sees its own variables.
            hear: Who is heard meanwhile.
            process: It was called, maybe indirectly, by the process control program.
        """
        pieces = [self._first]
        for expression, behind in self._asked:
            try:
                known = expression.value(at, activation, hear, process=process)
            except CannotTell as problem:
                pieces += (f"<{problem}>", behind)
            else:
                pieces += (known if isinstance(known, str) else value_text(known).strip(), behind)
        return "".join(pieces)
