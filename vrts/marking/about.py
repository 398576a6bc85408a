"""What a marking was: by which task, with which options, when. Stands beside its results.

It is written first, and again in the end: where results are, there is always something that tells
what they are of.
"""

from datetime import datetime
from typing import Literal

import msgspec

from vrts.marking.result import Damaged, Record, decoded
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

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
    finished: datetime | None  # with its offset; None: it goes on, or was interrupted
    intake_sha256: str = ""  # of intake.csv as written; "": it was edited
    begun: datetime | None = None  # with its offset; None: of an earlier vrts

    @property
    def when(self) -> datetime:
        """The end of the marking; while there is none, its begin."""
        found = self.finished or self.begun
        assert found is not None, "nothing else is read"
        return found


def to_bytes(about: About) -> bytes:
    """Return a marking as JSON, laid out for people."""
    return msgspec.json.format(msgspec.json.encode(about), indent=1) + b"\n"


def from_bytes(data: bytes) -> About:
    """Return the marking that JSON stands for.

    Raises:
        Damaged: It is none.
    """
    about = decoded(data, About)
    if about.finished is None and about.begun is None:
        raise Damaged("it does not tell when the marking was")
    return about
