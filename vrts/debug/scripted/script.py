"""Scripts: commands one after another, within limits of time and of what is written."""

import _thread
import signal
import threading
from collections.abc import Generator, Iterator, Sequence
from contextlib import contextmanager

from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.places import place_of
from vrts.debug.scripted.reading import Line
from vrts.debug.scripted.session import Done, Session

MOST_WRITTEN = 20_000  # lines of a whole script


class TimeIsUp(Exception):  # noqa: N818 -- names the situation
    """A script has taken longer than it may."""


def performed(session: Session, lines: Sequence[Line], limit_s: float) -> Iterator[Done]:
    """Carry out commands; yield what each did. A refused one does not end it, a limit does.

    Args:
        session: What they act on.
        lines: The commands.
        limit_s: How long all of them may take [s].

    Raises:
        KeyboardInterrupt: Somebody stopped it.
    """
    written = 0
    command = ""
    try:
        with within(limit_s):
            for line in lines:
                command = line.text
                done = carry_out(session, command)
                yield done
                written += len(done.said) + len(done.log) + 1
                written += 0 if done.table is None else len(done.table.rows)
                if written > MOST_WRITTEN:
                    text = f"a script writes at most {MOST_WRITTEN:,} lines: the rest is left out"
                    yield _ended(session, "limit", text)
                    return
    except TimeIsUp:
        text = f"the script took longer than {limit_s:g} s: the rest is left out"
        yield _ended(session, command, text)


@contextmanager
def within(limit_s: float) -> Generator[None]:
    """Stop what is done inside after some time [s], as Ctrl-C would. In the main thread only.

    Raises:
        TimeIsUp: It took longer.
    """
    up = threading.Event()

    def ring() -> None:
        up.set()
        if hasattr(signal, "pthread_kill"):  # also wakes what waits
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
        else:
            _thread.interrupt_main()

    timer = threading.Timer(limit_s, ring)
    timer.daemon = True
    timer.start()
    try:
        yield
    except KeyboardInterrupt:
        if up.is_set():
            raise TimeIsUp from None
        raise
    finally:
        timer.cancel()


def _ended(session: Session, command: str, text: str) -> Done:
    place = place_of(session.debugger, process=session.process)
    return Done(command, place, ok=False, said=[text])
