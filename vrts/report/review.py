"""What a person has to decide before a mark stands: between which marks it lies, and why."""

from fractions import Fraction
from typing import NamedTuple

from vrts.check.mark.grade import REVIEW
from vrts.report.assessment import Assessment
from vrts.report.plain import one_line
from vrts.report.quantities import mark


class Review(NamedTuple):
    """Why somebody has to look at a run."""

    lowest: Fraction | None  # the mark if all that cannot be told went wrong; None without a task
    highest: Fraction | None  # the mark as given
    reasons: tuple[str, ...]  # one line each

    @property
    def range(self) -> str | None:
        """Both marks, as `6.0 to 10.0`, or the one there is."""
        if self.lowest is None or self.highest is None:
            return None
        if self.lowest == self.highest:
            return mark(self.highest)
        return f"{mark(self.lowest)} to {mark(self.highest)}"


def review_of(a: Assessment) -> Review | None:
    """Return what there is to decide about a run; None where nothing is open."""
    report = a.judgement.collisions if a.judgement else None
    if a.grade is None:
        disputed = report.disagreements if report else ()
        reasons = tuple(one_line(f"two engines disagree: {words}") for words in disputed)
        return Review(None, None, reasons) if reasons else None
    told = (o for o in a.grade.obstacles if o.startswith(REVIEW))
    reasons = tuple(one_line(o.removeprefix(f"{REVIEW}: ")) for o in told)
    reasons = tuple(reason for reason in reasons if not reason.startswith("the mark is between"))
    if not reasons:
        return None
    highest = a.grade.mark
    lowest = highest if a.grade.lowest is None else a.grade.lowest
    return Review(lowest, highest, reasons)
