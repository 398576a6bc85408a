"""Messages of everybody in a room, and of its operator: authorised here, then obeyed.

Hiding a button is not security: whatever a browser sends, this decides by the account's role and
by who holds the control right.
"""

from vrts.live.actions import Action, Keep, LetGo, Reset, Rewind, Save, Typed, Upload
from vrts.live.lasting.clock import steady
from vrts.live.names import readable
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_anybody import (
    AskProgram,
    AskReach,
    Command,
    GoOnFrom,
    HandBack,
    Join,
    Note,
    Noticed,
    Panic,
    Point,
    RaiseHand,
    RequestControl,
    Say,
    SetRate,
    Wake,
)
from vrts.live.protocol.from_clients import FromClient
from vrts.live.protocol.from_server import Branched
from vrts.live.protocol.from_supervisors import GoOn, LowerHand, SetScene
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.keeping import LOG_FULL, LOG_HELP, control_changed, say
from vrts.live.rooms.member import Member
from vrts.live.rooms.noting import put_note
from vrts.live.rooms.own.hands import leads, lower_hand, point, raise_hand
from vrts.live.rooms.own.sleeping import COMES
from vrts.live.rooms.private.branching import branch, end_earlier
from vrts.live.rooms.process import SessionProcess
from vrts.live.rooms.resting.falling import hold
from vrts.live.rooms.room import Held, Room
from vrts.live.rooms.sessions import Sessions
from vrts.live.rooms.supervising import supervise
from vrts.live.rooms.telling.audience import EVERYBODY, Audience

_WHY = {
    "role": ("you do not have the control right", "ask for it, or wait for your turn"),
    "lease": ("this was sent under an earlier control right", ""),
    "replayed": ("this command was sent before", "each needs a greater number"),
}


async def obey(hub: Hub, sessions: Sessions, member: Member, message: FromClient) -> None:
    """Do what a message asks for.

    Raises:
        NotObeyed: The sender may not ask for it, or it cannot be done.
    """
    room = hub.rooms.get(member.room)
    if room is None:
        raise NotObeyed("room", "the room was closed")
    now = steady()
    if isinstance(message, Panic):
        _panic(room, member)
        return
    if not member.messages.take(now):
        member.excess += 1
        raise NotObeyed("rate", "too many messages at once", "slow down")
    if not isinstance(message, SetRate | Noticed):
        room.used = now
    match message:
        case Command():
            _command(hub, sessions, room, member, message, now)
        case Join():
            raise NotObeyed("joined", "this connection has joined already")
        case SetRate():
            member.rate = message.rate
            room.tell_people_soon()
        case RequestControl():
            _ask_for_control(hub, room, member, now)
        case HandBack():
            if room.control.hand_back(member.id, now):
                control_changed(hub, room)
        case RaiseHand() if room.own is not None:
            await raise_hand(hub, room, member, up=message.up, text=message.text)
        case RaiseHand():
            member.hand = message.up
            room.tell_people_soon()
        case Wake():
            if hub.sleeping is not None:
                hub.sleeping.wake(room, member.account)
        case Point():
            point(room, member, message.body)
        case LowerHand():
            helped = hub.rooms.get(message.room)
            if helped is None or not leads(member.account, helped):
                raise NotObeyed("role", "only those who lead the room take a hand down")
            await lower_hand(hub, helped)
        case Say():
            await _say(hub, room, member, message, now)
        case Noticed():
            if hub.announcement is not None and hub.announcement.id == message.id:
                hub.announcement.noticed(member.account.id, closed=message.closed)
        case Note():
            put_note(hub, room, member, message.text, now)
        case AskReach():
            _ask_reach(room, member, message, now)
        case AskProgram():
            _ask_program(room, member, message, now)
        case GoOnFrom():
            if not member.programs.take(now):
                raise NotObeyed("rate", "too many rooms at once", "wait a few seconds")
            made = await branch(hub, sessions, member, message.at_s)
            member.tell(Branched(message.of, made.id))
            await end_earlier(hub, member.account, made)
        case _:
            begins = isinstance(message, SetScene | GoOn) and member.account.id in room.owners
            if not (member.supervisor or begins):
                raise NotObeyed("role", "only a supervisor may do this")
            await supervise(hub, sessions, room, member, message)


def _wake(hub: Hub, sessions: Sessions, room: Room, member: Member) -> None:
    """Have a room that sleeps, or is about to, go on for a command.

    Raises:
        NotObeyed: It cannot now: its commands do not wait then.
    """
    if room.own is not None and hub.sleeping is not None:
        hub.sleeping.wake(room, member.account)
        if room.asleep:  # there is no place for one more that is awake
            raise NotObeyed("asleep", "" if room.waits is None else room.waits.why, COMES)
    sessions.wake(room)


