"""What is asked and answered over HTTP: POST with a JSON body, answered with JSON."""

from typing import Annotated

import msgspec
from msgspec import Meta

from vrts.live.protocol.fields import Id
from vrts.live.protocol.listed import RoomEntry


class Enter(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /enter`: a join link's token or a class code, and the name to be shown."""

    code: Annotated[str, Meta(min_length=6, max_length=128)]
    name: Annotated[str, Meta(max_length=160)] = ""  # a link may bring its own


class LogIn(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /login`: a local account."""

    user: Annotated[str, Meta(min_length=1, max_length=64)]
    password: Annotated[str, Meta(min_length=1, max_length=256)]


class MakeLink(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /link`, supervisors only: a link that lets many into one room, under their names."""

    room: Id


class Link(msgspec.Struct, frozen=True):
    """The answer to `/link`."""

    url: str
    picture: str  # QR code, SVG


class Me(msgspec.Struct, frozen=True):
    """`GET /me`, and the answer to `/enter` and `/login`; 401 when nobody is logged in.

    `POST /logout` has no body and ends the cookie.
    """

    name: str
    supervisor: bool
    rooms: tuple[RoomEntry, ...]
    alone: bool = False  # there is nobody else


class Problem(msgspec.Struct, frozen=True):
    """The body of an HTTP refusal."""

    code: str
    text: str
    help: str = ""
