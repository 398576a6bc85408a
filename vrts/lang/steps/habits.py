"""Habits of a writer: what is done again and again is told once, with how often."""

from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Fix
from vrts.base.source import Span
from vrts.lang.problems import Problems

MOST_LINES_NAMED = 8


class Habits:
    """Places of one file where the same is done, by what it is."""

    def __init__(self) -> None:
        """Know of none."""
        self._places: dict[str, list[Span]] = {}

    def note(self, problems: Problems, habit: str) -> None:
        """Note that the last diagnostic tells of a habit."""
        place = problems.found[-1].primary
        if place is not None:
            self._places.setdefault(habit, []).append(place.span)

    def report(self, problems: Problems) -> None:
        """Put one diagnostic in the place of all that tell of the same habit."""
        habits = [spans for spans in self._places.values() if len(spans) > 1]
        self._places = {}
        if not habits:
            return
        by_place = {(d.primary.span, d.rule): d for d in problems.found if d.primary is not None}
        taken: dict[int, Diagnostic | None] = {}
        for spans in habits:
            told = [d for (span, _), d in by_place.items() if span in set(spans) and d.is_error]
            if len(told) > 1:
                taken |= {id(d): None for d in told[1:]}
                taken[id(told[0])] = _together(told)
        kept = [taken.get(id(d), d) for d in problems.found]
        problems.found[:] = [d for d in kept if d is not None]


def _together(told: list[Diagnostic]) -> Diagnostic:
    """Return one diagnostic for all places of a habit."""
    first, *others = told
    lines = [str(d.primary.span.line) for d in others if d.primary is not None]
    named = ", ".join(lines[:MOST_LINES_NAMED]) + (", ..." if len(lines) > MOST_LINES_NAMED else "")
    more = len(others)
    where = f"in line{'s' if more > 1 else ''} {named}"
    note = f"{more} more {'place' if more == 1 else 'places'}, {where}"
    fixes = [d.fix for d in told if d.fix is not None]
    edits = [edit for fix in fixes for edit in fix.edits]
    return replace(
        first,
        notes=(*first.notes, note),
        fix=Fix.from_edits(edits, sure=all(fix.sure for fix in fixes)) if edits else None,
        data={**first.data, "places": len(told)},
    )
