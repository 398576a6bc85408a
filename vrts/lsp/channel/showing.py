"""What is shown beside a program while it is written: its mark in short, and its run to replay."""

from typing import NamedTuple


class Shown(NamedTuple):
    """What a verification has to show. All texts are one line and free of control characters."""

    mark: str  # "8.5 / 10"; empty without a task
    is_ready: bool  # for the real robot, as far as was looked
    ready_in: str  # "this scenario"; empty where it is not ready
    reasons: tuple[str, ...]  # why it is not ready, most serious first
    cause: str  # a sentence: what cost most
    is_settled: bool  # False: the task asks for every future, and the mark may come to be lower
    recording: str  # JSON, as the page of a report holds it
    line: int  # of the cause, from 1; 0: of no line of this file


def shown_of(row: list[object]) -> Shown:
    """Return what is shown from what JSON made of it."""
    mark, is_ready, ready_in, reasons, cause, is_settled, recording, line = row
    assert isinstance(reasons, list)
    assert isinstance(line, int)
    return Shown(
        str(mark),
        bool(is_ready),
        str(ready_in),
        tuple(str(reason) for reason in reasons),  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
        str(cause),
        bool(is_settled),
        str(recording),
        line,
    )
