"""What pages of a course are told: JSON."""

import msgspec


class AssignmentTold(msgspec.Struct, frozen=True):
    """An assignment, as those see it who work on it."""

    id: str  # of the scene too
    title: str
    opens: float  # Unix time [s]; 0: it is open
    due: float  # Unix time [s]; 0: there is no deadline


class CourseTold(msgspec.Struct, frozen=True):
    """`GET /course/me`: the course, and who asks."""

    title: str
    rank: str  # teacher, assistant, student; empty: somebody of no list
    team: str
    assignments: tuple[AssignmentTold, ...]
