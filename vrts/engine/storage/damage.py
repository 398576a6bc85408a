"""Why a saved run cannot be read, written or believed."""

from vrts.base.diagnostic import Diagnostic, Rule, error

DAMAGED = Rule("V540", "damaged-run")
TOO_LARGE = Rule("V541", "run-too-large")
OTHER_FORMAT = Rule("V542", "run-format")
NOT_REMADE = Rule("V543", "run-not-remade")
DIFFERS = Rule("V544", "run-differs")
NOT_SAVED = Rule("V545", "run-not-saved")

RUN_AGAIN = "run the program again with `--save`"


class Damaged(Exception):  # noqa: N818 -- names the situation
    """The bytes of a saved run are not what they should be. Every reader's caller catches it."""

    def __init__(self, reason: str) -> None:
        """Say what is wrong, as the second half of a headline."""
        super().__init__(reason)
        self.reason = reason

    def diagnostic(self, name: str) -> Diagnostic:
        """Return what to tell about a file of a name."""
        return error(
            DAMAGED, f"the saved run `{name}` is damaged: {self.reason}", help=(RUN_AGAIN,)
        )


class TooLarge(Damaged):
    """There is more in the file than a run may take."""

    def diagnostic(self, name: str) -> Diagnostic:
        """Return what to tell about a file of a name."""
        return error(
            TOO_LARGE, f"the saved run `{name}` is too large: {self.reason}", help=(RUN_AGAIN,)
        )


def not_remade(name: str, what: str, *notes: str) -> Diagnostic:
    """Return what to tell when a sound file cannot become a run here and now.

    Args:
        name: Of the file, as shown.
        what: Is not as it was, as a sentence.
        notes: What is known about it.
    """
    headline = f"the saved run `{name}` cannot be made again: {what}"
    return error(NOT_REMADE, headline, notes=notes, help=(RUN_AGAIN,))


def require(held: bool, reason: str) -> None:
    """Go on when something holds.

    Raises:
        Damaged: It does not.
    """
    if not held:
        raise Damaged(reason)
