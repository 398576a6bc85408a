"""Exports of Gradescope: submission_metadata.yml, and a folder for each submission."""

import re
from collections.abc import Iterator, Mapping, Sequence
from datetime import UTC, datetime
from typing import NamedTuple, cast

import yaml

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Platform, Student, plain_id
from vrts.pipeline.files import CannotRead

METADATA = "submission_metadata.yml"
LARGEST = 64_000_000  # bytes of it: it repeats results and history
MOST_MEMBERS = 50  # of a group

_KEY = re.compile(r"submission_\w+")


class _Submission(NamedTuple):
    name: str  # of its folder
    submitters: tuple[Mapping[str, str], ...]
    created: str


def gradescope(metadata: bytes, tops: Mapping[str, Sequence[str]]) -> Layout:
    """Return the hand-ins of an export: a row for each student, also of a group.

    Args:
        metadata: Content of `submission_metadata.yml`.
        tops: Files by the entry of the export's root that they are, or are in.

    Raises:
        CannotRead: The metadata are not as Gradescope writes them.
    """
    submissions = tuple(_submissions(metadata))
    known = {submission.name for submission in submissions}
    hand_ins: list[HandIn] = []
    remarks: list[str] = []
    for submission in submissions:
        files = tuple(sorted(tops.get(submission.name, ())))
        received = _time(submission.created)
        if received is None:
            remarks.append(f"`{METADATA}` does not tell when `{submission.name}` came")
        hand_ins += _of(submission, files, received)
    for top, files in tops.items():
        if top not in known and top.startswith("submission_") and "/" in files[0]:
            remarks.append(f"`{top}` is not named in `{METADATA}`")
            hand_ins.append(HandIn(top, (top,), Student(""), tuple(sorted(files))))
    return Layout("Gradescope", tuple(hand_ins), tuple(remarks))


def _of(
    submission: _Submission, files: tuple[str, ...], received: datetime | None
) -> Iterator[HandIn]:
    number = submission.name.removeprefix("submission_")
    group = submission.name if len(submission.submitters) > 1 else ""
    for member in submission.submitters or ({},):
        sid, name, email = (plain_id(member.get(key, "")) for key in ("sid", "name", "email"))
        ids = {Platform.GRADESCOPE.value: number}
        if sid:
            ids[Platform.SIS.value] = sid
        yield HandIn(
            sid or email or f"{number} {name}",
            (name, sid or number),
            Student(name, email, ids=ids),
            files,
            received=received,
            group=group,
        )


def _time(text: str) -> datetime | None:
    """Return a time as Ruby writes it: `2026-03-01 22:59:30.123456789 Z`; None without a zone."""
    words = text.split()
    if len(words) == 3:
        words = [words[0], words[1].split(".")[0], words[2]]
        text = f"{words[0]}T{words[1]}{words[2]}"
    try:
        time = datetime.fromisoformat(text.replace("Z", "+00:00"))
    except ValueError:
        return None
    return None if time.tzinfo is None else time.astimezone(UTC).replace(microsecond=0)


def _submissions(metadata: bytes) -> Iterator[_Submission]:
    """Yield what is told of each submission.

    The tree of nodes is walked to a fixed depth, so that no alias is ever expanded.
    """
    if len(metadata) > LARGEST:
        raise CannotRead(f"`{METADATA}` is too large: {len(metadata):,} bytes")
    try:
        root = _LOADER(metadata).get_single_node()
    except (yaml.YAMLError, RecursionError, ValueError) as problem:
        raise CannotRead(f"`{METADATA}` is damaged") from problem
    if not isinstance(root, yaml.MappingNode):
        raise CannotRead(f"`{METADATA}` is not as Gradescope writes it")
    for key, value in _pairs(root):
        if not _KEY.fullmatch(key):
            raise CannotRead(f"`{METADATA}` is not as Gradescope writes it")
        fields = dict(_pairs(value))
        created = fields.get("created_at")
        people = fields.get("submitters")
        submitters = tuple(
            {name: _text(node) for name, node in _pairs(member)} for member in _items(people)
        )
        yield _Submission(key, submitters, _text(created))


_LOADER = yaml.CSafeLoader if yaml.__with_libyaml__ else yaml.SafeLoader


def _pairs(node: yaml.Node) -> Iterator[tuple[str, yaml.Node]]:
    """Yield keys, without the colon of Ruby's symbols, and values of a mapping."""
    if isinstance(node, yaml.MappingNode):
        for key, value in cast("list[tuple[yaml.Node, yaml.Node]]", node.value):
            yield _text(key).removeprefix(":"), value


def _items(node: yaml.Node | None) -> list[yaml.Node]:
    if not isinstance(node, yaml.SequenceNode):
        return []
    return cast("list[yaml.Node]", node.value)[:MOST_MEMBERS]


def _text(node: yaml.Node | None) -> str:
    if not isinstance(node, yaml.ScalarNode) or node.tag == "tag:yaml.org,2002:null":
        return ""
    return str(node.value).strip()
