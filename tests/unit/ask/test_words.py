"""What the search knows of words is what `vrts support` lists, found without compiling."""

from vrts.ask.words import facts
from vrts.report.support import entries

COMMAND = "command of the monitor"


def test_no_word_is_missing_and_none_is_made_up() -> None:
    told = {
        (fact.word, "command" if fact.kind == COMMAND else fact.kind, fact.about)
        for each in facts().values()
        for fact in each
    }
    listed = {(entry.word, entry.kind, entry.about) for entry in entries()}
    assert len(listed) > 900
    assert told == listed
