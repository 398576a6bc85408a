"""Bodies of requests and answers about programs that are kept."""

from typing import Annotated, Literal, TypeAlias

import msgspec
from msgspec import Meta

from vrts.live.actions import LONGEST_PROGRAM

Shelf: TypeAlias = Literal["own", "room"]
Name: TypeAlias = Annotated[str, Meta(pattern=r"^\w[\w .-]{0,39}\Z")]


class KeepProgram(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A program is to be kept as a new version."""

    room: str
    shelf: Shelf
    name: Name
    text: Annotated[str, Meta(max_length=LONGEST_PROGRAM)]
    seen: Annotated[int, Meta(ge=0, le=2**31)]  # newest version that the saver knows of; 0: none


class DropProgram(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A program is to be forgotten, with all its versions."""

    room: str
    shelf: Shelf
    name: Name


class KeptVersion(msgspec.Struct, frozen=True):
    """A version as a page shows it."""

    name: str
    number: int
    at: float  # by the clock of the wall [s]
    saver: str  # empty: purged
    mine: bool
    length: int  # characters


class KeptPrograms(msgspec.Struct, frozen=True):
    """The newest version of every program."""

    own: tuple[KeptVersion, ...]
    room: tuple[KeptVersion, ...]


class KeptText(msgspec.Struct, frozen=True):
    """A version's text."""

    text: str


class Kept(msgspec.Struct, frozen=True):
    """What became of a save."""

    saved: bool  # false: the newest version is one that the saver has not seen
    version: KeptVersion | None
