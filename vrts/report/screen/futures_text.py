"""A proof over every future, for a terminal."""

from collections.abc import Iterator, Sequence

from vrts.check.verdict import Answer
from vrts.prove.proof import Proof
from vrts.report.plain import line_start, one_line
from vrts.report.proof_words import counted, counts, diagnostic, headline
from vrts.report.screen.palette import Palette, Style
from vrts.report.screen.text import diagnostic_text

MOST_FOUND = 6
STYLES = {
    Answer.HOLDS: Style.GOOD,
    Answer.VIOLATED: Style.ERROR,
    Answer.UNDETERMINED: Style.WARNING,
}


def futures_text(title: str, proof: Proof, *, color: bool) -> str:
    """Return the answer, what goes wrong and how it comes to that, and what all was looked at."""
    return "\n".join(_lines(title, proof, color=color))


def _lines(title: str, proof: Proof, *, color: bool) -> Iterator[str]:
    palette = Palette(color=color)
    answer = palette.paint(STYLES[proof.answer], proof.answer.value)
    yield f"{palette.paint(Style.STRONG, line_start(one_line(title)))}: {answer}"
    yield line_start(headline(proof))
    for wronged in proof.found[:MOST_FOUND]:
        yield ""
        yield diagnostic_text(diagnostic(wronged), color=color)
    if len(proof.found) > MOST_FOUND:
        yield f"\n{counted(len(proof.found) - MOST_FOUND, 'more finding')} not shown here"
    yield ""
    yield counts(proof)
    covered = proof.covered
    yield from _listed("for every choice of", covered.quantified)
    yield from _listed("within", covered.bounded)
    yield from _listed("tried at some values only", covered.sampled)
    yield from _listed("taken for granted", covered.assumed)
    yield from _listed("not looked at", proof.open)
    grows = [f"`{one.name}` in `{one.program}`" for one in proof.unbounded]
    yield from _listed("grows without bound while the program goes on", grows)
    steps = [f"{one.program} {one.step}: {one.reason}" for one in covered.dead]
    yield from _listed("steps that no future executes", steps)


def _listed(title: str, rows: Sequence[str]) -> Iterator[str]:
    if rows:
        yield f"{title}:"
        yield from (f"  {line_start(one_line(row))}" for row in rows)
