"""How pages are put in order, on a manual of four pages."""

import pytest

from vrts.ask.page import Kind, Page
from vrts.ask.search import Index

PAGES = (
    Page("do/wait", Kind.RECIPE, "Wait a while", "`DELAY 2` waits.", "sleep, pause"),
    Page("do/count", Kind.RECIPE, "Count parts", "A counter. Then wait.", "how many"),
    Page("DELAY", Kind.WORD, "DELAY", "DELAY seconds: stand still for a time"),
    Page("TWAIT", Kind.WORD, "TWAIT", "TWAIT seconds: stand still for a time"),
    Page("language/motion", Kind.RULE, "Motion", "What moves."),
    Page("language/motion#one", Kind.RULE, "Straight", "A motion, straight.", section=True),
    Page("language/motion#two", Kind.RULE, "Lines", "A straight motion.", section=True),
    Page("V301", Kind.MESSAGE, "V301 out-of-reach", "The arm cannot reach it."),
)
INDEX = Index(PAGES, frozenset({"DELAY"}))


def names(question: str) -> list[str]:
    return [hit.page.name for hit in INDEX.search(question).hits]


@pytest.mark.parametrize(
    ("question", "first"),
    [
        ("wait", "do/wait"),  # in the title counts more than in the text
        ("waiting", "do/wait"),  # endings do not count
        ("how do I sleep?", "do/wait"),  # what others call it
        ("rest for a moment: pause!", "do/wait"),
        ("DELAY", "DELAY"),  # a word in capitals is that word
        ("TIME.SLEEP", "DELAY"),  # a word of another language
        ("v301", "V301"),
        ("out of reach", "V301"),
    ],
)
def test_the_first_page(question: str, first: str) -> None:
    assert names(question)[0] == first


def test_words_of_val2_come_before_those_of_its_relatives() -> None:
    found = names("stand still")
    assert found.index("DELAY") < found.index("TWAIT")


def test_of_sections_of_one_page_the_best_alone_is_named() -> None:
    found = [name for name in names("straight motion") if name.startswith("language/motion")]
    assert len(found) == 1


def test_a_slip_of_the_pen_is_read_as_what_it_was_meant_for() -> None:
    found = INDEX.search("coutner")
    assert found.read_as == {"coutner": "count"}
    assert found.hits[0].page.name == "do/count"


@pytest.mark.parametrize("word", ["wat", "three", "ktime"])  # short, of any talk, another letter
def test_a_word_that_may_be_no_slip_is_left_as_it_is(word: str) -> None:
    assert INDEX.search(f"{word} straight motion").read_as == {}


def test_letters_that_changed_places_are_the_likeliest_slip() -> None:
    pages = [Page(name, Kind.RECIPE, title, "") for name, title in (("a", "Wait"), ("b", "Writ"))]
    assert Index(pages, frozenset()).search("wiat").read_as == {"wiat": "wait"}


def test_nonsense_finds_nothing() -> None:
    assert names("xqzzt") == []
    assert names("") == []


def test_equal_pages_stand_in_the_order_of_their_names() -> None:
    twins = (
        Page("b", Kind.RULE, "Twins", "alike"),
        Page("a", Kind.RULE, "Twins", "alike"),
    )
    assert [h.page.name for h in Index(twins, frozenset()).search("twins").hits] == ["a", "b"]
