"""The numbers of `[mark]`: how many points there are, and what costs how many."""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

TOTAL = Fraction(10)  # points, where a task does not say
LEAST_TOTAL, LARGEST_TOTAL = 1, 1000  # that a task may say


class Contacts(Enum):
    """What contacts are weighed by."""

    EVENTS = "events"
    TIME = "time"
    DEPTH = "depth"


@dataclass(frozen=True, slots=True)
class MarkScheme:
    """The numbers of `[mark]`; defaults are those of the published system's successor."""

    targets: Fraction = Fraction(6)
    vias: Fraction = Fraction(5, 2)
    first_contact: Fraction = Fraction(3, 2)
    further_contact: Fraction = Fraction(1)
    contact_cap: Fraction = Fraction(5)
    time_bonus: Fraction = Fraction(3, 2)
    zero_at: Fraction = Fraction(3)  # a goal earns nothing from this multiple of its tolerance
    total: Fraction = TOTAL  # a multiple of a tenth
    broken_limit: Fraction = Fraction(3, 2)  # once, for any limit of the robot
    contacts_by: Contacts = Contacts.EVENTS
    per_second: Fraction = Fraction(1)  # of contact, by time
    per_mm: Fraction = Fraction(1, 10)  # of depth, by depth


def scaled(total: Fraction) -> MarkScheme:
    """Return the usual numbers for another total: all points in proportion."""
    usual, by = MarkScheme(), total / TOTAL
    return MarkScheme(
        usual.targets * by,
        usual.vias * by,
        usual.first_contact * by,
        usual.further_contact * by,
        usual.contact_cap * by,
        usual.time_bonus * by,
        usual.zero_at,
        total,
        usual.broken_limit * by,
        usual.contacts_by,
        usual.per_second * by,
        usual.per_mm * by,
    )
