"""A screen's handler of hang-ups: it is there while the screen is, and leaves all as it was."""

import asyncio
import os
import signal
from collections.abc import Callable, Iterator

import pytest

from vrts.monitor.screens.hanging_up import hang_up


@pytest.fixture(autouse=True)
def as_it_was() -> Iterator[None]:
    before = signal.getsignal(signal.SIGHUP)
    yield
    signal.signal(signal.SIGHUP, before)


def shown(during: Callable[[], None]) -> bool:
    """Do something while a screen is shown, wait for a hang-up; return whether one came."""

    async def screen() -> bool:
        told = asyncio.Event()
        with hang_up(told.set):
            during()
            if signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
                return told.is_set()
            return await asyncio.wait_for(told.wait(), 30)

    return asyncio.run(screen())


def hang_up_now() -> None:
    os.kill(os.getpid(), signal.SIGHUP)


def test_a_hang_up_is_told_and_what_was_there_is_put_back() -> None:
    def own(number: int, frame: object) -> None:
        raise AssertionError

    for before in (own, signal.SIG_DFL):
        signal.signal(signal.SIGHUP, before)
        assert shown(hang_up_now)
        assert signal.getsignal(signal.SIGHUP) is before


def test_who_was_started_with_nohup_goes_on() -> None:
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    assert not shown(hang_up_now)
    assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
