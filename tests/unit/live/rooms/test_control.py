"""The control right: first come, first served, and every way in which it passes on."""

from vrts.live.rooms.control import AWAY_S, ControlRight


def test_the_first_has_it_and_the_others_wait_in_order() -> None:
    right = ControlRight()
    assert right.request("anna", 0.0)
    assert right.request("ben", 1.0)
    assert right.request("carl", 2.0)
    assert not right.request("ben", 3.0), "nobody stands in the queue twice"
    assert (right.holder, right.queue) == ("anna", ["ben", "carl"])
    assert right.hand_back("anna", 4.0)
    assert (right.holder, right.queue) == ("ben", ["carl"])
    assert right.hand_back("carl", 5.0), "one may leave the queue"
    assert right.hand_back("ben", 6.0)
    assert (right.holder, right.lease, right.queue) == ("", "", [])


def test_a_command_counts_once_and_under_its_own_lease_only() -> None:
    right = ControlRight()
    right.request("anna", 0.0)
    old = right.lease
    assert right.accept("anna", old, 1, 0.1) == ""
    assert right.accept("anna", old, 1, 0.2) == "replayed"
    assert right.accept("anna", old, 0, 0.2) == "replayed"
    assert right.accept("anna", old, 7, 0.2) == ""
    assert right.accept("ben", old, 8, 0.3) == "role", "of no use to others"
    right.hand_over("ben", 1.0)
    right.hand_over("anna", 2.0)
    assert right.accept("anna", old, 9, 2.1) == "lease", "the hand-over ended it"
    assert right.accept("anna", right.lease, 1, 2.2) == "", "each lease counts from the beginning"


def test_idle_holders_lose_it() -> None:
    right = ControlRight(idle_s=60.0)
    right.request("anna", 0.0)
    right.accept("anna", right.lease, 1, 50.0)
    assert not right.pass_time(109.9)
    assert right.pass_time(110.0)
    assert right.holder == ""


def test_a_dropped_connection_keeps_it_for_a_while() -> None:
    right = ControlRight()
    right.request("anna", 0.0)
    right.request("ben", 0.0)
    right.away("anna", 10.0)
    assert not right.pass_time(10.0 + AWAY_S - 0.1)
    right.back("anna")
    assert not right.pass_time(10.0 + AWAY_S + 0.1), "who is back in time has it still"
    right.away("anna", 40.0)
    assert right.pass_time(40.0 + AWAY_S)
    assert right.holder == "ben"


def test_turns_are_fair_only_while_others_wait() -> None:
    right = ControlRight(turn_s=30.0, idle_s=0.0)
    right.request("anna", 0.0)
    assert not right.pass_time(1000.0)
    assert right.ends() == 0.0
    right.request("ben", 1000.0)
    assert right.ends() == 30.0, "a long turn is over as soon as somebody waits"
    assert right.pass_time(1000.1)
    assert right.holder == "ben"


def test_a_supervisor_bypasses_the_queue_and_locks_the_allocation() -> None:
    right = ControlRight()
    for person in ("anna", "ben", "carl"):
        right.request(person, 0.0)
    right.hand_over("carl", 1.0)
    assert (right.holder, right.queue) == ("carl", ["ben"])
    right.locked = True
    right.hand_back("carl", 2.0)
    assert right.holder == "", "nothing is allocated while it is locked"
    right.request("dora", 3.0)
    assert (right.holder, right.queue) == ("", ["ben", "dora"])
    right.unlock(4.0)
    assert right.holder == "ben"
