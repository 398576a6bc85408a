"""Chains of causes as lines of a terminal."""

from collections.abc import Sequence

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.because import chain_lines
from vrts.report.plain import capital, line_start, one_line
from vrts.report.quantities import lost
from vrts.report.screen.palette import Palette, Style
from vrts.why.chain import Chain

NOT_ALLOWED = "the task allows no hints"
NOTHING = "nothing is wrong"
NO_CAUSE = "no earlier cause is known"


def why_text(
    a: Assessment, chains: Sequence[Chain], level: Hints, *, whole: bool, color: bool
) -> str:
    """Return chains under what they explain; no line end at the end.

    Args:
        a: What was found.
        chains: To be told.
        level: How much may be told.
        whole: Whether they are of all losses.
        color: Whether to paint.
    """
    palette = Palette(color=color)
    if a.run is None:
        first = next((d.headline for d in a.findings if d.is_error), "it cannot be run")
        return line_start(f"it does not run: {first}")
    losses = a.grade.losses if whole and a.grade else ()
    blocks: list[str] = []
    for k, chain in enumerate(chains):
        points = f" ({lost(losses[k].points)})" if k < len(losses) else ""
        head = palette.paint(Style.STRONG, line_start(capital(one_line(chain.effect)) + points))
        lines = chain_lines(chain, level)
        if not lines and level is not Hints.NOTHING and not whole:
            lines = [NO_CAUSE]
        blocks.append("\n".join([head, *(f"  {text}" for text in lines)]))
    if level is Hints.NOTHING:
        blocks.append(NOT_ALLOWED)
    return "\n\n".join(blocks) or NOTHING
