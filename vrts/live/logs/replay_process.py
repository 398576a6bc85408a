"""Makes the page of a session with a replay of its log.

`python -m vrts.live.logs.replay_process` reads an `Order` as JSON and writes the page; what is
wrong goes to its standard error.
"""

import os
import sys
from typing import Final

import msgspec

from vrts.live.logs.log_file import read_log
from vrts.live.logs.logged_sessions import LogFault
from vrts.live.logs.replay_page import NoPage, Order
from vrts.live.logs.shown_session import shown_session
from vrts.live.logs.voices import index_of, voices_of
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Start
from vrts.live.session.setting import setting_of
from vrts.report.page.page import page
from vrts.report.page.stills import page_stills

MORE_S: Final = 10.0  # how long a session goes on after the last thing done
NOTHING: Final = "nothing was done in this room yet"


def page_of(order: Order) -> bytes:
    """Return the page.

    Raises:
        NoPage: The log holds no session, or what it holds cannot be replayed.
    """
    try:
        sessions = read_log(order.log)
    except LogFault as problem:
        raise NoPage(str(problem)) from problem
    eventful = [session for session in sessions if session.entries]
    if not eventful:
        raise NoPage(NOTHING)
    session = eventful[-1]
    place = next((place for place in order.places if place.id == session.scene), None)
    if place is None:
        raise NoPage(f"the scene `{session.scene}` is not in the set any more")
    start = Start(
        *(session.number, "", place.scene, place.task, place.lab), controller=session.controller
    )
    try:
        setting = setting_of(start)
        run = replay(start, session.entries, session.entries[-1].at_s + MORE_S, setting)
    except ValueError as problem:
        raise NoPage(f"the log does not fit: {problem}") from problem
    found = shown_session("session", order.name, setting, run)
    which = index_of(sessions, session)
    voices = voices_of(order.log, which, order.chat, run.horizon_s)
    return page(found, page_stills(found), more=setting.more, voices=voices).encode()


def main() -> None:
    """Do what is ordered on standard input."""
    if hasattr(os, "nice"):
        os.nice(10)  # frames come first
    order = msgspec.json.decode(sys.stdin.buffer.read(), type=Order)
    try:
        sys.stdout.buffer.write(page_of(order))
    except NoPage as problem:
        sys.stderr.write(f"{problem}\n")
        raise SystemExit(1) from problem


if __name__ == "__main__":
    main()
