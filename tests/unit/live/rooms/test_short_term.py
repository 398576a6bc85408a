"""Two hours of a term, as the benchmark of a whole one has them; nothing acknowledged is lost."""

from pathlib import Path

import pytest

from tests.bench.live_term import THREADS, Plan, Term

PLAN = Plan(hours=2, rooms=2, joins=16, deaths=2, servers=(), steps=((2, -1),), helped=1000)


@pytest.mark.thorough
def test_two_hours_lose_nothing_and_leave_nothing_over(tmp_path: Path) -> None:
    pytest.importorskip("argon2", reason='needs pip install "vrts[live]"')
    term = Term(tmp_path, PLAN)
    with term.server:
        term.go_on()
        term.go_on()
        term.require_logged()
        assert not term.orphans()
        assert (term.died, term.backups) == (2, 2)
        first, second = term.looks
        assert second.files <= first.files
        assert second.threads <= THREADS
