"""A breakpoint as it is written: `12`, `12:i > 3`, `12 hits >= 5`, `12 log i is {i}`."""

import re
from typing import NamedTuple

from vrts.debug.breakpoints import Breakpoint, is_hit_rule

_FORM = re.compile(
    r"(?:(?P<file>[^:\s]*[^:\s\d][^:\s]*):)?(?P<line>\d{1,7})\s*"
    r"(?::\s*(?P<condition>.*?))?"
    r"(?:\s+hits\s+(?P<hits>[=<>%]*\s*\d+))?"
    r"(?:\s+log\s+(?P<log>.*))?",
    re.IGNORECASE,
)


class Asked(NamedTuple):
    """What a breakpoint is to be."""

    file: str
    line: int
    condition: str = ""
    hits: str = ""
    log: str = ""


def read_breakpoint(text: str) -> Asked | str:
    """Return what is asked for, or why it cannot be read."""
    found = _FORM.fullmatch(text.strip())
    if found is None:
        return "a breakpoint is a line, `12`, or more: `12:i > 3`, `12 hits >= 5`, `12 log {i}`"
    hits = (found["hits"] or "").strip()
    if not is_hit_rule(hits):
        return f"`{hits}` says not which hits count: `5`, `>= 5` or `% 3`"
    condition, log = (found["condition"] or "").strip(), (found["log"] or "").strip()
    return Asked(found["file"] or "", int(found["line"]), condition, hits, log)


def written(line: int, condition: str, hits: str, log: str) -> str:
    """Return a breakpoint as it is read."""
    text = f"{line}:{condition}" if condition else str(line)
    return text + (f" hits {hits}" if hits else "") + (f" log {log}" if log else "")


def described(point: Breakpoint) -> str:
    """Return a breakpoint in words."""
    words = [f"line {point.line}: {'writes ' + point.log if point.log else 'stops'}"]
    if point.condition:
        words.append(f"where {point.condition}")
    if point.hits:
        words.append(f"at hits {point.hits}")
    return ", ".join(words)
