"""The first screen on a terminal."""

from collections.abc import Sequence
from typing import TypeAlias

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.report.because import because, chain_lines, told_to
from vrts.report.first_screen import FirstScreen, first_screen
from vrts.report.plain import line_start, one_line, width, yes_no
from vrts.report.quantities import full, lost, mark, when
from vrts.report.review import review_of
from vrts.report.screen.palette import Palette, Style, worded
from vrts.report.screen.sketch import sketch

Row: TypeAlias = tuple[str, str]

INDENT = " " * 9


def first_screen_text(a: Assessment, palette: Palette) -> str:
    """Return mark, ready, cause, hint, losses and a picture; no line end at the end."""
    screen = first_screen(a)
    title = one_line(a.title) + (f" · {one_line(a.task.title)}" if a.task else "")
    good = Style.GOOD if screen.ready else Style.ERROR
    if screen.mark is None:
        rows = [palette.paint(Style.STRONG, line_start(title)) + f": {screen.status}"]
    else:
        number = palette.paint(good, f"{mark(screen.mark)} / {full(screen.total)}")
        rows = [f"{number}  {palette.paint(Style.STRONG, title)} ({screen.status})"]
    why = f", in {screen.ready_in}" if screen.ready else ""
    why = f": {screen.why_not}" if screen.why_not else why
    rows.append("ready for the real robot: " + palette.paint(good, yes_no(screen.ready)) + why)
    rows += _review_rows(a, palette)
    rows += [line_start(screen.cause)]
    rows += [worded("hint", screen.hint, Style.NOTE, palette)] if screen.hint else []
    table = _loss_rows(screen) if screen.losses else _verdict_rows(screen)
    shown = _table(table, palette) if table else []
    if screen.losses:
        shown = _with_causes(a, shown, palette)
    parts = [rows, shown, _picture(a, screen, palette)]
    return "\n\n".join("\n".join(part) for part in parts if part)


def _review_rows(a: Assessment, palette: Palette) -> list[str]:
    review = review_of(a)
    if review is None:
        return []
    between = f"the mark is {review.range}: " if review.range else ""
    label = palette.paint(Style.NOTE, "review")
    return [f"{label}: {between}{'; '.join(review.reasons)}"]


def _picture(a: Assessment, screen: FirstScreen, palette: Palette) -> list[str]:
    if a.run is None or screen.moment is None:
        return []
    time_s = screen.moment.time_s
    state = a.run.at(time_s)
    touching = a.judgement.collisions.contacts if a.judgement and a.judgement.collisions else ()
    point = next((c.point for c in touching if c.start_s <= time_s <= c.end_s), None)
    lines = sketch(
        a.run.scene,
        state.configuration,
        state.hand_opening,
        state.poses,
        point,
        palette,
    )
    return [*lines, palette.paint(Style.FAINT, f"  {when(screen.moment)}")]


def _loss_rows(screen: FirstScreen) -> list[Row]:
    assert screen.mark is not None
    rows = [(lost(loss.points), one_line(loss.sentence)) for loss in screen.losses]
    return [("points", "lost by"), *rows, (mark(screen.mark), f"mark, of {full(screen.total)}")]


def _verdict_rows(screen: FirstScreen) -> list[Row]:
    rows = [
        (v.answer.value, f"{one_line(v.check)}: {one_line(v.summary)}") for v in screen.verdicts
    ]
    return [("answer", "check"), *rows] if rows else []


def _with_causes(a: Assessment, table: list[str], palette: Palette) -> list[str]:
    """Return the losses with the causes of the first one, and what each other one comes from."""
    level = told_to(a, Audience.STUDENT)
    chains = because(a) if level is not Hints.NOTHING else ()
    shown, more = table[:1], False
    for k, row in enumerate(table[1:]):
        lines = chain_lines(chains[k], level) if k < len(chains) else []
        more = more or (k > 0 and len(lines) > 1)
        lines = lines if k == 0 else lines[-1:]
        shown += [row, *(palette.paint(Style.FAINT, f"{INDENT}{text}") for text in lines)]
    if more:
        shown.append(palette.paint(Style.FAINT, f"{INDENT}`vrts why` tells all that led to each"))
    return shown


def _table(rows: Sequence[Row], palette: Palette) -> list[str]:
    columns = max(width(left) for left, _ in rows)
    lines = [f"  {' ' * (columns - width(left))}{left}  {right}" for left, right in rows]
    return [palette.paint(Style.FAINT, lines[0]), *lines[1:]]
