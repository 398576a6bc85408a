"""Time slots of a shared robot: booked, moved, freed, and what they mean for who has control."""

from typing import Final

from vrts.course.course import Course
from vrts.course.slot_rules import Slot, SlotRules
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import announce, control_changed
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Room
from vrts.live.store.accounts import Account
from vrts.live.store.course import slots as store
from vrts.live.store.course.slots import Booked, NotMoved

AGAIN_S: Final = 5.0  # how often it is looked what is booked
KEPT_S: Final = 30 * 86_400.0  # how long a slot is known that is over
WHY: Final = {
    "taken": ("taken", "somebody else has this time", "choose another one"),
    "most": ("limit", "you have booked as many times as you may", "give one back first"),
}


class Slots:
    """The slots of a course."""

    def __init__(self, course: Course, hub: Hub) -> None:
        """Serve a course."""
        self._course = course
        self._hub = hub
        self._booked: list[Booked] = []
        self._looked = 0.0
        self._now = 0.0  # start of the slot that goes on; 0: none
        self._given = False  # its owner had control in it

    def follow(self, course: Course) -> None:
        """Follow a course whose file has changed."""
        self._course = course

    @property
    def rules(self) -> SlotRules | None:
        """When what can be booked; None: nothing."""
        return self._course.slots

    @property
    def room(self) -> Room | None:
        """The room that can be booked; None: it is closed."""
        rules = self.rules
        rooms = self._hub.rooms.values()
        called = (room for room in rooms if rules is not None and room.kept.name == rules.room)
        return next((room for room in called if room.shared), None)

    async def table(self, now: float) -> list[tuple[Slot, Booked | None]]:
        """Return the slots that come, and whose they are; `now` is Unix time [s]."""
        rules, room = self._there()
        taken = await self._hub.database.do(lambda c: store.booked(c, room.id, now))
        whose = {one.starts: one for one in taken}
        known = [(slot, whose.pop(slot.starts, None)) for slot in rules.coming(now)]
        known += [(Slot(one.starts, one.ends), one) for one in whose.values()]  # of other rules
        return sorted(known, key=lambda row: row[0])

    async def book(self, account: int, starts: float, now: float, *, free: bool = False) -> None:
        """Give somebody a slot; `free`: however many they have.

        Raises:
            NotObeyed: There is none at that time, or they cannot have it.
        """
        rules, room = self._there()
        span = self._span(rules, starts, now)
        most = 10_000 if free else rules.ahead
        became = await self._hub.database.do(
            lambda c: store.book(c, room.id, span, account, now=now, most=most)
        )
        if became != "booked":
            raise NotObeyed(*WHY[became])
        await self._look(now)

    async def cancel(self, account: Account, starts: float, now: float) -> None:
        """Free a slot of one's own; who leads frees any.

        Raises:
            NotObeyed: It is not theirs.
        """
        _, room = self._there()
        whose = None if account.leads_in(room.id) else account.id
        if not await self._hub.database.do(lambda c: store.cancel(c, room.id, starts, whose)):
            raise NotObeyed("slot", "this time is not yours")
        await self._look(now)

    async def move(self, account: Account, starts: float, to: float, now: float) -> None:
        """Exchange a slot of one's own for another; who leads moves any.

        Raises:
            NotObeyed: It is not theirs, or the other one cannot be had; nothing has changed then.
        """
        rules, room = self._there()
        span = self._span(rules, to, now)
        leads = account.leads_in(room.id)
        whose, most = (None, 10_000) if leads else (account.id, rules.ahead)
        try:
            found = await self._hub.database.do(
                lambda c: store.move(c, room.id, starts, span, whose, now=now, most=most)
            )
        except NotMoved as problem:
            raise NotObeyed(*WHY[problem.why]) from problem
        if not found:
            raise NotObeyed("slot", "this time is not yours")
        await self._look(now)

    async def beat(self, now: float, steady: float) -> None:
        """Let who has booked this time have control.

        Args:
            now: Unix time [s].
            steady: Of a clock that only goes on [s].
        """
        room = self.room
        if room is None:
            return
        if steady - self._looked > AGAIN_S:
            self._looked = steady
            await self._look(now)
        slot = next((one for one in self._booked if one.starts <= now < one.ends), None)
        holder = room.members.get(room.control.holder)
        if (0.0 if slot is None else slot.starts) != self._now:
            self._now, self._given = (0.0 if slot is None else slot.starts), False
            room.control.turn_s = room.kept.turn_s
            others = slot is None or holder is None or holder.account.id != slot.account
            if others and holder is not None and slot is None and room.control.queue:
                room.control.release(steady)
                control_changed(self._hub, room)
        if slot is None or room.control.locked:
            return
        if holder is not None and holder.account.id == slot.account:
            self._given, room.control.turn_s = True, 0.0  # nobody else's turn comes meanwhile
            return
        member = _of(room, slot.account)
        if member is None or (self._given and member.id not in room.control.queue):
            room.control.turn_s = room.kept.turn_s
            return
        self._given, room.control.turn_s = True, 0.0
        room.control.hand_over(member.id, steady)
        control_changed(self._hub, room)
        self._hub.spawn(announce(self._hub, room, f"{slot.name} has booked this time"))

    async def _look(self, now: float) -> None:
        room = self.room
        if room is not None:
            id_ = room.id
            self._booked = await self._hub.database.do(lambda c: store.booked(c, id_, now))

    async def forget_past(self, now: float) -> None:
        """Forget slots that were over long ago."""
        await self._hub.database.do(lambda c: store.forget_past(c, now - KEPT_S))

    def _there(self) -> tuple[SlotRules, Room]:
        rules, room = self.rules, self.room
        if rules is None or room is None:
            raise NotObeyed("slots", "this course has no time slots")
        return rules, room

    def _span(self, rules: SlotRules, starts: float, now: float) -> tuple[float, float]:
        slot = next((one for one in rules.coming(now) if one.starts == starts), None)
        if slot is None:
            raise NotObeyed("slot", "there is no time to book then")
        return slot


def _of(room: Room, account: int) -> Member | None:
    """Return somebody's place in a room, if they are there."""
    there = (m for m in room.members.values() if m.account.id == account)
    return next((member for member in there if member.door is not None), None)
