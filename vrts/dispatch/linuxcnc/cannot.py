"""What cannot be said to LinuxCNC, with the line of the program."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import Span

CANNOT_SAY = Rule("V870", "linuxcnc-cannot")


class CannotSay(Exception):  # noqa: N818 -- names the situation
    """A part of a program means nothing that LinuxCNC does."""

    def __init__(self, headline: str, remedy: str = "write the step without it") -> None:
        """Keep what is missing and what helps; who knows the line adds it."""
        super().__init__(headline)
        self.headline, self.remedy = headline, remedy

    def diagnostic(self, span: Span) -> Diagnostic:
        """Return what to tell, at a place."""
        return error(CANNOT_SAY, self.headline, Label(span), help=(self.remedy,))
