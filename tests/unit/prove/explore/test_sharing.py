"""Two programs have an order only where they share something."""

import pytest

from tests.unit.prove.explore.proofs import module_of
from vrts.prove.explore.sharing import may_differ

MAIN = "PCEXECUTE beside\nMOVE a\n"


def differ(main: str, beside: str) -> bool:
    return may_differ(module_of(f"{main}.END\n.PROGRAM beside()\n{beside}\n"), "main")


@pytest.mark.parametrize(
    ("main", "beside"),
    [
        ("", "n = 1"),
        ("SIGNAL 1", "SIGNAL 2"),
        ("WAIT SIG(1001)", "WAIT SIG(1001)\nSIGNAL 2"),
        ("k = n", "k2 = n"),
        ("TIMER 1 = 0", "k = 2"),
    ],
)
def test_programs_that_share_nothing(main: str, beside: str) -> None:
    assert not differ(f"{MAIN}{main}\n", beside)


@pytest.mark.parametrize(
    ("main", "beside"),
    [
        ("n = 1", "IF n == 1 THEN\nSIGNAL 3\nEND"),
        ("IF n == 1 THEN\nSIGNAL 3\nEND", "n = 1"),
        ("n = 1", "n = 2"),
        ("SIGNAL 2001", "WAIT SIG(2001)"),
        ("SIGNAL 2001", "SIGNAL -2001"),
        ("REACT 2001, beside", "SIGNAL 2001"),
        ("READY", "HERE p"),
        ("READY", "BRAKE"),
        ("TIMER 1 = 0", "WAIT TIMER(1) > 1"),
        ("x = RANDOM", "y = RANDOM"),
        ("PCABORT", "n = 1"),
        ("PCEXECUTE beside", "n = 1"),
        ("CALL helps\n.END\n.PROGRAM helps()\nn = 1", "k = n"),
    ],
)
def test_programs_that_share_something(main: str, beside: str) -> None:
    assert differ(f"{MAIN}{main}\n", beside)


def test_one_that_is_begun_in_a_loop_may_still_execute() -> None:
    assert differ("FOR i = 1 TO 3\nPCEXECUTE beside\nEND\n", "k = 2")


def test_one_program_has_no_order() -> None:
    assert not may_differ(module_of("n = 1\n"), "main")
