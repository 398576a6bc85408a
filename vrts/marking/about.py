"""What a marking was: by which task, with which options, when. Stands beside its results."""

from datetime import datetime
from typing import Literal

import msgspec

from vrts.marking.one import Wanted
from vrts.marking.result import Damaged, Record
from vrts.marking.setting import Place

SCHEMA = "vrts.marking/1"
NAME = "marking.json"


class About(Record, frozen=True):
    """One marking of a class."""

    schema: Literal["vrts.marking/1"]
    title: str
    place: Place  # paths as they were given
    submissions: tuple[str, ...]
    wanted: Wanted
    vrts: str
    command: tuple[str, ...]
    finished: datetime  # with its offset
    intake_sha256: str = ""  # of intake.csv as written; "": it was edited


def to_bytes(about: About) -> bytes:
    """Return a marking as JSON, laid out for people."""
    return msgspec.json.format(msgspec.json.encode(about), indent=1) + b"\n"


def from_bytes(data: bytes) -> About:
    """Return the marking that JSON stands for.

    Raises:
        Damaged: It is none.
    """
    try:
        return msgspec.json.decode(data, type=About)
    except msgspec.MsgspecError as problem:
        raise Damaged(str(problem)) from problem
