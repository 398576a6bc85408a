"""What is to be verified, and what is known of it so far, as lines of JSON and back."""

import json
from enum import Enum
from typing import Any, NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import SourceFile, Span
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.channel.findings import Finding, Found, Mending, Related, told
from vrts.lsp.channel.showing import Shown, shown_of
from vrts.lsp.channel.timing import Timing
from vrts.lsp.documents.documents import Document

STOPPED = Rule("V797", "verification-stopped")

CPU_S = 20  # of one verification


class Asked(NamedTuple):
    """What is to be verified."""

    path: str  # of the program; a task beside it tells scene and scenario
    text: str  # of the buffer
    others: tuple[tuple[str, str], ...] = ()  # paths and texts of what belongs together with it
    is_called: bool = False  # by one of them, so it is no program by itself
    is_shown: bool = False  # beside the text: mark and recording are wanted, too


class Lost(NamedTuple):
    """A place where points are lost, and why, as far as the task lets that be told."""

    start: int
    end: int
    why: str


class Answer(NamedTuple):
    """What is known so far."""

    timings: tuple[Timing, ...] = ()
    findings: tuple[Finding, ...] = ()
    is_whole: bool = False  # nothing more comes
    lost: tuple[Lost, ...] = ()
    mendable: bool = False  # points are lost, and the task lets the change be told that mends it
    shown: Shown | None = None  # if that is wanted, and the program has run


def header_of(asked: Asked, entry: str | None = None) -> Label:
    """Return where a program of a text begins; the first one, if there is none of that name."""
    programs = Document(asked.path, asked.text).names.programs
    chosen = next((p for p in programs if p.name == entry), programs[0] if programs else None)
    source = SourceFile(asked.path, asked.text)
    if chosen is None:
        return Label(Span(source, 0, 0))
    return Label(Span(source, chosen.name_start, chosen.name_end))


def stopped(asked: Asked, so_far: Answer, why: str) -> Answer:
    """Return an answer that says that a verification did not come to its end."""
    header = header_of(asked)
    note = Diagnostic(
        STOPPED,
        Severity.NOTE,
        f"the verification in the background was stopped {why}",
        header,
        help=("`vrts verify` takes the time it needs",),
    )
    (finding,) = told([Found(note)], asked.path, header)
    return Answer(so_far.timings, (*so_far.findings, finding), is_whole=True)


# --- as lines -----------------------------------------------------------------------------------


def line_of(message: Asked | Answer) -> bytes:
    """Return a line that says what is asked, or what is known."""
    return json.dumps(message, default=_plain).encode() + b"\n"


def asked_of(line: bytes) -> Asked:
    """Return what is asked from the line that it was written as."""
    path, text, others, is_called, is_shown = json.loads(line)
    return Asked(path, text, tuple((p, t) for p, t in others), is_called, is_shown)


def answer_of(line: bytes) -> Answer:
    """Return an answer from the line that it was written as."""
    times, findings, is_whole, lost, mendable, shown = json.loads(line)
    return Answer(
        tuple(Timing(number, tuple(ends), *more) for number, ends, *more in times),
        tuple(_finding(row) for row in findings),
        is_whole,
        tuple(Lost(*row) for row in lost),
        mendable,
        None if shown is None else shown_of(shown),
    )


def _finding(row: list[Any]) -> Finding:
    path, code, severity, message, start, end, related, mending, scenario = row
    return Finding(
        path,
        code,
        Severity(severity),
        message,
        start,
        end,
        tuple(Related(*place) for place in related),
        None if mending is None else Mending(mending[0], tuple(Edit(*e) for e in mending[1])),
        scenario,
    )


def _plain(value: object) -> object:
    assert isinstance(value, Enum)
    return value.value
