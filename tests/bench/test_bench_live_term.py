"""24 hours of a term of live teaching: nothing acknowledged is lost, memory is flat; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live_term.py -s`; `VRTS_TERM=0.1` does a tenth
in each hour. Hours are counted so: before each of the 24 the server's clock is set on by an hour,
then what people do in an hour is done without the waiting between (`tests/bench/live_term.py`).
The machine's clock, as the server sees it, is stepped besides: an hour back, a day forward, an hour
back (`tests/unit/live/rooms/test_clock_steps.py` steps it for the whole process). In every hour all
that was acknowledged is looked for in an online backup that was restored, and after each death in
the session that goes on. The second half of the hours may add 5 % of memory.
"""

import os
import time
from pathlib import Path

from tests.bench.live_term import THREADS, Look, Plan, Term

SHARE = float(os.environ.get("VRTS_TERM", "1"))
GROWTH = 0.05
PLAN = Plan(joins=int(2000 * SHARE), deaths=int(300 * SHARE))


def row(look: Look) -> str:
    """Return a row of the table."""
    return (
        f"  {look.hour:4d} {look.server_mb:7.1f} {look.sessions_mb:9.1f} {look.files:6d}"
        f" {look.sockets:8d} {look.threads:8d} {look.processes:10d} {look.database_mb:9.1f}"
    )


def test_a_term(tmp_path: Path) -> None:
    began_s = time.monotonic()
    term = Term(tmp_path, PLAN)
    print("\n  hour  server  sessions  files  sockets  threads  processes  database")
    with term.server:
        for _ in range(PLAN.hours):
            term.go_on()
            print(row(term.looks[-1]), flush=True)
        term.require_logged()
        orphans = term.orphans()
    middle, last = term.looks[PLAN.hours // 2 - 1], term.looks[-1]
    grown = {
        "server": last.server_mb / middle.server_mb - 1.0,
        "sessions": last.sessions_mb / middle.sessions_mb - 1.0,
    }
    commands = sum(map(len, term.people.ledger.commands.values()))
    ledger = term.people.ledger
    steps = ", ".join(f"{hours:+d} h" for _, hours in PLAN.steps)
    print(
        f"{PLAN.hours} hours in {time.monotonic() - began_s:.0f} s (load {os.getloadavg()[0]:.1f}):"
        f" {term.people.joined} joins by {len(term.people.cookies)} guests,"
        f" {term.died} deaths of sessions, {term.killed} of the server, {term.backups} backups"
        f" restored and verified, steps of the machine's clock: {steps}\n"
        f"  acknowledged and found: {commands} commands, {len(ledger.lines)} lines,"
        f" {len(ledger.notes)} notes, {len(ledger.programs)} versions of programs\n"
        "  memory in the second half: "
        + ", ".join(f"{name} {100 * share:+.1f} %" for name, share in grown.items())
        + f"; {len(orphans)} processes left over"
    )
    assert not orphans
    assert last.files <= middle.files
    assert last.threads <= THREADS
    assert max(grown.values()) <= GROWTH
