"""Whether somebody may hand in at a moment, and what that would cost: by the rules of the task."""

from datetime import UTC, datetime
from typing import NamedTuple

from vrts.course.facts import Facts
from vrts.marking.lateness import lateness


class Refusal(NamedTuple):
    """Why nothing can be handed in."""

    code: str
    text: str
    help: str = ""


class Standing(NamedTuple):
    """How an assignment stands for somebody now."""

    late: str  # what handing in now would cost, in words; empty: nothing
    closes: datetime | None  # when nothing is taken any more; None: never
    attempts: int | None  # how many there are; None: as many as one likes
    used: int
    refusal: Refusal | None  # why nothing is taken now

    @property
    def left(self) -> int | None:
        """How many attempts are left; None: as many as one likes."""
        return None if self.attempts is None else max(0, self.attempts - self.used)


def opened(facts: Facts, at: float) -> bool:
    """Return whether students see an assignment; `at` is Unix time [s]."""
    return facts.opens is None or facts.opens.timestamp() <= at


def standing(facts: Facts, used: int, at: float, *, due: datetime | None = None) -> Standing:
    """Return how an assignment stands.

    Args:
        facts: Of the assignment.
        used: Attempts that were made.
        at: Now, Unix time [s].
        due: A later deadline of one's own; None: that of all.
    """
    rules = facts.rules
    counted = (facts.assignment.attempts, None if rules is None else rules.attempts)
    attempts = min((number for number in counted if number is not None), default=None)
    if due is not None and rules is not None:
        due = max(due, rules.due)  # an earlier one costs nobody anything
    late = lateness(rules, datetime.fromtimestamp(at, UTC), due=due)
    closes = None
    if rules is not None:
        more = (due or rules.due) - rules.due
        closes = rules.due + more if rules.is_exam else rules.closed and rules.closed + more
    refusal = None
    if not opened(facts, at):
        refusal = Refusal("early", "this assignment is not open yet")
    elif late.closed:
        what = "the exam is closed" if rules is not None and rules.is_exam else "it is closed"
        refusal = Refusal("closed", f"{what}: nothing is taken any more", "ask your teacher")
    elif attempts is not None and used >= attempts:
        how = "the one attempt" if attempts == 1 else f"all {attempts} attempts"
        refusal = Refusal("attempts", f"you have used {how} at this assignment")
    return Standing(late.sentence, closes, attempts, used, refusal)
