"""What 200 robots of their own cost while they sleep: bytes sent, and each round of time."""

import asyncio
import time
from pathlib import Path

from vrts.live.door import text_frame
from vrts.live.places import places_of
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Rooms
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.opening import make_room
from vrts.live.rooms.own.hands import hands_for
from vrts.live.rooms.own.limits import OwnLimits
from vrts.live.rooms.own.making import Making, Wanted
from vrts.live.rooms.own.sleeping import Sleeper
from vrts.live.rooms.sessions import Sessions
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account, add_account
from vrts.live.store.database import Database

STUDENTS = 200
HANDS = 30
ROUNDS = 50


def test_what_robots_cost_that_sleep(tmp_path: Path) -> None:
    async def work() -> None:
        hub = Hub(
            Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "db.sqlite")
        )
        await make_room(hub, "Class", "cans-on-bases")
        making, sleeper = Making(hub, OwnLimits()), Sleeper(hub, Sessions(hub))
        for number in range(STUDENTS):
            name = f"Student {number}"
            who = await hub.database.do(lambda c, name=name: add_account(c, name, 0.0))
            room = await making.room(Wanted(who.id, name, "cans-on-bases", "Cans on bases"))
            if number < HANDS and room.own is not None:
                words = "the hand does not close"
                room.own = room.own._replace(hand_at=1.0, hand_by=who.id, hand_text=words)
        boss = Member(Account(0, "Boss", True, None), next(iter(hub.rooms)))
        told = text_frame(encode(Rooms(hub.entries(boss.account), "")))
        whole = text_frame(encode(Rooms(tuple(room.entry for room in hub.rooms.values()), "")))
        queue = text_frame(encode(hands_for(hub, boss)))
        print(f"\nlist of rooms: {len(told)} bytes to a teacher; all of them: {len(whole)}")
        print(f"{HANDS} raised hands: {len(queue)} bytes, whenever one changes")
        began = time.perf_counter()
        for _ in range(ROUNDS):
            await sleeper.beat()
        each = (time.perf_counter() - began) / ROUNDS
        print(f"a round of {STUDENTS} that sleep, once a second: {1000 * each:.2f} ms")
        await hub.stop()

    asyncio.run(work())
