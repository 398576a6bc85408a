"""Who waits for whom, in words."""

import pytest

from tests.support_engine import runs
from vrts.base.diagnostic import Diagnostic
from vrts.scene.model import Scenario


def why(body: str, watch: str = "", more: str = "", scenario: Scenario | None = None) -> Diagnostic:
    """Return the one error of a program beside `b`."""
    run = runs(body, f".PROGRAM b\n{watch}\n.END\n{more}", scenario, "val2+")
    (found,) = (finding for finding in run.findings if finding.is_error)
    return found


WORDS = [
    ("WAIT SIG(2001)", "k = 1", "no program sets it"),
    ("WAIT SIG(2001)", "SIGNAL 2001", "only `b` could set it, and it is never executed"),
    (
        "PCEXECUTE b\nDELAY 1\nBREAK\nWAIT SIG(2001)",
        "IF SIG(3) THEN\nSIGNAL 2001\nEND",
        "only `b` could set it, and it has ended",
    ),
    (
        "PCEXECUTE b, -1\nWAIT SIG(2001)",
        "WAIT\nIF SIG(3) THEN\nSIGNAL 2001\nEND",
        "only `b` could set it, and it never does",
    ),
    (
        "PCEXECUTE b\nWAIT SIG(2001)",
        "10 WAIT\nGOTO 10\nSIGNAL 2001",
        "only `b` could set it, and it never does",
    ),
    (
        "PCEXECUTE b\nPCABORT\nWAIT SIG(2001)",
        "WAIT\nSIGNAL 2001",
        "only `b` could set it, and it was stopped",
    ),
    (
        "PCEXECUTE b\nWAIT SIG(2001)",
        "PROMPT x\nSIGNAL 2001",
        "only `b` could set it, and it waits for an answer that nobody gives",
    ),
    (
        "PCEXECUTE b\nWAIT SIG(2001)\nSIGNAL 2002",
        "WAIT SIG(2002)\nSIGNAL 2001",
        (
            "only `b` could set it, and it waits for signal 2002, which only `main` could set:"
            " each waits for the other"
        ),
    ),
    (
        "PCEXECUTE b\nWAIT SIG(2001)",
        "WAIT SIG(1001)\nSIGNAL 2001",
        (
            "only `b` could set it, and it waits for signal 1001, which only the scenario could"
            " change, and it does not any more"
        ),
    ),
    (
        "REACT 1001, b\nWAIT SIG(2001)",
        "SIGNAL 2001",
        (
            "only the reaction `b` could set it, and it waits for signal 1001, which only the"
            " scenario could change, and it does not any more"
        ),
    ),
    (
        "LOCK 9\nREACT 1001, b\nWAIT SIG(2001)",
        "SIGNAL 2001",
        "only the reaction `b` could set it, and its priority 1 is not above 9",
    ),
]


@pytest.mark.parametrize("case", WORDS, ids=lambda case: case[2][:60])
def test_a_wait_says_who_could_end_it(case: tuple[str, str, str]) -> None:
    body, watch, words = case
    found = why(body, watch)
    assert found.rule.code == "V502"
    assert found.notes[0] == f"`main` waits for signal 2001; {words}"


def test_only_what_is_not_yet_so_is_waited_for() -> None:
    found = why("SIGNAL 2001\nWAIT SIG(2001, 2002, -2003)")
    assert found.notes[0] == "`main` waits for signal 2002; no program sets it"
    assert len(found.notes) == 2


def test_variables_are_told_by_their_names() -> None:
    found = why("n = 0\nPCEXECUTE b\nWAIT n == 1", "WAIT SIG(2001)\nn = 1")
    expected = "only `b` could change it, and it waits for signal 2001, which no program sets"
    assert found.notes[0] == f"`main` waits for `n`; {expected}"


def test_what_the_other_program_does_meanwhile_is_told() -> None:
    (_, since) = why(
        "k = 0\nPCEXECUTE b, -1\nWAIT SIG(2001)", "WAIT\nIF k == 1 THEN\nSIGNAL 2001\nEND"
    ).notes
    assert since.endswith("`b` repeats steps 1 to 5 again and again")
    (_, since) = why("k = 0\nPCEXECUTE b, -1\nWAIT SIG(2001)", "WAIT\nk = k+RANDOM").notes
    assert "`b` goes on from" in since
    (_, since) = why("WAIT SIG(2001)").notes
    assert since.startswith("nothing changes any more")


def test_a_loop_says_who_could_end_it() -> None:
    found = why("n = 0\nPCEXECUTE b\nDO\nWAIT\nUNTIL n == 1", "WAIT SIG(2001)\nn = 1")
    assert found.rule.code == "V503"
    expected = "only `b` could change it, and it waits for signal 2001, which no program sets"
    assert found.notes[1] == f"it looks at `n`; {expected}"


def test_a_chain_of_waits_that_comes_to_itself_has_an_end() -> None:
    body = "REACT 2003, c\nPCEXECUTE b\nWAIT SIG(2001)\nSIGNAL 2002"
    found = why(body, "WAIT SIG(2002)\nSIGNAL 2003", ".PROGRAM c\nSIGNAL 2001\n.END\n")
    assert found.notes[0] == (
        "`main` waits for signal 2001; only the reaction `c` could set it, and it waits for signal"
        " 2003, which only `b` could set, and it waits for signal 2002, which only `main` could"
        " set: each waits for the other"
    )
