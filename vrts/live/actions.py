"""What the operator of a session may do, as it travels from browser to server to session.

Lengths are in m, angles in rad, times in s, in the world frame unless said otherwise.
"""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

LONGEST_LINE = 512  # characters of a monitor line
LONGEST_PROGRAM = 200_000  # characters of an uploaded file

Number = Annotated[float, Meta(ge=-1e6, le=1e6)]
Line = Annotated[str, Meta(max_length=LONGEST_LINE)]
Name = Annotated[str, Meta(max_length=64)]
Frame = Literal["joint", "world", "tool"]
Axis = Annotated[int, Meta(ge=0, le=5)]
Way = Literal[1, -1]


class Strict(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="type"):
    """A message: unknown fields are refused, not ignored."""


class Typed(Strict, frozen=True, tag="line"):
    """A line of the monitor; also the answer where the monitor asks."""

    line: Line


class Interrupt(Strict, frozen=True, tag="interrupt"):
    """Ctrl-C at the monitor."""


class Upload(Strict, frozen=True, tag="upload"):
    """A VAL-II file, put into the user's own folder and loaded into memory."""

    name: Name  # of the file, without folders
    text: Annotated[str, Meta(max_length=LONGEST_PROGRAM)]


class Go(Strict, frozen=True, tag="go"):
    """Move the tool to the virtual pointer."""

    position_m: tuple[Number, Number, Number]  # of the tool, in the world frame
    oat_rad: tuple[Number, Number, Number]  # its O, A, T, in the world frame
    straight: bool = False  # along a line, else joint-interpolated


class Step(Strict, frozen=True, tag="step"):
    """One press of a key of the pendant."""

    frame: Frame
    axis: Axis  # joint 1 to 6, or X Y Z and turns about them
    way: Way
    size: Annotated[float, Meta(gt=0.0, le=1.0)]  # [m] along, [rad] about an axis or of a joint


class Jog(Strict, frozen=True, tag="jog"):
    """Begin to move while a key is held; `keep` must follow at least every 200 ms."""

    frame: Frame
    axis: Axis
    way: Way
    speed: Annotated[float, Meta(gt=0.0, le=1.0)] = 0.25  # share of the pendant's full speed


class Keep(Strict, frozen=True, tag="keep"):
    """The key is still held: the heartbeat of `jog`, every 100 ms or more often."""


class LetGo(Strict, frozen=True, tag="let_go"):
    """The key is released: the arm decelerates."""


class Hand(Strict, frozen=True, tag="hand"):
    """The open and close buttons."""

    open: bool


class Ready(Strict, frozen=True, tag="ready"):
    """The ready button: straight up."""


class Record(Strict, frozen=True, tag="record"):
    """Record where the arm is; a name with `#` is a precision point."""

    name: Name


class Save(Strict, frozen=True, tag="save"):
    """Write what was done since the beginning as a VAL-II program with named locations."""

    name: Name  # of the program


class Reset(Strict, frozen=True, tag="reset"):
    """Begin anew: the scene as it was at first."""


class Rewind(Strict, frozen=True, tag="rewind"):
    """Go back to an earlier moment and go on from there."""

    time_s: Annotated[float, Meta(ge=0.0, le=1e7)]


Action = (
    Typed
    | Interrupt
    | Upload
    | Go
    | Step
    | Jog
    | Keep
    | LetGo
    | Hand
    | Ready
    | Record
    | Save
    | Reset
    | Rewind
)
