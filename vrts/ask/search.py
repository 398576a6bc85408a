"""Pages in the order in which they answer a question.

Each thing that a question is about counts once for a page, by the term for it that the page has
and that is worth most: the rarer the term and the more telling its place - title, keywords, text,
what people asked who wanted it - the more. This is BM25 with fields [Robertson2004]_. To this comes
how like the question is to what people asked who wanted the page.
"""

import math
import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import NamedTuple

from vrts.ask.likeness import Likeness
from vrts.ask.page import Kind, Page
from vrts.ask.terms import FREQUENT, NOISE, Wanted, stem, stems_of, wanted, words_of

TITLE, KEYWORDS, TEXT = 6.0, 4.0, 1.0  # what a term counts in each field, as tried
ASKED, MOST_ASKED = 0.5, 3  # for each of the first questions that have a term
LIKE = 1.0  # what likeness counts; the best page by its terms has 1
SATURATION = 2.0  # so many occurrences count half of what any number would
USUAL_LENGTH = 120  # terms of a text; in longer ones a term counts for less
KINDS = {  # among pages that fit alike, those that answer a beginner come first
    Kind.RECIPE: 1.5,
    Kind.WORD: 1.1,
    Kind.COMMAND: 1.0,
    Kind.RULE: 1.0,
    Kind.BACKGROUND: 1.0,
    Kind.MESSAGE: 0.75,
}
SAYS_ABOUT_A_MESSAGE = 1.6  # instead, where somebody says that a message was shown
_OF_MESSAGES = "error errors warning warnings message messages says said complains squiggle missing"
OF_MESSAGES = frozenset(_OF_MESSAGES.split())
SHORT = 4  # letters of a word that may be a slip of the pen
OTHER_LANGUAGES = 0.6  # of words that VAL-II itself does not have


STEMS_OF_NOISE = frozenset(map(stem, NOISE))
_CODE = re.compile(r"^```.*?^```", re.M | re.S)  # in which names are anybody's


class Hit(NamedTuple):
    """A page that was found."""

    page: Page
    score: float


class Found(NamedTuple):
    """What a search found."""

    hits: tuple[Hit, ...]  # the best first; of sections of one page, the best alone
    read_as: dict[str, str]  # words that nobody knows, and what they were taken for


class Index:
    """All pages, ready to be searched."""

    def __init__(self, pages: Iterable[Page], own: frozenset[str]) -> None:
        """Count the terms of every page.

        Args:
            pages: What may be found.
            own: Words of VAL-II, in capitals.
        """
        self.pages = tuple(pages)
        self._own = own
        self._weights: list[dict[str, float]] = [_weights(page) for page in self.pages]
        self._with: dict[str, list[int]] = {}
        for number, weights in enumerate(self._weights):
            for term in weights:
                self._with.setdefault(term, []).append(number)
        self._likeness = Likeness(self.pages)

    def search(self, question: str) -> Found:
        """Return the pages that answer a question, the best first."""
        things = wanted(question)
        read_as = {thing.said: self._nearest(thing) for thing in things if self._unknown(thing)}
        read_as = {said: near for said, near in read_as.items() if near}
        if read_as:
            question = " ".join(read_as.get(word, word) for word in question.lower().split())
            things = wanted(question)
        scores: dict[int, float] = {}
        matched: dict[int, float] = {}
        total = 0.0
        for thing in things:
            best: dict[int, float] = {}
            for term, worth in thing.worth.items():
                known = self._with.get(term, ())
                rarity = math.log(1 + len(self.pages) / (len(known) + 0.5))
                for number in known:
                    weight = self._weights[number][term]
                    score = worth * rarity * weight / (weight + SATURATION)
                    best[number] = max(best.get(number, 0.0), score)
            importance = max(best.values(), default=0.0)
            total += importance
            for number, score in best.items():
                scores[number] = scores.get(number, 0.0) + score
                matched[number] = matched.get(number, 0.0) + importance
        told = not OF_MESSAGES.isdisjoint(words_of(question))
        for n, score in scores.items():
            scores[n] = score * self._factor(self.pages[n], told=told) * (1 + matched[n] / total)
        most = max(scores.values(), default=1.0)
        ranks = {n: score / most for n, score in scores.items()}
        for n, like in self._likeness.of(question).items():
            ranks[n] = ranks.get(n, 0.0) + LIKE * like
        ranked = [Hit(self.pages[n], score) for n, score in ranks.items()]
        ranked.sort(key=lambda hit: (-hit.score, hit.page.name))
        return Found(_one_of_each(ranked), read_as)

    def _factor(self, page: Page, *, told: bool) -> float:
        told = told and page.kind is Kind.MESSAGE
        factor = SAYS_ABOUT_A_MESSAGE if told else KINDS[page.kind]
        return factor * OTHER_LANGUAGES if self._is_elsewhere(page) else factor

    def _is_elsewhere(self, page: Page) -> bool:
        return page.kind is Kind.WORD and page.name not in self._own

    def _unknown(self, thing: Wanted) -> bool:
        if len(thing.said) < SHORT or thing.said in FREQUENT or not thing.said.isalpha():
            return False
        return not any(term in self._with for term in thing.worth)

    def _nearest(self, thing: Wanted) -> str:
        first = thing.said[0]  # which hardly anybody mistypes
        known = [term for term in self._with if term[0] == first and term.isalpha()]
        said = stem(thing.said)
        near = get_close_matches(said, known, 3, 0.75)
        near.sort(key=lambda term: sorted(term) != sorted(said))  # `wiat` is rather `wait`
        return near[0] if near else ""


def _weights(page: Page) -> dict[str, float]:
    """Return how much each term counts for a page."""
    weights: dict[str, float] = {}
    terms = stems_of(_CODE.sub("", page.text))
    shorter = TEXT / (0.5 + 0.5 * len(terms) / USUAL_LENGTH) if terms else 0.0
    for term in terms:
        weights[term] = weights.get(term, 0.0) + shorter
    for term in set(stems_of(page.keywords)):
        weights[term] = weights.get(term, 0.0) + KEYWORDS
    counted: dict[str, int] = {}
    for question in page.asked:
        for term in set(stems_of(question)) - STEMS_OF_NOISE:
            counted[term] = counted.get(term, 0) + 1
    for term, times in counted.items():
        weights[term] = weights.get(term, 0.0) + ASKED * min(times, MOST_ASKED)
    for term in set(stems_of(page.title)):
        weights[term] = weights.get(term, 0.0) + TITLE
    if page.kind in (Kind.WORD, Kind.MESSAGE):
        weights["=" + page.name.lower()] = 4 * TITLE
    if page.kind in (Kind.RECIPE, Kind.RULE):
        for word in _capitals(page.text):
            weights["=" + word] = KEYWORDS / 2
    return weights


def _capitals(text: str) -> set[str]:
    """Return the words of the language that a text names, in lower case."""
    return {
        word.lower()
        for piece in text.split()
        if (word := piece.strip("`.,:;()[]")).isupper() and len(word) > 2
    }


def _one_of_each(ranked: Sequence[Hit]) -> tuple[Hit, ...]:
    seen: set[str] = set()
    kept: list[Hit] = []
    for hit in ranked:
        if hit.page.of not in seen:
            seen.add(hit.page.of)
            kept.append(hit)
    return tuple(kept)
