"""What is told of the hand: bodies not met squarely, missed, dropped, and toppled."""

from collections.abc import Sequence

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.units import mm
from vrts.engine.memory.events import Cause, Found

CLOSED_ON_NOTHING = Rule("V310", "nothing-grasped")
OFF_CENTRE = Rule("V311", "off-centre")
DROPPED = Rule("V312", "dropped")
TOPPLED = Rule("V313", "toppled")

DROP_HEIGHT = 2e-3  # [m] letting go higher than this is a drop [assumed]


def off_centre(time_s: float, body: str, cause: Cause) -> Found:
    """Return that the hand closes beside a body."""
    return _found(
        time_s,
        OFF_CENTRE,
        f"the hand closes beside `{body}`: the pads do not meet it from both sides",
        cause,
        help="bring the point between the pads over the middle of the object",
        body=body,
    )


def closed_on_nothing(time_s: float, cause: Cause, *, already: bool) -> Found:
    """Return that the hand closes on nothing, or was closed already."""
    return _found(
        time_s,
        CLOSED_ON_NOTHING,
        "the hand is told to close but is closed already"
        if already
        else "the hand closes on nothing",
        cause,
        help="open the hand before the approach: `OPENI`"
        if already
        else "compare the location with the object's in `vrts scene show`",
    )


def dropped(
    time_s: float, body: str, height_m: float, supports: Sequence[str], cause: Cause | None
) -> Found:
    """Return that a body is let go too high above its support."""
    return _found(
        time_s,
        DROPPED,
        f"`{body}` is let go {mm(height_m):.0f} mm above {named(supports)}",
        cause,
        help="open the hand only when the object stands on its support",
        body=body,
    )


def toppled(time_s: float, body: str, supports: Sequence[str], cause: Cause | None) -> Found:
    """Return that a body cannot stand as it is let go."""
    return _found(
        time_s,
        TOPPLED,
        f"`{body}` cannot stand on {named(supports)} as it is let go",
        cause,
        help="hold the object upright and over the middle of its support",
        body=body,
    )


def named(supports: Sequence[str]) -> str:
    """Return one or several bodies in words."""
    return " and ".join(f"`{name}`" for name in supports)


def _found(
    time_s: float,
    rule: Rule,
    headline: str,
    cause: Cause | None,
    *,
    help: str,  # noqa: A002 -- the diagnostic's own word
    body: str = "",
) -> Found:
    diagnostic = Diagnostic(
        rule,
        Severity.WARNING,
        headline,
        Label(cause.span) if cause else None,
        help=(help,),
        data={"time_s": round(time_s, 3), "body": body},
    )
    return Found(time_s, diagnostic, cause)
