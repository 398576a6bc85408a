"""What a supervisor may do besides: people, control right, rooms, scenes, the wall, logs."""

import contextlib

from vrts.live.lasting.clock import steady, wall
from vrts.live.names import display_name, readable
from vrts.live.notices.announcement import next_announcement
from vrts.live.notices.kept import EVERYWHERE, KeptNotice
from vrts.live.protocol.from_server import LogFile
from vrts.live.protocol.from_supervisors import (
    Allow,
    Broadcast,
    CloseRoom,
    EndAnnouncement,
    ExportLog,
    Freeze,
    GoOn,
    HandOver,
    Kick,
    Lock,
    MakeRooms,
    Mute,
    Project,
    SetChat,
    SetScene,
    SetTurn,
    Unmute,
    WatchWall,
)
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import send_away
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import control_changed, keep_notice_soon, record, say
from vrts.live.rooms.member import Member
from vrts.live.rooms.opening import change, close, make_room
from vrts.live.rooms.room import Room
from vrts.live.rooms.sessions import Sessions
from vrts.live.rooms.telling.audience import EVERYBODY
from vrts.live.store.bars import allow, bar, mute, same_browser, unmute
from vrts.live.store.database import Connection
from vrts.live.store.waiting.journal import NO_ROOM

Supervision = (
    HandOver
    | Lock
    | Freeze
    | Kick
    | Allow
    | Mute
    | Unmute
    | SetChat
    | SetTurn
    | SetScene
    | GoOn
    | MakeRooms
    | CloseRoom
    | Broadcast
    | EndAnnouncement
    | WatchWall
    | Project
    | ExportLog
)


async def supervise(
    hub: Hub, sessions: Sessions, room: Room, member: Member, message: Supervision
) -> None:
    """Do what a supervisor asks for; that they lead this room was made sure of.

    Raises:
        NotObeyed: It reaches beyond what they lead, or cannot be done.
    """
    _within(member, message)
    match message:
        case HandOver() | Lock() | Freeze():
            _control(hub, room, member, message)
        case Kick():
            await _kick(hub, room, member, message)
        case Allow():
            await hub.database.do(lambda connection: allow(connection, room.id, message.name))
            room.barred = {a: name for a, name in room.barred.items() if name != message.name}
            record(hub, room, "allow", member.account, {"name": message.name})
            room.tell_people_soon()
            hub.rooms_changed()
        case Mute():
            await _mute(hub, _person(room, message.person), on=message.on)
        case Unmute():
            await _unmute(hub, message.name)
        case SetChat():
            await change(hub, room, room.kept._replace(chat=message.on))
            room.show_control()
        case SetTurn():
            kept = room.kept._replace(turn_s=message.turn_s, idle_s=message.idle_s)
            await change(hub, room, kept)
            room.show_control()
        case SetScene():
            await _set_scene(hub, sessions, room, member, message.scene)
        case GoOn():
            await sessions.go_on(room, member, without_last=message.without_last)
        case MakeRooms():
            await _make_rooms(hub, sessions, message)
        case CloseRoom():
            closed = _room(hub, message.room)
            shared = [room for room in hub.rooms.values() if room.shared]
            if shared == [closed]:
                help_ = "begin again in it, or make another one first"
                raise NotObeyed("room", "the last room stays open", help_)
            record(hub, closed, "close", member.account, {})
            await close(hub, closed)
        case Broadcast():
            await _broadcast(hub, sessions, member, message)
        case EndAnnouncement():
            hub.announcement = None
            hub.show_announcement()
            keep_notice_soon(hub, EVERYWHERE, None)
        case WatchWall():
            member.wall = message.on
        case Project():
            shown = _room(hub, message.room)
            if shown.own is not None:
                raise NotObeyed("room", "a robot of somebody's own is not shown to all")
            hub.projector = shown.id
            hub.rooms_changed()
        case ExportLog():
            url = f"/log/{_room(hub, message.room).id}"
            member.tell(LogFile(message.of, url))


def _within(member: Member, message: Supervision) -> None:
    """Make sure that what an assistant asks for stays in the rooms that they lead.

    Raises:
        NotObeyed: It does not.
    """
    account = member.account
    if account.supervisor:
        return
    match message:
        case Mute() | Unmute():
            help_ = "turn the chat off here, or send them away from this room"
            raise NotObeyed("role", "a muted person is not heard in any room: ask a teacher", help_)
        case MakeRooms() | Broadcast() | EndAnnouncement() | Project():
            raise NotObeyed("role", "this is for all rooms: ask a teacher")
        case Freeze(everywhere=True):
            raise NotObeyed("role", "you lead some rooms only: freeze them one by one")
        case CloseRoom(room=room) | ExportLog(room=room) if not account.leads_in(room):
            raise NotObeyed("role", "you do not lead that room")
        case _:
            pass


