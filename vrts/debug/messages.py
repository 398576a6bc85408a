"""What log points write: text with expressions in braces."""

import re

from vrts.debug.evaluating import CannotTell, evaluate
from vrts.debug.passages import Instant
from vrts.engine.run import Run
from vrts.lang.dialect import Dialect
from vrts.monitor.listings import value_text

_BRACES = re.compile(r"\{([^{}]*)\}")


def filled(message: str, run: Run, at: Instant, dialect: Dialect) -> str:
    """Return a message with the values that its expressions have at an instant."""

    def value(found: re.Match[str]) -> str:
        try:
            known = evaluate(run, at, found[1], dialect)
        except CannotTell as problem:
            return f"<{problem}>"
        return known if isinstance(known, str) else value_text(known).strip()

    return _BRACES.sub(value, message)
