"""Hands raised in rooms of their own: a queue that those see who lead, and what comes of it.

A hand outlasts a restart, and stays up until it is taken down: by who raised it, by who has helped,
or because nobody of the room was there for a while.
"""

from typing import Final

from vrts.live.door import text_frame
from vrts.live.lasting.clock import wall
from vrts.live.names import readable
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Hands, Pointed
from vrts.live.protocol.listed import Hand
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Room
from vrts.live.store.accounts import Account
from vrts.live.store.course.own_rooms import OwnRoom, keep_own_room

MOST: Final = 50  # hands that are told of; the others are counted
GONE_S: Final = 600.0  # after which a hand goes down where nobody of the room is there


def leads(account: Account, room: Room) -> bool:
    """Return whether somebody may look into a room of somebody's own, and help there."""
    return account.leads_in(room.id) and not room.is_own(account)


async def raise_hand(hub: Hub, room: Room, member: Member, *, up: bool, text: str = "") -> None:
    """Raise or lower a hand in a room of their own.

    Raises:
        NotObeyed: It is not their room.
    """
    own = room.own
    if own is None or member.account.id not in room.owners:
        raise NotObeyed("role", "only those raise a hand here whose robot it is")
    if not up:
        await _keep(hub, room, own._replace(hand_at=0.0, hand_by=None, hand_text=""))
        return
    if not member.questions.take(member.heard):
        raise NotObeyed("rate", "you raise your hand too often", "wait a few seconds")
    since = own.hand_at or wall()  # who adds a word keeps the place in the queue
    words = readable(text)
    await _keep(hub, room, own._replace(hand_at=since, hand_by=member.account.id, hand_text=words))


async def lower_hand(hub: Hub, room: Room) -> None:
    """Take the hand of a room down: somebody has helped, or nobody is there any more."""
    own = room.own
    if own is not None and own.hand_at:
        await _keep(hub, room, own._replace(hand_at=0.0, hand_by=None, hand_text=""))


def point(room: Room, member: Member, body: str) -> None:
    """Show all others in a room of their own what somebody points at.

    Raises:
        NotObeyed: Too often.
    """
    if room.own is None:
        raise NotObeyed("room", "pointing is for robots of one's own")
    if not member.questions.take(member.heard):
        raise NotObeyed("rate", "you point too often", "wait a moment")
    frame = text_frame(encode(Pointed(member.id, readable(body))))
    for other in room.members.values():
        if other is not member:
            other.send(frame)


def show_hands(hub: Hub) -> None:
    """Tell those who lead which hands are up, and those who wait where they stand."""
    for member in hub.everybody():
        if member.door is not None and member.settled:
            show_hands_to(hub, member)


def show_hands_to(hub: Hub, member: Member) -> None:
    """Tell one of them."""
    told = hands_for(hub, member)
    if told is not None:
        member.send(text_frame(encode(told)))


def hands_for(hub: Hub, member: Member) -> Hands | None:
    """Return what somebody may know of hands; None: nothing, as there is none for them."""
    queue = _queue(hub)
    account = member.account
    if account.leads_any:
        led = [(n, room) for n, room in enumerate(queue, 1) if leads(account, room)]
        own = [room for room in hub.rooms.values() if room.own is not None and leads(account, room)]
        awake = sum(not room.asleep for room in own)
        rows = tuple(_row(room, n) for n, room in led[:MOST])
        return Hands(rows, max(len(led) - MOST, 0), len(own), awake)
    room = hub.rooms.get(member.room)
    if room is None or room.own is None or account.id not in room.owners:
        return None
    mine = [(n, one) for n, one in enumerate(queue, 1) if one is room]
    return Hands(tuple(_row(one, n) for n, one in mine))


def shown(hub: Hub) -> tuple[tuple[Hand, ...], int]:
    """Return what there is to tell, to see whether it has changed."""
    rows = tuple(_row(room, n) for n, room in enumerate(_queue(hub), 1))
    return rows, sum(room.own is not None and not room.asleep for room in hub.rooms.values())


async def lower_gone(hub: Hub, now: float) -> None:
    """Take hands down where nobody of the room was there for a while; `now` only goes on [s]."""
    for room in _queue(hub):
        since = room.empty_since
        if since is not None and now - since > GONE_S:
            await lower_hand(hub, room)


async def _keep(hub: Hub, room: Room, own: OwnRoom) -> None:
    await hub.database.do(lambda connection: keep_own_room(connection, own))
    room.own = own
    room.tell_people_soon()
    show_hands(hub)


def _queue(hub: Hub) -> list[Room]:
    """Return the rooms with a hand up, who has waited longest first."""
    up = [(room.own.hand_at, room.id) for room in hub.rooms.values() if room.own is not None]
    return [hub.rooms[id_] for at, id_ in sorted(up) if at]


def _row(room: Room, place: int) -> Hand:
    own = room.own
    assert own is not None
    helping = {
        member.account.name
        for member in room.members.values()
        if member.door is not None and leads(member.account, room)
    }
    here = any(m.door is not None and m.account.id in room.owners for m in room.members.values())
    name = room.owners.get(own.hand_by or 0, room.whose)
    return Hand(
        room=room.id,
        where=room.kept.name,
        name=name,
        since=own.hand_at,
        text=own.hand_text,
        place=place,
        here=here,
        helping=tuple(sorted(helping)),
    )
