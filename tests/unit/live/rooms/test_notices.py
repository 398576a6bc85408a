"""Announcements and stops: who has seen one, when it is over, and who may say so."""

from vrts.live.notices.announcement import Announcement, next_announcement
from vrts.live.notices.stopping import moves


def test_people_who_have_seen_an_announcement_are_counted_once_and_while_they_are_here() -> None:
    told = Announcement(7, 1.0, "Dr. Lee", "Read page 4")
    for account, closed in ((1, False), (1, True), (1, True), (2, False), (3, True)):
        told.noticed(account, closed=closed)
    assert told.changed
    whole = told.message({1, 2, 4})
    assert (whole.seen, whole.closed, whole.people) == (2, 1, 3)
    others = told.message(None)
    assert (others.text, others.seen, others.closed, others.people) == ("Read page 4", 0, 0, 0)
    told.changed = False
    told.noticed(1, closed=True)
    assert not told.changed, "nothing new for supervisors"


def test_no_two_announcements_have_one_number_though_the_clock_goes_back() -> None:
    first = next_announcement(None, 100.0, "Dr. Lee", "one")
    assert next_announcement(first, 50.0, "Dr. Lee", "two").id > first.id


def test_a_stop_is_over_when_something_moves() -> None:
    assert moves(b'{"type":"status","mode":"moving","time_s":1.0}')
    assert not any(moves(b'{"mode":"%b"}' % mode) for mode in (b"idle", b"stopped", b"braking"))