def _control(hub: Hub, room: Room, member: Member, message: HandOver | Lock | Freeze) -> None:
    now = steady()
    match message:
        case HandOver():
            to = _person(room, message.person) if message.person else None
            if to is None:
                room.control.release(now)
            else:
                room.control.hand_over(to.id, now)
            record(hub, room, "hand_over", member.account, {"to": to and to.account.id})
            control_changed(hub, room)
        case Lock():
            record(hub, room, "lock", member.account, {"on": message.on})
            if message.on:
                room.control.locked = True
            else:
                room.control.unlock(now)
            control_changed(hub, room)
        case Freeze():
            for frozen in hub.rooms.values() if message.everywhere else (room,):
                frozen.frozen = message.on
                record(hub, frozen, "freeze", member.account, {"on": message.on})
                if message.on:
                    frozen.panic(member)
                frozen.show_control()


async def _kick(hub: Hub, room: Room, member: Member, message: Kick) -> None:
    account = _person(room, message.person).account
    if account.leads_in(room.id):
        raise NotObeyed("role", "a supervisor cannot be sent away")

    def work(connection: Connection) -> set[int]:
        found = same_browser(connection, account.id)
        for one in found:
            bar(connection, room.id, one, account.name)
        return found

    sent_away = await hub.database.do(work)
    room.barred.update(dict.fromkeys(sent_away, account.name))
    record(hub, room, "kick", member.account, {"whom": account.id})
    for other in list(room.members.values()):
        if other.account.id in sent_away:
            send_away(hub, other, "kicked", "the supervisor has sent you away from this room")


async def _mute(hub: Hub, person: Member, *, on: bool) -> None:
    account = person.account
    if not on:
        await _unmute(hub, hub.muted.get(account.id, account.name))
        return
    if account.leads_any:
        raise NotObeyed("role", "a supervisor cannot be muted")

    def work(connection: Connection) -> set[int]:
        found = same_browser(connection, account.id)
        for one in found:
            mute(connection, one, account.name)
        return found

    hub.muted.update(dict.fromkeys(await hub.database.do(work), account.name))
    _tell_people(hub)


async def _unmute(hub: Hub, name: str) -> None:
    await hub.database.do(lambda connection: unmute(connection, name))
    for account in [account for account, as_ in hub.muted.items() if as_ == name]:
        del hub.muted[account]
    _tell_people(hub)


def _tell_people(hub: Hub) -> None:
    for room in hub.rooms.values():
        room.tell_people_soon()


async def _set_scene(hub: Hub, sessions: Sessions, room: Room, member: Member, scene: str) -> None:
    _known(hub, scene)
    if room.own is not None and scene != room.kept.scene:
        raise NotObeyed("scene", "a robot of somebody's own keeps its scene", "open another one")
    await change(hub, room, room.kept._replace(scene=scene))
    record(hub, room, "scene", member.account, {"scene": scene})
    sessions.begin_anew(room)


async def _make_rooms(hub: Hub, sessions: Sessions, message: MakeRooms) -> None:
    names = [display_name(wanted.name) for wanted in message.rooms]
    if not all(names):
        raise NotObeyed("name", "a name needs a letter or a digit")
    for wanted in message.rooms:
        _known(hub, wanted.scene)
    for name, wanted in zip(names, message.rooms, strict=True):
        sessions.begin(await make_room(hub, name, wanted.scene))
    hub.rooms_changed()


async def _broadcast(hub: Hub, sessions: Sessions, member: Member, message: Broadcast) -> None:
    text = readable(message.text)
    if text:
        name = member.account.name
        told = next_announcement(hub.announcement, wall(), name, text)
        told.account = member.account.id
        kept = KeptNotice(EVERYWHERE, told.id, told.at, told.account, name, text)
        hub.announcement = told
        hub.show_announcement()
        keep_notice_soon(hub, EVERYWHERE, kept)
    for room in [room for room in hub.rooms.values() if room.own is None]:
        if text:
            with contextlib.suppress(NO_ROOM):  # all see it: it need not be in the chat as well
                await say(hub, room, member, text, EVERYBODY, None)
        if message.scene:
            await _set_scene(hub, sessions, room, member, message.scene)


def _known(hub: Hub, scene: str) -> None:
    if hub.settings.place(scene) is None:
        raise NotObeyed("scene", f"there is no scene `{readable(scene)}` in the set")


def _person(room: Room, id_: str) -> Member:
    found = room.members.get(id_)
    if found is None:
        raise NotObeyed("person", "they are not here any more")
    return found


def _room(hub: Hub, id_: str) -> Room:
    found = hub.rooms.get(id_)
    if found is None:
        raise NotObeyed("room", "there is no such room any more")
    return found
