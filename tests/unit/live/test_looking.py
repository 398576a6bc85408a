"""Blocks of the past are asked of a session once, and forgotten when session time jumps."""

import asyncio
import base64

import msgspec
import pytest

from vrts.live.looking.blocks import FRESH_S, MOST_BYTES, Blocks
from vrts.live.refusal import NotObeyed
from vrts.live.session.channel.messages import Looked


class Asked:
    """A session that notes what it is asked."""

    def __init__(self) -> None:
        self.now = 100.0
        self.numbers: list[int] = []
        self.blocks = Blocks(lambda: self.now)

    def ask(self, number: int) -> int:
        self.numbers.append(number)
        return len(self.numbers)

    def answer(self, data: bytes = b"", why: str = "", *, whole: bool = False) -> None:
        looked = Looked(len(self.numbers), base64.b64encode(data).decode(), whole, why)
        self.blocks.answered(looked.ref, msgspec.json.encode(looked))


async def twenty(asked: Asked, number: int) -> "list[asyncio.Task[bytes]]":
    """Have twenty people look at a block."""
    looking = [asyncio.create_task(asked.blocks.get(number, asked.ask)) for _ in range(20)]
    await asyncio.sleep(0)
    return looking


def test_many_who_look_at_a_block_ask_the_session_once() -> None:
    async def work() -> None:
        asked = Asked()
        looking = await twenty(asked, 3)
        asked.answer(b"three", whole=True)
        assert await asyncio.gather(*looking) == [b"three"] * 20
        asked.now += 1e6
        assert await asked.blocks.get(3, asked.ask) == b"three"
        assert asked.numbers == [3]

    asyncio.run(work())


def test_a_block_that_grows_is_asked_for_again_after_a_second() -> None:
    async def work() -> None:
        asked = Asked()
        looking = await twenty(asked, 0)
        asked.answer(b"begun")
        await asyncio.gather(*looking)
        asked.now += 0.9 * FRESH_S
        assert await asked.blocks.get(0, asked.ask) == b"begun"
        asked.now += 0.2 * FRESH_S
        looking = await twenty(asked, 0)
        asked.answer(b"more")
        assert set(await asyncio.gather(*looking)) == {b"more"}
        assert asked.numbers == [0, 0]

    asyncio.run(work())


def test_what_was_asked_before_session_time_jumped_does_not_count() -> None:
    async def work() -> None:
        asked = Asked()
        looking = await twenty(asked, 1)
        asked.blocks.forget()
        asked.answer(b"of another time", whole=True)
        for refused in await asyncio.gather(*looking, return_exceptions=True):
            assert isinstance(refused, NotObeyed)
            assert refused.code == "jumped"
        looking = await twenty(asked, 1)
        asked.answer(b"of this time", whole=True)
        assert set(await asyncio.gather(*looking)) == {b"of this time"}

    asyncio.run(work())


def test_why_there_is_no_block_is_told_to_all_who_wait_and_not_kept() -> None:
    async def work() -> None:
        asked = Asked()
        looking = await twenty(asked, 9)
        asked.answer(why="this has not happened yet")
        refused = await asyncio.gather(*looking, return_exceptions=True)
        assert {str(one) for one in refused} == {"this has not happened yet"}
        await twenty(asked, 9)
        assert asked.numbers == [9, 9]

    asyncio.run(work())


def test_no_more_is_kept_than_a_room_may_have() -> None:
    async def work() -> None:
        asked = Asked()
        for number in (0, 1, 2):
            looking = await twenty(asked, number)
            asked.answer(bytes(MOST_BYTES // 2), whole=True)
            await asyncio.gather(*looking)
        await twenty(asked, 2)
        assert asked.numbers == [0, 1, 2]
        await twenty(asked, 0)
        assert asked.numbers == [0, 1, 2, 0], "the one that was not asked for longest is gone"

    asyncio.run(work())


@pytest.mark.parametrize("ref", [0, 7])
def test_an_answer_that_nobody_waits_for_changes_nothing(ref: int) -> None:
    Asked().blocks.answered(ref, msgspec.json.encode(Looked(ref, whole=True)))
