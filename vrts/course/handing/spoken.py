"""What the server and the process that reads tasks say to each other: a line of JSON each."""

import msgspec

from vrts.course.variants.asked import GiveIt
from vrts.live.store.course.attempts import Loss

LONGEST = 16_000_000  # bytes of a line


class MarkIt(msgspec.Struct, frozen=True, tag="mark"):
    """Mark a program by the public checks of a task."""

    task: str  # path of its file
    digest: str
    program: bytes
    page: str  # path that its page is written to
    variant: str = ""  # tag of the variant that the task is; empty: it has none


class TellIt(msgspec.Struct, frozen=True, tag="tell"):
    """Tell what students get of a task."""

    task: str  # path of its file


class PublicMark(msgspec.Struct, frozen=True):
    """A public mark with its reasons."""

    state: str  # of an attempt
    mark: str | None = None  # a fraction
    total: str | None = None
    said: str = ""
    losses: tuple[Loss, ...] = ()


class Words(msgspec.Struct, frozen=True):
    """What students get of a task."""

    readme: str = ""  # Markdown
    start: str = ""  # the program to begin with
    problem: str = ""  # why there is nothing


Asked = MarkIt | TellIt | GiveIt
