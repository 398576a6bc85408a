"""`vrts grade change`."""

import shlex
from datetime import date
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grade.options import ALL, marking_option, settles_option
from vrts.cli.shared.console import fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import color_option

if TYPE_CHECKING:
    from vrts.marking.row import Row

EPILOG = """\b
Examples:
  vrts grade change anna --from out --delta 0.5 --reason "goal 2 was met" --who "R. Huber"
  vrts grade change anna --from out --mark 7 --reason "marked from paper" --who "R. Huber"
"""

LARGEST = 1000


class Points(click.ParamType[Fraction]):
    """Points as written, exactly; a comma will do."""

    name = "points"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> Fraction:
        """Return the number."""
        from vrts.base.written_numbers import Doubtful, read_number

        try:
            points = read_number(str(value))
            if points is None:  # other spellings: +0.5, .5, 1/2
                points = Fraction(str(value).replace(",", "."))
        except Doubtful:
            self.fail(f"`{value}` may be a thousand: write decimals with a point", param, ctx)
        except (ValueError, ZeroDivisionError):
            self.fail(f"`{value}` is no number of points", param, ctx)
        if abs(points) > LARGEST or (points * 1000).denominator != 1:
            self.fail(
                f"`{value}`: points are from -{LARGEST} to {LARGEST}, with three decimals",
                param,
                ctx,
            )
        return points


@click.command(name="change", epilog=EPILOG)
@click.argument("student")
@marking_option
@click.option("--delta", type=Points(), help="Points to add; with a minus, to take away.")
@click.option("--mark", type=Points(), help="The new mark, after lateness.")
@settles_option()
@click.option("--reason", required=True, help="Why; the student may ask.")
@click.option("--who", required=True, help="Who decides.")
@click.option("--date", "day", metavar="YYYY-MM-DD", help="When; without it today.")
@color_option
@guarded
def command(
    student: str,
    folder: Path,
    delta: Fraction | None,
    mark: Fraction | None,
    settles: tuple[str, ...],
    reason: str,
    who: str,
    day: str | None,
    color: str,
) -> None:
    """Change the mark of STUDENT by hand.

    STUDENT is an id, or a name or address that only one student has. The change is added to the end
    of OUT/staff/overrides.toml. You may also edit that file; comments in it stay. The change is
    shown beside the computed mark. Exports count it at once, and so does marking again; `vrts grade
    decisions OUT` brings lists and pages up to date. Several changes for one student are made one
    after the other.

    A mark that was unsafe is decided by `--mark`; by `--delta` (which may be 0) where `--settles`
    names the reason. An export no longer asks for it then. Where there is no mark, as for what
    crashed, only `--mark` decides. A decision is about this program: it lapses with another one.
    """
    from vrts.marking.appeals.written import read_written
    from vrts.marking.by_hand.by_hand import all_lapses, with_by_hand
    from vrts.marking.by_hand.override_text import add_overrides
    from vrts.marking.by_hand.overrides import Override, program_of
    from vrts.report.plain import one_line

    if (delta is None) == (mark is None):
        fail("a change is either `--delta` or `--mark`")
    written = read_written(folder)
    row = written.row(student)
    today = day or date.today().isoformat()
    by_hand = written.by_hand()
    row = with_by_hand(row, by_hand)
    decided = _decided(row, settles, delta)
    program = program_of(row.result) if decided or mark is not None else ""
    added = Override(row.id, delta, mark, reason, who, today, decided, program)
    overrides = add_overrides(written.layout.overrides, [added], written.known, written.rows.total)
    by_hand = by_hand._replace(overrides=overrides)
    show_diagnostics(overrides.diagnostics, color)
    after = with_by_hand(row, by_hand)
    show_diagnostics(all_lapses([after], by_hand), color)
    out(f"{row.id}: {_mark(row)} until now, {_mark(after)} from now on")
    for doubt in after.unsafe:
        out(f"still unsafe: {doubt.reason.value}: {one_line(doubt.sentence)}")
    say(f"wrote {written.layout.overrides}")
    again = f"vrts grade decisions {shlex.quote(str(folder))}"
    say(f"exports count it at once; `{again}` brings lists and pages up to date")


def _decided(row: "Row", settles: tuple[str, ...], delta: Fraction | None) -> tuple[str, ...]:
    """Return the reasons that are decided; only those can be that the mark has now."""
    from vrts.marking.unsafe import OF_GRADERS

    held = [doubt.reason for doubt in row.unsafe]
    there = tuple(dict.fromkeys(one.value for one in held if one not in OF_GRADERS))
    if settles and delta is not None and row.result.mark is None:
        fail(
            f"`{row.id}` has no mark ({row.result.kind.value}), so `--delta` cannot settle it",
            ("give the mark that it is to have with `--mark`",),
        )
    lacking = [reason for reason in settles if reason not in (*there, ALL)]
    if lacking or (settles and not there):
        now = f"it is for {', '.join(there)}" if there else "it is safe now"
        if held and not there:
            now = "graders have to decide that, with `vrts grade decisions`"
        fail(f"the mark of `{row.id}` is not unsafe for this reason: {now}")
    return there if ALL in settles else settles


def _mark(row: "Row") -> str:
    return "no mark" if row.final is None else f"{row.final:.1f}"
