"""A file that was checked, for reports on several."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic


class Checked(NamedTuple):
    """One file and what was found in it."""

    name: str  # as shown
    diagnostics: tuple[Diagnostic, ...]
    compiles: bool
