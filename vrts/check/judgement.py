"""Everything that the checks of one run answered."""

from dataclasses import dataclass

from vrts.check.verdict import Answer, CollisionReport, Verdict


@dataclass(frozen=True, slots=True)
class Judgement:
    """All verdicts on a run, and the details that reports draw."""

    verdicts: tuple[Verdict, ...]
    collisions: CollisionReport | None  # None when collisions were not checked

    @property
    def answer(self) -> Answer:
        """Violated if anything is; else undetermined if anything is; else holds."""
        answers = {verdict.answer for verdict in self.verdicts}
        for answer in (Answer.VIOLATED, Answer.UNDETERMINED):
            if answer in answers:
                return answer
        return Answer.HOLDS
