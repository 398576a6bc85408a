"""Files follow decisions: once for many, never none, and before the desk ends."""

import threading

from vrts.desk.upkeep import Upkeep


def test_many_decisions_are_written_once_and_the_last_before_it_ends() -> None:
    wrote = threading.Semaphore(0)
    count = 0

    def write() -> str:
        nonlocal count
        count += 1
        wrote.release()
        return ""

    upkeep = Upkeep(write, quiet_s=0.02)
    for _ in range(5):
        upkeep.wanted()
    upkeep.begin()
    assert wrote.acquire(timeout=20)
    upkeep.wanted()
    upkeep.end()
    assert count == 2
    assert upkeep.problem == ""
    nothing = Upkeep(write)
    nothing.begin()
    nothing.end()
    assert count == 2


def test_what_is_decided_while_files_are_written_is_written_too() -> None:
    begun, go_on, count = threading.Event(), threading.Event(), 0

    def write() -> str:
        nonlocal count
        count += 1
        begun.set()
        assert go_on.wait(20)
        return "late"

    upkeep = Upkeep(write, quiet_s=0.0)
    upkeep.begin()
    upkeep.wanted()
    assert begun.wait(20)
    upkeep.wanted()
    go_on.set()
    upkeep.end()
    assert count == 2
    assert upkeep.problem == "late"
