"""What pages about people of a course are told and say: JSON."""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

Email = Annotated[str, Meta(min_length=3, max_length=254)]
Name = Annotated[str, Meta(min_length=1, max_length=160)]
Token = Annotated[str, Meta(min_length=40, max_length=128)]


class AskLetter(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/letter`: whose link this is."""

    code: Token


class LetterTold(msgspec.Struct, frozen=True):
    """The answer to it."""

    course: str  # title
    name: str
    email: str


class ChoosePassword(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/password`: what somebody chooses who has a link; logs them in."""

    code: Token
    password: Annotated[str, Meta(min_length=10, max_length=256)]


class PersonRow(msgspec.Struct, frozen=True):
    """Somebody, as teachers see them."""

    account: int
    name: str
    email: str
    rank: str
    rooms: tuple[str, ...]  # of an assistant; empty: all
    team: str
    seen: float  # when they were here last, Unix time [s]; 0: never
    here: bool
    way: Literal["password", "provider", "link", "none"]  # how they can come in now
    listed: bool
    origin: str  # "file", or "page": was added there


class PeopleTold(msgspec.Struct, frozen=True):
    """`GET /course/people/list`, teachers only."""

    title: str
    fault: str  # of the files, which keeps people as they were; empty: none
    rooms: tuple[str, ...]  # shared ones, by name
    people: tuple[PersonRow, ...]


class AddStaff(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/people/add`, teachers only; answered by `NewLink`."""

    name: Name
    email: Email
    rank: Literal["teacher", "assistant"]
    rooms: Annotated[tuple[Name, ...], Meta(max_length=64)] = ()


class Whose(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/people/link` and `/course/people/end`, teachers only."""

    account: int


class NewLink(msgspec.Struct, frozen=True):
    """A link with which somebody comes in, once, and chooses a password."""

    name: str
    url: str
