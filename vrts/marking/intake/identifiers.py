"""Names of hand-ins in results: unique on every system, and the same in every run."""

from vrts.base.safe_names import safe
from vrts.marking.intake.tree.file_names import same_name


class Identifiers:
    """Gives out each identifier once."""

    def __init__(self) -> None:
        """Start with none."""
        self._taken: set[str] = set()

    def take(self, *parts: str) -> str:
        """Return an identifier made of words, numbered where it is taken."""
        wanted = safe("-".join(part for part in parts if part))
        found, number = wanted, 2
        while same_name(found) in self._taken:
            found, number = f"{wanted}-{number}", number + 1
        self._taken.add(same_name(found))
        return found
