"""What is given a value has it then; what cannot be given one is refused, and nothing changes."""

import random
from pathlib import Path

import pytest

from tests.laws import first
from tests.unit.debug.test_debugger import debugger, whole
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell

WORDS = """
n m seen far near #p $s x SIG(3) SIG(-3) SIG(1003) SIG(2001) SIG(n) SIG(99) SPEED(1) SPEED(2) PI \
HERE TRUE IF MOVE NOT TIMER(1) INT(n) SWITCH(UPPER) UPPER main twice i+1 1x x[1] x[n] x[-1] n[2] \
x[1/0] [1] a.b é SIGNAL(5) TOOL averylongnameofavariable ( ) = == + , : ; .END 3 "a" $ # _
1 0 -1 TRUE FALSE on off 0.1 n n+1 far HERE "a" $s #p NULL 1/0 nosuch 50 1E30
"""
PIECES, VALUES = (row.split() for row in WORDS.strip().split("\n"))


def there() -> Debugger:
    d = debugger()
    d.run_to("main.v2", 7)
    return d


def console(d: Debugger) -> Console:
    return Console(d, Path(), ())


@pytest.mark.parametrize(
    ("name", "value", "shown"),
    [
        ("SIG(3)", "1", "-1"),
        ("SIG(3)", "-1", "-1"),
        ("SIG(3)", "TRUE", "-1"),
        ("SIG(5)", "0", "0"),
        ("SIG(-3)", "1", "-1"),
        ("SIG(1003)", "on", "-1"),
        ("SPEED(1)", "50", "50"),
        ("x", "0.1", "0.1"),
        ("x[n+1]", "2", "2"),
        ("far", "700 300 1 90 90 0", "700.00"),
    ],
)
def test_what_it_shows_is_what_the_controller_has(name: str, value: str, shown: str) -> None:
    d = there()
    told = console(d).give(name, value)
    assert told.split()[0] == shown
    assert 3 in d.state.signals if (name, shown) == ("SIG(3)", "-1") else 3 not in d.state.signals


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("SIG(99)", "1", "there is no signal 99"),
        ("SIG(3)", '"a"', "a signal is on or off"),
        ("PI", "3", "PI cannot be given a value"),
        ("HERE", "far", "a word of the language"),
        ("i+1", "3", "no variable and no signal"),
        ("1x", "3", "no variable and no signal"),
        ("TIMER(1)", "3", "is a function"),
        ("UPPER", "1", "is a switch"),
        ("n", "far", "both as a number and as a location"),
        ("n[1]", "3", "no array"),
        ("SPEED(1)", "-5", "above 0"),
    ],
)
def test_what_cannot_be_given_a_value_is_refused_with_the_reason(
    name: str, value: str, reason: str
) -> None:
    d = there()
    before = whole(d.state)
    with pytest.raises(CannotTell, match=reason):
        console(d).give(name, value)
    assert whole(d.state) == before


@pytest.mark.parametrize("seed", first(1, range(8)))
def test_any_text_is_refused_or_has_its_value_then(seed: int) -> None:
    chance = random.Random(seed)
    for _ in range(20):
        d = there()
        c = console(d)
        before = whole(d.state)
        count = chance.choice((1, 1, 1, 2, 3))
        name = "".join(chance.choice(PIECES) for _ in range(count))
        value = chance.choice(VALUES)
        try:
            wanted = {"on": -1.0, "off": 0.0}.get(value) or c.value(value)
            c.give(name, value)
        except CannotTell:
            assert whole(d.state) == before, (name, value)
            continue
        found = c.value(name.replace("SIGNAL", "SIG"))  # the one is written, the other is read
        is_signal = name.startswith("SIG")
        assert (bool(found) == bool(wanted)) if is_signal else found == wanted, (name, value)
        assert whole(d.state) != before or found == wanted, (name, value)


def test_the_console_gives_signals_too() -> None:
    d = there()
    assert console(d).enter("SIG(3) = 1") == "-1\n"
    assert 3 in d.state.signals
    with pytest.raises(CannotTell, match="PI cannot"):
        console(d).enter("PI = 3")
    for line in ("i+1 = 3", "1x = 3"):
        before = whole(d.state)
        console(d).enter(line)
        assert whole(d.state) == before
