"""What a session shows of a program that never ends: it has an end."""

from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import Json
from vrts.live.session.views.showing import CONTACTS_KEPT, Showing


def touching(showing: Showing, times: range) -> None:
    """Have contacts found at such times [ms of session time]."""
    rows: list[Json] = [{"start": 1e-3 * at, "end": 1e-3 * at} for at in times]
    showing.contacts += rows
    showing.near += rows
    showing.checked_s = 1e-3 * times.stop
    showing.forget_contacts()


def test_the_first_and_the_last_contacts_are_kept_and_all_are_counted(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(5.0)
    showing = driven.session.showing
    for begin in range(0, 5000, 100):
        touching(showing, range(begin, begin + 100))
    assert len(showing.contacts) == len(showing.near) == 2 * CONTACTS_KEPT
    assert [row["start"] for row in showing.contacts[:2]] == [0.0, 0.001]
    assert showing.contacts[-1]["start"] == pytest.approx(4.999)
    assert showing.status().contacts == 5000
    assert len(showing.snapshot(0).contacts) == 2 * CONTACTS_KEPT

    assert driven.done(driven.act(do.Rewind(4.9))).accepted, "to a time of which all is known"
    assert showing.status().contacts == 4901
    assert showing.checked_s == pytest.approx(4.9)
    assert driven.done(driven.act(do.Rewind(1.0))).accepted, "to one that was forgotten"
    assert showing.status().contacts == CONTACTS_KEPT
    assert showing.checked_s == pytest.approx(1e-3 * (CONTACTS_KEPT - 1)), "it is looked at again"
