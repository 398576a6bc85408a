"""Why a request ends before it has begun: errors in what it names."""

from vrts.base.diagnostic import Diagnostic


class Refused(Exception):  # noqa: N818 -- names the situation
    """A scene or task file has errors; the diagnostics say which."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        """Keep everything that was found."""
        super().__init__("errors in a scene or task file")
        self.diagnostics = diagnostics