def _ask_for_control(hub: Hub, room: Room, member: Member, now: float) -> None:
    if member.id in (room.control.holder, *room.control.queue):
        return
    if not hub.turns.take(member.account.id, now):
        raise NotObeyed("rate", "you ask for control too often", "wait a few seconds")
    if room.control.request(member.id, now):
        control_changed(hub, room)


def may_panic(room: Room, member: Member) -> bool:
    """Return whether somebody may stop the arm."""
    return member.id == room.control.holder or member.supervisor


def _panic(room: Room, member: Member) -> None:
    if not may_panic(room, member):
        raise NotObeyed("role", "panic is for the operator and the supervisor")
    room.panic(member)


def _command(
    hub: Hub, sessions: Sessions, room: Room, member: Member, message: Command, now: float
) -> None:
    action = message.action
    why = room.control.accept(member.id, message.lease, message.number, now)
    if why:
        raise NotObeyed(why, *_WHY[why])
    if room.frozen:
        raise NotObeyed("frozen", "the supervisor has frozen the room")
    if room.control.locked:
        raise NotObeyed("locked", "the supervisor has locked the control right")
    may_reset = member.supervisor or hub.settings.alone or hub.settings.students_reset
    may_reset = may_reset or room.is_own(member.account)
    if isinstance(action, Reset | Rewind) and not may_reset:
        raise NotObeyed("role", "only a supervisor may reset or rewind")
    if isinstance(action, Upload | Save) and not member.programs.take(now):
        raise NotObeyed("rate", "too many files at once", "wait a few seconds")
    if isinstance(action, Typed) and not action.line.isprintable():
        raise NotObeyed("line", "a line has only visible characters")
    if hub.journal.problem and not _stops(action):
        raise NotObeyed("disk", NO_DISK, DISK_HELP)
    if room.logged > hub.settings.log_quota and not _stops(action):
        raise NotObeyed("log", LOG_FULL, LOG_HELP)
    kind = "keep" if isinstance(action, Keep) else str(action.__struct_config__.tag)
    if room.rest != "awake":
        _wake(hub, sessions, room, member)
        hold(room, Held(kind, member, message.number, action))
        return
    process = _running(room)
    ref = process.act(f"p{member.account.id}", action)
    room.ask(ref, kind, member, message.number, encode(action))


def _stops(action: Action) -> bool:
    """Return whether an action only stops what moves."""
    if isinstance(action, Typed):
        return action.line.strip().upper() in ("PANIC", "ABORT")
    return isinstance(action, LetGo)


async def _say(hub: Hub, room: Room, member: Member, message: Say, now: float) -> None:
    if not room.kept.chat and not (member.supervisor or message.private):
        raise NotObeyed("chat", "chat is off", "write to the supervisor privately")
    if member.account.id in hub.muted:
        raise NotObeyed("muted", "the supervisor has muted you")
    if not member.chat.take(now):
        raise NotObeyed("rate", "too many lines at once", "wait a few seconds")
    text = readable(message.text)
    if not text:
        return
    if message.to and not member.supervisor:
        raise NotObeyed("role", "private messages go to the supervisor")
    if message.to:
        other = room.members.get(message.to)
        if other is None:
            raise NotObeyed("person", "they are not here any more")
        ends = frozenset((other.account.id, member.account.id))
        to = Audience(accounts=ends, supervisors=True)
        await say(hub, room, member, text, to, other.account)
    elif message.private:
        to = Audience(accounts=frozenset((member.account.id,)), supervisors=True)
        await say(hub, room, member, text, to, None)
    else:
        await say(hub, room, member, text, EVERYBODY, None)


def _ask_reach(room: Room, member: Member, message: AskReach, now: float) -> None:
    if not member.questions.take(now):
        raise NotObeyed("rate", "too many questions at once")
    process = _running(room)
    position, oat = message.position_m, message.oat_rad
    ref = process.ask_reach(position, oat, straight=message.straight, asker=member.id)
    room.ask(ref, "reach", member, message.of)


def _ask_program(room: Room, member: Member, message: AskProgram, now: float) -> None:
    if not member.programs.take(now):
        raise NotObeyed("rate", "too many programs at once", "wait a few seconds")
    ref = _running(room).ask_program(message.name)
    room.ask(ref, "program", member, message.of)


def _running(room: Room) -> SessionProcess:
    process = room.process
    if process is None or not process.ready:
        raise NotObeyed("session", "the session is not ready yet", "wait a moment")
    if process.behind:
        raise NotObeyed("busy", "the session has not read what it was told yet", "wait a moment")
    return process
