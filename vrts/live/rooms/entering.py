"""People who come into a room, drop out of it, come back, and leave it."""

import secrets
from collections.abc import Iterable
from typing import Final

import msgspec

from vrts.live import limits
from vrts.live.door import Door, text_frame
from vrts.live.entrance.crowding import Connected, gives_way
from vrts.live.entrance.entries import group
from vrts.live.lasting.clock import steady, wall
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_anybody import Join
from vrts.live.protocol.from_server import Closed, Rooms, Snapshot, Welcome
from vrts.live.protocol.listed import SceneEntry
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub, may_enter
from vrts.live.rooms.keeping import control_changed, keep_soon, record
from vrts.live.rooms.member import Member
from vrts.live.rooms.resting.last_seen import last_seen
from vrts.live.rooms.room import Room
from vrts.live.store.accounts import GUESTS, Account
from vrts.live.store.guests import saw

NEXT: Final = 8  # of those who wait for control keep their place in a full room
CROWDED: Final = (
    "the server is full: many came from your network, or you have several pages open; enter again"
)


def enter(
    hub: Hub,
    account: Account,
    join: Join,
    door: Door,
    *,
    address: str = "",
    browsers: frozenset[bytes] = frozenset(),
) -> Member:
    """Give somebody a place in a room, or the one they had.

    Args:
        hub: Of the room.
        account: Who it is.
        join: The first message.
        door: The way to them.
        address: From where they come.
        browsers: What their browser is known by.

    Raises:
        NotObeyed: They may not enter it, or it is full of people who take no more than a share.
    """
    room = room_for(hub, account, join.room)
    member = _returning(room, account, join)
    if member is None:
        make_way(hub, room, account, address)
        member = Member(account, room.id)
        for other in hub.everybody():
            if other.account.id == account.id:
                member.share(other)
        room.members[member.id] = member
        if account.id not in room.came:  # once a session: who comes again and again fills no log
            if len(room.came) >= GUESTS:  # nearly all of them are gone for good
                room.came = {other.account.id for other in room.members.values()}
            room.came.add(account.id)
            record(hub, room, "join", account, {})
    member.address, member.browsers = address, browsers
    member.came = member.heard = steady()
    _saw(hub, member, 0.0)
    resumed = join.resume == member.resume and room.sent.covers(join.seen, room.number)
    member.seen = join.seen if resumed else None
    member.door, member.rate, member.settled = door, join.rate, False
    room.control.back(member.id)
    welcome = Welcome(
        member.id,
        account.name,
        member.supervisor,
        room.id,
        member.resume,
        resumed,
        join.rate,
    )
    door.send(text_frame(encode(welcome)))
    comes = room.is_own(account) if room.own is None else _alone_in(room, account)
    if (hub.settings.alone or comes) and room.control.request(member.id, steady()):
        control_changed(hub, room)
    if hub.sleeping is not None:
        hub.sleeping.entered(room, account)
    room.tell_people_soon()
    room.joining.append(member)
    if room.process is None or not room.process.ready:
        settle(hub, room, bytes(last_seen(room).state))
    elif len(room.joining) == 1:
        room.process.ask_snapshot()
    return member


def _alone_in(room: Room, account: Account) -> bool:
    """Return whether control comes with entering a room of one's own: nobody else has it."""
    return room.is_own(account) and not room.control.holder and not room.control.queue


def settle(hub: Hub, room: Room, state: bytes) -> None:
    """Send those who wait the state of the room."""
    joining, room.joining = room.joining, []
    if joining:
        room.tell_people_soon()  # who waits for a snapshot is told nothing else
    for member in joining:
        if member.door is None:
            continue
        member.settled = True
        if member.seen is not None:
            for frame in room.sent.missed(member, member.seen):
                member.send(frame)
        snapshot = Snapshot(
            room=room.entry,
            rooms=hub.entries(member.account),
            scenes=_scenes(hub) if member.supervisor else (),
            number=room.number,
            session=room.session,
            scene_url=room.scene_url,
            state=msgspec.Raw(state),
            chat=() if member.seen is not None else room.chat_for(member),
            notes=tuple(room.notes),
        )
        member.send(text_frame(encode(snapshot)))
        member.send(text_frame(encode(room.control_for(member))))
        if room.waits is not None:
            member.send(text_frame(encode(room.waits_for(member))))
        if hub.announcement is not None:
            member.send(text_frame(encode(hub.announced(member))))
        if room.stopped is not None:
            member.send(text_frame(encode(room.stopped)))
        all_rooms = Rooms(hub.entries(member.account), hub.projector)
        member.send(text_frame(encode(all_rooms)))
        if member.account.supervisor:
            member.send(text_frame(encode(hub.class_code())))
        hub.settled(member)


def drop(hub: Hub, member: Member, door: Door) -> None:
    """Take note that a connection is gone; the place is kept for a while."""
    if member.door is not door:
        return  # they are back already, on another connection
    member.door, member.settled, member.wall = None, False, False
    member.away_since = steady()
    _saw(hub, member, steady() - member.came)
    room = hub.rooms.get(member.room)
    if room is not None:
        room.control.away(member.id, member.away_since)
        room.tell_people_soon()


