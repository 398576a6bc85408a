"""What log points write: text with expressions in braces."""

import re
from collections.abc import Sequence

import numpy as np

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

    def filled_all(
        self,
        instants: Sequence[Instant],
        activations: Sequence[Activation | None],
        processes: Sequence[bool],
        hear: Hear = nobody,
    ) -> list[str]:
        """Return what `filled` does at each of many instants.

        Args:
            instants: When it is written.
            activations: The program that writes it, beside each.
            processes: Whether it is that of the process control program, beside each.
            hear: Who is heard meanwhile.
        """
        columns: list[list[str]] = []
        sure = np.ones(len(instants), bool)
        for expression, behind in self._asked:
            reals, known = expression.reals(instants, activations, processes, hear)
            values: list[float] = np.where(known, reals, 0.0).tolist()
            columns.append([value_text(value).strip() + behind for value in values])
            sure &= known
        texts = [self._first + "".join(row) for row in zip(*columns, strict=True)]
        texts = texts or [self._first] * len(instants)
        for k in np.flatnonzero(~sure).tolist():
            texts[k] = self.filled(instants[k], activations[k], hear, process=processes[k])
        return texts

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
