"""What cannot be said to a controller, with the line of the program."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import Span


class CannotSay(Exception):  # noqa: N818 -- names the situation
    """A part of a program means nothing that the controller does."""

    def __init__(self, headline: str, remedy: str = "write the step without it") -> None:
        """Keep what is missing and what helps; who knows the line adds it."""
        super().__init__(headline)
        self.headline, self.remedy = headline, remedy

    def diagnostic(self, rule: Rule, span: Span) -> Diagnostic:
        """Return what to tell, by the rule of a controller, at a place."""
        return error(rule, self.headline, Label(span), help=(self.remedy,))