def make_way_for_one(hub: Hub, address: str = "") -> bool:
    """Make sure that the server can take one more connection; return whether it can."""
    here = {member.id: member for member in hub.everybody() if member.door is not None}
    if len(here) < limits.ALL_CONNECTIONS:
        return True
    return _end_one(hub, here, address)


def _end_one(hub: Hub, here: dict[str, Member], address: str) -> bool:
    """End a connection of who takes more than a share; return whether there is one."""
    place = gives_way([_connected(hub, m) for m in here.values()], group(address))
    if place is None:
        return False
    send_away(hub, here[place], "crowded", CROWDED)
    return True


def _connected(hub: Hub, member: Member) -> Connected:
    address, keeps = group(member.address), _keeps(hub, member)
    who = member.account.id
    return Connected(member.id, who, address, member.heard, keeps, member.browsers, member.since)


def _keeps(hub: Hub, member: Member) -> bool:
    """Return whether somebody leads, operates, or is among the next to operate."""
    control = hub.rooms[member.room].control
    return member.supervisor or member.id in (control.holder, *control.queue[:NEXT])


def make_way(hub: Hub, room: Room, account: Account, address: str = "") -> None:
    """Make sure that there is a place for one more.

    Places of people who are away are given up first, then one of who takes more than a share.

    Raises:
        NotObeyed: All places are of people who are here, and take no more than a share.
    """
    own = [member for member in hub.everybody() if member.account.id == account.id]
    if len(own) >= limits.CONNECTIONS:
        _give_up(hub, own, f"there are {len(own)} connections of this account")
    if len(room.members) < limits.PLACES or account.leads_in(room.id):
        return
    away = any(m.door is None and not _keeps(hub, m) for m in room.members.values())
    if away or not _end_one(hub, dict(room.members), address):
        _give_up(hub, room.members.values(), f"all {limits.PLACES} places of this room are taken")


def _give_up(hub: Hub, members: Iterable[Member], refusal: str) -> None:
    """Give up the place of who is away for longest, of the operator last."""
    away = [m for m in members if m.door is None]
    gone = min(away, key=lambda m: (_keeps(hub, m), m.away_since), default=None)
    if gone is None:
        raise NotObeyed("limit", refusal, "come back later")
    remove(hub, hub.rooms[gone.room], gone)


def _saw(hub: Hub, member: Member, stayed_s: float) -> None:
    """Keep when somebody was here: who uses a place does not lose it."""
    account, now = member.account.id, wall()
    hub.ways.entries.joined(account)
    hub.spawn(keep_soon(hub, lambda connection: saw(connection, account, now, stayed_s)))


def remove(hub: Hub, room: Room, member: Member) -> None:
    """Give up somebody's place."""
    room.members.pop(member.id, None)
    if room.control.hand_back(member.id, steady()):
        control_changed(hub, room)
    room.tell_people_soon()


def send_away(hub: Hub, member: Member, code: str, text: str) -> None:
    """End somebody's connection and place."""
    door = member.door
    if door is not None:
        door.send(text_frame(encode(Closed(code, text))))
        door.finish()
    member.door = None
    room = hub.rooms.get(member.room)
    if room is not None:
        remove(hub, room, member)


def log_out(hub: Hub, browsers: frozenset[bytes]) -> None:
    """End all places of a browser from which somebody has logged out."""
    for member in hub.everybody():
        if not member.browsers.isdisjoint(browsers):
            send_away(hub, member, "left", "you have logged out")


def _scenes(hub: Hub) -> tuple[SceneEntry, ...]:
    return tuple(SceneEntry(place.id, bool(place.task)) for place in hub.settings.places)


def room_for(hub: Hub, account: Account, wanted: str) -> Room:
    """Return the room that somebody enters who wants one, or any (the empty string).

    Raises:
        NotObeyed: They may not enter it, or there is none.
    """
    only = None if account.supervisor else account.room
    asked = hub.rooms.get(wanted)
    own = asked is not None and asked.is_own(account)
    if only is not None and wanted not in ("", only) and not own:
        raise NotObeyed("room", "this link is for another room")
    shared = (room for room in hub.rooms.values() if room.shared)
    free = (room.id for room in shared if account.id not in room.barred)
    id_ = wanted or only or next(free, next(iter(hub.rooms), ""))
    room = hub.rooms.get(id_)
    if room is None:
        raise NotObeyed("room", "there is no such room any more")
    if account.id in room.barred:
        raise NotObeyed("kicked", "the supervisor has sent you away from this room")
    if not room.shared and not may_enter(account, room):
        raise NotObeyed("room", "there is no such room any more")
    return room


def _returning(room: Room, account: Account, join: Join) -> Member | None:
    if not join.resume:
        return None
    for member in room.members.values():
        same = secrets.compare_digest(member.resume.encode(), join.resume.encode())
        if same and member.account.id == account.id:
            if member.door is not None:
                member.tell(Closed("replaced", "you came back elsewhere"))
                member.door.finish()
            return member
    return None
