"""What a browser may ask of a rehearsal, and what the server passes on to the process of it.

Every message of the browser has the number of its rehearsal, `id`, which the answers repeat. Times
are in s: of the run where it begins at the start, of the session where it begins now.
"""

from typing import Annotated, Final, Literal, TypeAlias

import msgspec
from msgspec import Meta

from vrts.live.actions import LONGEST_PROGRAM
from vrts.live.session.channel.messages import Start

MOST_BREAKPOINTS: Final = 200
LONGEST_S: Final = 1e7  # of a time [s]

Id = Annotated[int, Meta(ge=1, le=2**31)]
Name = Annotated[str, Meta(pattern=r"^[\w.-][\w .-]{0,63}\Z")]  # as the page names files
Text = Annotated[str, Meta(max_length=LONGEST_PROGRAM)]
Line = Annotated[int, Meta(ge=1, le=LONGEST_PROGRAM)]  # of the text, from 1
Lines = Annotated[tuple[Line, ...], Meta(max_length=MOST_BREAKPOINTS)]
What = Literal["run", "over", "into", "out", "back", "back_run", "start", "end"]


class _Strict(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="type"):
    id: Id


class Rehearse(_Strict, frozen=True, tag="rehearse"):
    """Run a text; answered by `Refused` or `Ready`. An earlier rehearsal is over."""

    text: Text
    name: Name = "program.v2"  # of its file
    begins: Literal["start", "now"] = msgspec.field(default="start", name="from")
    breakpoints: Lines = ()


class Breakpoints(_Strict, frozen=True, tag="breakpoints"):
    """Stop at these lines from now on; answered by `Placed`."""

    lines: Lines


class Go(_Strict, frozen=True, tag="go"):
    """Go somewhere from the present place; answered by `Stopped`."""

    what: What


class At(_Strict, frozen=True, tag="at"):
    """Go to a time; answered by `Stopped`."""

    time_s: Annotated[float, Meta(ge=0.0, le=LONGEST_S)]


class AskBlock(_Strict, frozen=True, tag="block"):
    """Poses of a minute of the run; answered by `Block`."""

    number: Annotated[int, Meta(ge=0, le=200_000)]  # it begins at `number * BLOCK`


class Stop(_Strict, frozen=True, tag="stop"):
    """End the rehearsal; answered by `Ended`."""


class Begin(msgspec.Struct, frozen=True, tag_field="type", tag="begin"):
    """The server's own: `Rehearse` with where it takes place. No browser may send it."""

    where: Start  # scene and task, with the digest of those that the room's session has
    order: Rehearse
    state: str = ""  # of the session that it begins with, in base64; empty: it begins at the start


Asked: TypeAlias = Rehearse | Breakpoints | Go | At | AskBlock | Stop
PassedOn: TypeAlias = Begin | Breakpoints | Go | At | AskBlock

asked = msgspec.json.Decoder(Asked).decode
passed_on = msgspec.json.Decoder(PassedOn).decode
as_json = msgspec.json.Encoder().encode
