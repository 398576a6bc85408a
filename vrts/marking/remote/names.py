"""Who is called what on other machines, and results called by their names again.

A pseudonym is drawn by lot and tells nothing. Of the name of a file only an ending that says which
language it is in goes along.
"""

import json
import re
import secrets
from html import escape
from pathlib import PurePath
from typing import Annotated

import msgspec
from msgspec import Meta

from vrts.marking.result import Record, Result
from vrts.report.plain import one_line

PSEUDONYM = r"s[0-9a-f]{12}"
KEPT_ENDINGS = frozenset((".as", ".lc", ".pg", ".rv", ".st", ".txt", ".v2", ".val"))

Pseudonym = Annotated[str, Meta(pattern=f"^{PSEUDONYM}$")]
Label = Annotated[str, Meta(pattern=rf"^{PSEUDONYM}(\.[a-z0-9]{{1,3}})?$")]


class Naming(Record, frozen=True):
    """Both names of a submission."""

    pseudonym: Pseudonym
    identifier: str
    title: str  # of the program, as shown at home

    @property
    def label(self) -> Label:
        """The title that it has elsewhere."""
        ending = PurePath(self.title).suffix.lower()
        return self.pseudonym + (ending if ending in KEPT_ENDINGS else "")


def named_anew(identifier: str, title: str) -> Naming:
    """Return a submission with a pseudonym."""
    return Naming("s" + secrets.token_hex(6), identifier, title)


def result_at_home(result: Result, naming: Naming) -> Result:
    """Return a result as if it had been made at home: with id and title in place of others.

    Sentences that name the file do so with its title, on one line where ours are.
    """
    old, new, line = naming.label, naming.title, one_line(naming.title)
    program = result.program
    return msgspec.structs.replace(
        result,
        id=naming.identifier,
        program=None if program is None else msgspec.structs.replace(program, name=new),
        cause=result.cause.replace(old, line),
        hint=None if result.hint is None else result.hint.replace(old, line),
        obstacles=_each(result.obstacles, old, line),
        review=_each(result.review, old, line),
        losses=tuple(
            msgspec.structs.replace(loss, sentence=loss.sentence.replace(old, new))
            for loss in result.losses
        ),
        findings=tuple(
            msgspec.structs.replace(
                finding,
                headline=finding.headline.replace(old, new),
                help=_each(finding.help, old, new),
            )
            for finding in result.findings
        ),
    )


def page_at_home(page: bytes, naming: Naming) -> bytes:
    """Return an HTML page with the title as it is at home, escaped where it stands."""
    start, script, rest = page.partition(b"<script")
    old, line = naming.label.encode(), one_line(naming.title)
    in_text = escape(line, quote=True).encode()
    in_json = re.sub("[<>&]", _code, json.dumps(line)[1:-1]).encode()
    return start.replace(old, in_text) + script + rest.replace(old, in_json)


def _code(found: re.Match[str]) -> str:
    return f"\\u{ord(found.group()):04x}"


def _each(texts: tuple[str, ...], old: str, new: str) -> tuple[str, ...]:
    return tuple(text.replace(old, new) for text in texts)
