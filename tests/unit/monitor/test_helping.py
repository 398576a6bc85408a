"""HELP names every command."""

from vrts.lang.vocabulary.commands import COMMANDS, look_up_command
from vrts.monitor.commands.helping import GROUPS


def test_every_command_that_is_carried_out_stands_in_one_group() -> None:
    listed = [word for words in GROUPS.values() for word in words.split()]
    assert sorted(listed) == sorted(w.text for w in COMMANDS.values() if not w.opaque)


def test_here_keeps_its_short_forms() -> None:
    for short, text in (("H", "HERE"), ("HE", "HERE"), ("HER", "HERE"), ("HEL", "HELP")):
        found = look_up_command(short).word
        assert found is not None
        assert found.text == text
