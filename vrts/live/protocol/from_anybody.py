"""What anybody in a room may say, and its operator.

The first message of a connection is `Join`; the answer is `Welcome`, then `Snapshot`. What people
do passes `Command` with the lease of the control right and a number that grows by any amount from
command to command; `Panic` needs neither.
"""

from typing import Annotated

from msgspec import Meta

from vrts.live.actions import Action, Number, Strict
from vrts.live.protocol.fields import LONGEST_NOTE, VERSION, Count, Id, Of, Rate, Text


class Join(Strict, frozen=True, tag="join"):
    """Enter a room; the account is known by the cookie."""

    room: Id = ""  # empty: the account's own room, else the first one
    rate: Rate = 50  # pose frames a second
    resume: Annotated[str, Meta(max_length=128)] = ""  # `Welcome.resume` of the dropped connection
    seen: Count = 0  # last `number` that was seen
    version: int = VERSION


class SetRate(Strict, frozen=True, tag="rate"):
    """Choose the pose frames a second."""

    rate: Rate


class Command(Strict, frozen=True, tag="command"):
    """An action of the operator, answered by `Result` or `Refused`."""

    lease: Id  # `Control.lease`
    number: Of  # greater than the one before on this lease
    action: Action


class Panic(Strict, frozen=True, tag="panic"):
    """Stop the arm now. Operator and supervisor; needs no lease, is never held back."""


class RequestControl(Strict, frozen=True, tag="request_control"):
    """Ask for the control right: at once if it is free, else stand in the queue."""


class HandBack(Strict, frozen=True, tag="hand_back"):
    """Give the control right back, or leave the queue."""


class RaiseHand(Strict, frozen=True, tag="raise_hand"):
    """Raise or lower one's hand."""

    up: bool
    text: Annotated[str, Meta(max_length=LONGEST_NOTE)] = ""  # in a room of one's own: about what


class Wake(Strict, frozen=True, tag="wake"):
    """Wake the robot of a room of somebody's own; entering does so too."""


class Point(Strict, frozen=True, tag="point"):
    """Point at a thing of the scene, in a room of somebody's own: all others there see it."""

    body: Id  # empty: at nothing any more


class Say(Strict, frozen=True, tag="say"):
    """Chat, with everybody in the room or with the supervisors only."""

    text: Text
    private: bool = False
    to: Id = ""  # supervisors may answer one person privately


class Noticed(Strict, frozen=True, tag="noticed"):
    """The announcement is on the screen, or was closed there."""

    id: Annotated[int, Meta(ge=1, le=2**53)]
    closed: bool = False


class Note(Strict, frozen=True, tag="note"):
    """Put a note at this moment of the session. Operator and supervisor."""

    text: Annotated[str, Meta(min_length=1, max_length=LONGEST_NOTE)]


class AskReach(Strict, frozen=True, tag="reach"):
    """Ask whether the tool can go somewhere; answered by `Reach`."""

    of: Of
    position_m: tuple[Number, Number, Number]
    oat_rad: tuple[Number, Number, Number]
    straight: bool = False


class AskProgram(Strict, frozen=True, tag="program"):
    """Ask for what was done as a VAL-II program, without saving; answered by `Program`."""

    of: Of
    name: Annotated[str, Meta(max_length=64)]


class GoOnFrom(Strict, frozen=True, tag="go_on_from"):
    """Ask for a private room that goes on from a moment of this one; answered by `Branched`."""

    of: Of
    at_s: Annotated[float, Meta(ge=0.0, le=1e7)]  # session time
