"""Findings in the order in which they are told, each once."""

from collections.abc import Sequence
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Severity


def in_order(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return findings, errors before warnings before notes; one that comes again is told once."""
    weight = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}
    alike: dict[object, list[Diagnostic]] = {}
    for d in findings:
        where = d.primary.span if d.primary else None
        same = alike.setdefault((d.rule, d.headline, where), [])
        if all(d.moment != other.moment for other in same) or not same:
            same.append(d)
    told = [_with_count(same[0], len(same) - 1) for same in alike.values()]
    return sorted(told, key=lambda d: weight[d.severity])


def _with_count(d: Diagnostic, more: int) -> Diagnostic:
    if not more:
        return d
    return replace(d, notes=(*d.notes, f"and {more} more time{'s' if more > 1 else ''}"))
