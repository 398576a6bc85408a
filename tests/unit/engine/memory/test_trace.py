"""The switch TRACE lists every step as it is carried out."""

from tests.support_engine import runs


def test_trace_lists_each_step() -> None:
    run = runs('x = 1\nENABLE TRACE\nx = 2\nTYPE "typed"\nDISABLE TRACE\nx = 3')
    listed = [line.strip() for line in run.output.split("\r\n")]
    assert [line.split(maxsplit=2) for line in listed if line.startswith("main")] == [
        ["main", "3.", "x = 2"],
        ["main", "4.", 'TYPE "typed"'],
        ["main", "5.", "DISABLE TRACE"],
    ]
    assert "typed" in listed


def test_a_step_that_waits_is_listed_once() -> None:
    run = runs("ENABLE TRACE\nMOVE a\nBREAK\nDELAY 0.5\nBREAK\nTYPE 1")
    for step, times in (("BREAK", 2), ("MOVE a", 1), ("DELAY 0.5", 1), ("TYPE 1", 1)):
        assert run.output.count(step) == times


def test_tracing_changes_no_times() -> None:
    body = "{}n = 0\nFOR i = 1 TO 30\nn = n+1\nEND\nMOVE a\nBREAK\nTIMER 1 = 0"
    plain, traced = (runs(body.format(word)) for word in ("", "ENABLE TRACE\n"))
    assert traced.ended_s == plain.ended_s
