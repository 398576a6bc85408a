"""What can be wrong between vrts and a controller, in words."""

from vrts.base.diagnostic import Rule, error
from vrts.pipeline.refused import Refused

NO_PORT = Rule("V832", "no-port")
LINE_LOST = Rule("V833", "line-lost")
UNLIKE_PROFILE = Rule("V834", "unlike-profile")
WRONG_ECHO = Rule("V835", "wrong-echo")
CONTROLLER_REFUSES = Rule("V836", "controller-refuses")
PROGRAM_RUNNING = Rule("V837", "program-running")
THERE_ALREADY = Rule("V838", "there-already")
READ_BACK_DIFFERS = Rule("V839", "read-back-differs")
LISTING_UNREADABLE = Rule("V840", "listing-unreadable")
NOT_AT_COMMANDS = Rule("V841", "not-at-commands")
NOT_SENT = Rule("V842", "not-sent")
OTHER_PROFILE = Rule("V843", "other-profile")

_MOST = 200  # characters of what came that are shown


def stop(rule: Rule, headline: str, *notes: str, remedy: str = "") -> Refused:
    """Return what ends a conversation with a controller."""
    return Refused((error(rule, headline, notes=notes, help=(remedy,) if remedy else ()),))


def unlike(expected: str, came: str, doing: str) -> Refused:
    """Return what is raised for a controller that answers unlike its profile."""
    return stop(
        UNLIKE_PROFILE,
        f"the controller does not answer as its profile says: {doing}",
        f"expected: {expected}",
        f"came: {visible(came)}",
        remedy="look at the transcript; if the controller is right, correct a copy of the profile",
    )


def visible(text: str) -> str:
    """Return the end of what came in quotation marks, with control characters as escapes."""
    if not text:
        return "nothing"
    cut = text[-_MOST:]
    return ("…" if len(text) > _MOST else "") + ascii(cut)
