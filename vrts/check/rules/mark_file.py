"""Reads `[mark]` of a task: how many points there are, and what costs how many."""

from fractions import Fraction

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.check.rules.scheme import LARGEST_TOTAL, LEAST_TOTAL, TOTAL, Contacts, MarkScheme, scaled

TOO_MANY_POINTS = Rule("V655", "too-many-points")
MARK_SCHEME = Rule("V682", "mark-scheme")

TENTH = Fraction(1, 10)
OWN_KEY = {"per_second": Contacts.TIME, "per_mm": Contacts.DEPTH}


def read_mark(top: Table, problems: Problems) -> MarkScheme:
    """Return the numbers of `[mark]`; what it does not give is as usual, in proportion."""
    section = top.table("mark")
    if section is None:
        return MarkScheme()
    total = _total(section)
    if total % TENTH:
        problems.error(
            MARK_SCHEME,
            f"`total` must be a number of tenths, as marks are, not {float(total):g}",
            section.value_span("total"),
        )
    before, usual = len(problems.found), scaled(total)
    words = tuple(choice.value for choice in Contacts)
    by = Contacts(section.string("contacts_by", usual.contacts_by.value, choices=words))

    def points(key: str, otherwise: Fraction) -> Fraction:
        return section.fraction(key, otherwise, minimum=0, maximum=float(total))

    found = MarkScheme(
        points("targets", usual.targets),
        points("vias", usual.vias),
        points("first_contact", usual.first_contact),
        points("further_contact", usual.further_contact),
        points("contact_cap", usual.contact_cap),
        points("time_bonus", usual.time_bonus),
        section.fraction("zero_at", usual.zero_at, minimum=1.01, maximum=100),
        total,
        points("broken_limit", usual.broken_limit),
        by,
        points("per_second", usual.per_second),
        points("per_mm", usual.per_mm),
    )
    section.finish()
    for key, meant in OWN_KEY.items():
        if key in section and by is not meant:
            problems.error(
                MARK_SCHEME,
                f"`{key}` says nothing where contacts are weighed by {by.value}",
                section.span_of(key),
                help=(f'write `contacts_by = "{meant.value}"`, or delete it',),
            )
    most = found.targets + found.vias + found.time_bonus
    if most > total and len(problems.found) == before:
        problems.error(
            TOO_MANY_POINTS,
            f"the parts of the mark add up to {float(most):g}, more than {float(total):g}",
            section.span,
            help=(
                f"targets + vias + time_bonus may be {float(total):g} at most",
                f"a mark out of more points: `total = {float(most):g}`",
            ),
        )
    return found


def _total(section: Table) -> Fraction:
    return section.fraction("total", TOTAL, minimum=LEAST_TOTAL, maximum=LARGEST_TOTAL)
