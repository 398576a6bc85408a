"""How like a question is to those that people asked who wanted a page."""

import math
from collections.abc import Sequence

from vrts.ask.page import Page
from vrts.ask.terms import stems_of

NEXT = (1.0, 0.3, 0.2)  # what the questions of a page count that are most like, as tried
UNKNOWN = 0.6  # how much words weigh that nobody asked with, as a share of the rarest


class Likeness:
    """All that was asked, ready to be compared."""

    def __init__(self, pages: Sequence[Page]) -> None:
        """Count the words of each question, and of the titles of pages that are asked for."""
        self._page: list[int] = []  # of each question
        self._with: dict[str, list[int]] = {}
        asked: list[set[str]] = []
        for number, page in enumerate(pages):
            for question in (*page.asked, page.title) if page.asked else ():
                if terms := set(stems_of(question)):
                    for term in terms:
                        self._with.setdefault(term, []).append(len(asked))
                    asked.append(terms)
                    self._page.append(number)
        self._rarest = math.log(1 + len(asked) / 0.5)
        self._weight = {
            term: math.log(1 + len(asked) / (len(known) + 0.5))
            for term, known in self._with.items()
        }
        self._length = [math.hypot(*(self._weight[term] for term in terms)) for terms in asked]

    def of(self, question: str) -> dict[int, float]:
        """Return for pages by their numbers how like a question is: more than 0, at most 1.5.

        Questions are compared by the cosine of their words, in which rare words weigh more.
        """
        terms = set(stems_of(question))
        length = math.hypot(*(self._weight.get(t, UNKNOWN * self._rarest) for t in terms))
        shared: dict[int, float] = {}
        for term in terms:
            for number in self._with.get(term, ()):
                shared[number] = shared.get(number, 0.0) + self._weight[term] ** 2
        found: dict[int, list[float]] = {}
        for number, inner in shared.items():
            cosine = inner / (length * self._length[number])
            found.setdefault(self._page[number], []).append(cosine)
        return {page: _together(cosines) for page, cosines in found.items()}


def _together(cosines: list[float]) -> float:
    return sum(k * c for k, c in zip(NEXT, sorted(cosines, reverse=True), strict=False))
