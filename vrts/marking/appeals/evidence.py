"""What is in an evidence zip: everything that one mark rests on, and nothing about anybody else."""

from typing import Annotated, Literal, NamedTuple

from msgspec import Meta

from vrts.base.diagnostic import Rule, error
from vrts.marking.result import Digest, Record, Result
from vrts.marking.row import Row
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.pipeline.refused import Refused

DAMAGED = Rule("V764", "damaged-evidence")
ALTERED = Rule("V765", "altered-evidence")

CONTENTS = "evidence.json"
README = "README.txt"
TASK = "task.zip"
ROW = "row.json"
INTAKE = "intake.csv"
CHANGES = "overrides.toml"
DECISIONS = "decisions.jsonl"
SUBMISSION, STAFF, STUDENT, OVER = "submission", "staff", "student", "over"  # folders

SCHEMA = "vrts.evidence/1"
MODE = 0o600  # of members
MOST_FILES = 200
LARGEST_ZIP = 300_000_000  # bytes
LARGEST_ALL = 600_000_000  # bytes of all files, decompressed
LARGEST_CONTENTS = 1_000_000  # bytes


class Contents(Record, frozen=True):
    """What an evidence zip says about itself."""

    schema: Literal["vrts.evidence/1"]
    id: str
    title: Annotated[str, Meta(description="of the program, as it was marked")]
    program: Annotated[str | None, Meta(description="which file; null: there is none")]
    place: Annotated[Place, Meta(description="task and what is laid over it, as files in here")]
    wanted: Wanted
    marked: Annotated[str, Meta(description="when; ISO 8601")]
    command: Annotated[tuple[str, ...], Meta(description="files handed in are left out")]
    versions: Annotated[dict[str, str], Meta(description="of what packed this")]
    sha256: Annotated[dict[str, Digest], Meta(description="of every other file")]


class Evidence(NamedTuple):
    """An evidence zip that was read and found whole."""

    contents: Contents
    row: Row
    staff: Result
    student: Result
    files: dict[str, bytes]  # without the contents

    @property
    def program(self) -> bytes | None:
        """The program as it was handed in; None: there was none to mark."""
        if self.staff.program is None or self.contents.program is None:
            return None
        return self.files[self.contents.program]


def damaged(why: str) -> Refused:
    """Return that a file cannot be used as evidence."""
    headline = f"this is no evidence that vrts has packed: {why}"
    remedy = "get the file again from whoever packed it"
    return Refused((error(DAMAGED, headline, help=(remedy,)),))


def altered(why: str) -> Refused:
    """Return that evidence is no longer what was packed."""
    headline = f"this evidence was altered after it was packed: {why}"
    remedy = "ask for the zip as `vrts grade evidence` wrote it"
    return Refused((error(ALTERED, headline, help=(remedy,)),))
