"""The manual in a terminal: one page, and what else may be meant."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from vrts.ask.collect import all_pages, manual_files, section_names, without_front
from vrts.ask.names import named, near_names
from vrts.ask.other_languages import own_words as foreign_words
from vrts.ask.page import Kind, Page
from vrts.ask.search import Found, Hit, Index
from vrts.ask.terminal import Look, rendered, to_type
from vrts.ask.words import facts, own_words

MOST_ELSE = 5  # pages that are listed below the one that is shown
LEAST_WORD = 0.7  # of the best word's score: what is further off is not shown beside it
LEAST_SHARE = 0.2  # of the best score: what is further off is not listed


class Answer(NamedTuple):
    """What is shown for a question."""

    page: Page | None  # None: nothing fits
    others: tuple[Page, ...]
    read_as: Mapping[str, str]  # words that were taken for others
    near: tuple[str, ...] = ()  # names that look like what was asked


class Manual:
    """All pages of the manual."""

    def __init__(self, commands: Mapping[str, str]) -> None:
        """Gather the pages; `commands` says what each command of the command line does."""
        self.pages = tuple(all_pages(commands))
        self._index: Index | None = None

    def search(self, question: str) -> Found:
        """Return pages in the order in which they answer a question."""
        if self._index is None:
            self._index = Index(self.pages, own_words())
        return self._index.search(question)

    def answer(self, question: str) -> Answer:
        """Return the page of a name, or the one that answers a question best."""
        page = named(question, self.pages)
        found = self.search(question)
        hits = found.hits
        if page is None and _is_one_word(question) and not _is_known(found):
            near = near_names(question, self.pages)
            if near:
                return Answer(None, (), {}, near)
        if page is None and not hits:
            return Answer(None, (), {}, near_names(question, self.pages))
        shown = page or hits[0].page
        return Answer(shown, _others(shown, hits), {} if page else found.read_as)

    def sections_about(self, word: str) -> tuple[Page, ...]:
        """Return the rules about a word of the language, the one that tells most first."""
        wanted = re.compile(rf"(?<![\w.$#]){re.escape(word)}(?![\w.])")
        found = [
            (3.0 * bool(wanted.search(page.title)) + min(len(wanted.findall(page.text)), 6), page)
            for page in self.pages
            if page.kind is Kind.RULE and page.section and wanted.search(page.text)
        ]
        found.sort(key=lambda pair: (-pair[0], pair[1].name))
        return tuple(page for _, page in found)

    def recipes_with(self, word: str) -> tuple[Page, ...]:
        """Return the recipes that use a word of the language, those about it first."""
        wanted = re.compile(rf"(?<![\w.$#]){re.escape(word)}(?![\w.])")
        found: list[tuple[bool, int, Page]] = []
        for page in self.pages:
            if page.kind is Kind.RECIPE and wanted.search(page.text):
                about = wanted.search(page.text.partition("\n<!--")[0]) is not None
                found.append((not about, len(page.text), page))
        return tuple(page for _, _, page in sorted(found))


def words_for(question: str) -> tuple[str, ...]:
    """Return words of the language for what somebody wants, the likeliest first; none: a slip."""
    named_only = (page._replace(asked=()) for page in all_pages({}))
    found = Index(named_only, own_words()).search(question)
    if found.read_as and not _is_foreign(found):
        return ()
    hits = [hit for hit in found.hits if hit.page.kind is Kind.WORD]
    best = hits[0].score if hits else 0.0
    return tuple(hit.page.name for hit in hits if hit.score >= LEAST_WORD * best)


def text_of(page: Page, look: Look) -> str:
    """Return a page or a section as text for a terminal."""
    if page.kind is Kind.WORD:
        return "\n\n".join(fact.text for fact in facts()[page.name])
    labels = section_names()

    def link(words: str, target: str) -> str:
        name = to_type(target, page.of, labels)
        return f"{words} (`vrts manual {name}`)" if name else words

    text = page.text
    if page.kind in (Kind.RULE, Kind.BACKGROUND) and not page.section:
        text = without_front(manual_files()[page.name])[0]  # with its sections
    return rendered(text, look, link)


def _others(shown: Page, hits: tuple[Hit, ...]) -> tuple[Page, ...]:
    best = hits[0].score if hits else 0.0
    near = [hit.page for hit in hits if hit.score >= LEAST_SHARE * best]
    return tuple(page for page in near if page.of != shown.of)[:MOST_ELSE]


def _is_one_word(question: str) -> bool:
    return len(question.split()) == 1


def _is_known(found: Found) -> bool:
    return bool(found.hits) and (not found.read_as or _is_foreign(found))


def _is_foreign(found: Found) -> bool:
    """Whether every slip of the pen was in a word that another language has."""
    return all(near in foreign_words() for near in found.read_as.values())
