"""Words that readers stumbled over stay out of what users read; the list says why."""

import re
import tomllib

import pytest

from tests.places import ROOT
from tests.support_plain_words import in_code, texts

WORDS = tomllib.loads((ROOT / "tests" / "data" / "plain_words.toml").read_text("utf-8"))["word"]
GLOSSARY = ROOT / "vrts" / "manual" / "learn" / "glossary.md"
QUOTED = {  # what words there were, and small words of questions
    "CHANGELOG.md",
    "vrts/ask/terms.py",
}


def pattern(*words: dict[str, str]) -> re.Pattern[str]:
    return re.compile("|".join(rf"\b(?:{word['says']})\b" for word in words), re.IGNORECASE)


def test_nothing_says_what_readers_stumbled_over() -> None:
    every = pattern(*WORDS)
    found = [
        f"{read.place}: {match[0]!r}"
        for read in texts(every)
        if read.place.split(":")[0] not in QUOTED
        for match in every.finditer(read.text)
    ]
    assert found == [], "tests/data/plain_words.toml says why, and what to write instead"


@pytest.mark.parametrize("word", WORDS, ids=lambda word: word["says"])
def test_each_word_has_a_reason_and_an_alternative_that_is_allowed(word: dict[str, str]) -> None:
    assert set(word) == {"says", "why", "instead"}
    assert word["why"]
    assert not pattern(*WORDS).search(word["instead"])


def test_texts_of_code_are_messages_and_help_but_no_docstrings() -> None:
    code = (
        '"""Of a module."""\nimport click\n\n@click.command(name="a")\ndef a():\n'
        '    """Help of a command."""\n    say(f"a message {x} goes on")\n\ndef b():\n'
        '    """Of a function."""\n'
    )
    found = [read.text for read in in_code(code, "m.py")]
    assert "Help of a command." in found
    assert "a message " in found
    assert not any(text.startswith("Of a") for text in found)


def test_the_words_of_the_product_stand_in_order_and_say_one_thing_each() -> None:
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", GLOSSARY.read_text("utf-8"), re.M)[1:]
    words = [word for word, _ in rows if not word.startswith("-")]
    assert len(words) > 40
    assert words == sorted(words, key=str.lower)
    assert len(set(words)) == len(words)
