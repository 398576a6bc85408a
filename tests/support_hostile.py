"""Text that tries to steer whatever shows it, and diagnostics made of such text."""

import re
import unicodedata

from hypothesis import strategies as st

from vrts.base.diagnostic import Diagnostic, Edit, Fix, Label, Moment, Rule, Severity
from vrts.base.source import SourceFile, Span

ATTACKS = [
    "\x1b[2J",
    "\x1b]0;title\x07",
    "\x9b31m",
    "\u202e",
    "\u2066",
    "\u200f",
    "\r",
    "\n",
    "\r\n",
    "\x00",
    "\x7f",
    "\x85",
    "\u2028",
    "\ud800",
    "::stop-commands::x",
    "\n::error file=a::b",
    "\n  ::add-mask::a",
    "##[error]x",
    "##vso[task.complete]",
    "##teamcity[x]",
    "###[",
    "%0A::error::",
    ",line=1::",
    "</script><script>alert(1)</script>",
    "<!--",
    "]]>",
    "&amp;",
    "{0}",
    "](https://example.org)",
    "\ue000error\ue001x\ue002",
    "`",
    '"',
    "\\",
    "語",
    "e\u0301",
    "\t",
]

HIDDEN = ("Cc", "Cf", "Cs", "Co", "Zl", "Zp")  # categories of Unicode
SERVICE = re.compile(r"##\[|##vso\[|##teamcity\[|^\s*::[^:\s]", re.IGNORECASE)

texts = st.lists(
    st.one_of(st.sampled_from(ATTACKS), st.text(max_size=6), st.just("part")), max_size=5
).map("".join)
names = texts.map(lambda text: text or "a.v2")


@st.composite
def labels(draw: st.DrawFn, source: SourceFile) -> Label:
    """Return a label anywhere in a source."""
    ends = st.integers(0, len(source.text))
    start, end = sorted((draw(ends), draw(ends)))
    return Label(Span(source, start, end), draw(texts))


@st.composite
def diagnostics(draw: st.DrawFn) -> Diagnostic:
    """Return a diagnostic in which everything that a program can say is hostile."""
    source = SourceFile(draw(names), draw(texts))
    other = SourceFile(draw(names), draw(texts))
    some = st.lists(texts, max_size=2).map(tuple)
    edits = st.builds(Edit, labels(source).map(lambda label: label.span), texts)
    fix = st.lists(edits, min_size=1, max_size=3).map(Fix.from_edits)
    moment = st.builds(Moment, st.just(1.5), st.just((0.0,) * 7), some)
    return Diagnostic(
        draw(st.sampled_from([Rule("V131", "missing-comma"), Rule("V102", "not-text")])),
        draw(st.sampled_from(Severity)),
        draw(texts),
        draw(st.none() | labels(source)),
        tuple(draw(st.lists(st.one_of(labels(source), labels(other)), max_size=2))),
        draw(some),
        draw(some),
        draw(st.none() | fix),
        draw(st.none() | moment),
        {"name": draw(texts)},
    )


def steering(text: str) -> list[str]:
    """Return the characters, but for line ends, that could steer what shows the text."""
    return [c for c in text if c != "\n" and unicodedata.category(c) in HIDDEN]


def service_commands(text: str) -> list[str]:
    """Return the lines in which a build service would read a command, as their runners do.

    Our own ` ::: place` is none: a command's name follows the colons at once.
    """
    return [line for line in text.split("\n") if SERVICE.search(line)]
