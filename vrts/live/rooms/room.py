"""A room: the people in it, the control right, the session they share, and what they were told."""

import asyncio
from collections import Counter, deque
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final, Literal, NamedTuple

import msgspec
from msgspec import structs

from vrts.live.actions import Action
from vrts.live.door import binary_frame, text_frame
from vrts.live.lasting.clock import steady, wall
from vrts.live.looking.blocks import Blocks
from vrts.live.notices.kept import SOMEBODY
from vrts.live.protocol.coding import encode
from vrts.live.protocol.fields import Role
from vrts.live.protocol.from_server import (
    Chat,
    Control,
    Message,
    NoSession,
    Noted,
    Now,
    People,
    Stopped,
)
from vrts.live.protocol.listed import Person, RoomEntry
from vrts.live.rooms.control import ControlRight
from vrts.live.rooms.member import FULL_RATE, Member
from vrts.live.rooms.process import SessionProcess
from vrts.live.rooms.telling.audience import EVERYBODY, Audience
from vrts.live.rooms.telling.sent import Sent
from vrts.live.session.views.frame import unpacked
from vrts.live.store.accounts import Account
from vrts.live.store.bars import Bars
from vrts.live.store.branches import Branch
from vrts.live.store.course.own_rooms import OwnRoom
from vrts.live.store.progress import Reached
from vrts.live.store.rooms import HISTORY, KeptRoom

Rest = Literal["awake", "falling", "asleep", "waking"]  # whether it has a session, or had one
UNWATCHED: Final = 10  # pose frames a second of an arm that moves where nobody is
PANIC: Final = b'{"type":"panic"}'  # as the log has it


class Held(NamedTuple):
    """A command that is given when the session has woken."""

    kind: str
    member: Member
    of: int
    action: Action


class Asked(NamedTuple):
    """A command or question that the session has not answered yet."""

    kind: str
    person: str
    of: int
    account: int | None
    name: str
    action: bytes  # JSON; empty for questions


@dataclass(slots=True, eq=False)
class Room:
    """One of the server's rooms."""

    kept: KeptRoom
    number: int = 0  # last reliable number
    notes: list[Noted] = field(default_factory=list[Noted])  # of the session, in order
    came: set[int] = field(default_factory=set[int])  # accounts whose coming the log has
    session: int = 0
    process: SessionProcess | None = None
    wake: asyncio.Event = field(default_factory=asyncio.Event)  # what keeps it going is to look
    resting_in: str = ""  # folder of the session that is asleep
    woken: bool = False  # somebody wants it awake while it falls asleep
    held: list[Held] = field(default_factory=list[Held])  # commands until it is awake
    task: str = ""  # title
    offered: bool = True  # the server has its scene
    waits: NoSession | None = None  # for its supervisor, who has to choose; None: it does not
    frozen: bool = False
    logged: int = 0  # bytes of the log of the session
    log_full: bool = False  # that was told
    recorded: Counter[str] = field(default_factory=Counter[str])  # records that anybody can cause
    barred: Bars = field(default_factory=dict[int, str])  # who may not enter
    members: dict[str, Member] = field(default_factory=dict[str, Member])
    control: ControlRight = field(default_factory=ControlRight)
    chat: "deque[tuple[Chat, Audience]]" = field(default_factory=lambda: deque(maxlen=HISTORY))
    asked: dict[int, Asked] = field(default_factory=dict[int, Asked])
    joining: list[Member] = field(default_factory=list[Member])  # wait for a snapshot
    status: bytes = b""  # JSON of the last `Status`
    placed: dict[str, msgspec.Raw] = field(default_factory=dict[str, msgspec.Raw])  # by body
    pace: int = FULL_RATE  # pose frames a second that the session makes
    unheard: str = ""  # the last command that the session has not answered when it died
    stopped: Stopped | None = None  # by PANIC, and has not moved since
    stop_lasts: bool = False  # until a command: the session went on from its log, and still brakes
    halting: bool = False  # a panic is on its way
    panicked: float = 0.0  # when the last one came, of a clock that only goes on [s]
    frame: bytes = b""  # the last pose frame; empty: session time is another one since
    branch: Branch | None = None  # what makes it a private one
    empty_since: float | None = None  # since when nobody is in a private one [s]
    own: OwnRoom | None = None  # what makes it somebody's own, for the term
    owners: dict[int, str] = field(default_factory=dict[int, str])  # accounts whose own it is
    rest: Rest = "awake"
    used: float = 0.0  # when somebody did something in a room of their own [s]
    blocks: Blocks = field(default_factory=Blocks)  # of the session's past
    crowd_changed: float = 0.0  # since when people are to be told who is here; 0: they know
    sent: Sent = field(default_factory=Sent)

    @property
    def id(self) -> str:
        """What the room is called in messages."""
        return self.kept.id

    @property
    def entry(self) -> RoomEntry:
        """The room as a list of rooms shows it."""
        kept = self.kept
        entry = RoomEntry(kept.id, kept.name, kept.scene, self.task, self.crowd, self.offered)
        return entry if self.own is None else structs.replace(entry, own=self.whose)

    @property
    def variant(self) -> str:
        """Tag of the variant of its task that it has; empty: the task as it is written."""
        if self.branch is not None:
            return self.branch.variant
        own = self.own
        return own.variant if own is not None and own.assignment == self.kept.scene else ""

    @property
    def shared(self) -> bool:
        """Whether it is nobody's in particular."""
        return self.branch is None and self.own is None

    @property
    def asleep(self) -> bool:
        """Whether it has no session before somebody wakes it."""
        return self.rest == "asleep"

    @property
    def whose(self) -> str:
        """Whose own room it is, in words; empty: nobody's."""
        if self.own is None:
            return ""
        return self.own.team or next(iter(self.owners.values()), SOMEBODY)

    def is_own(self, account: Account) -> bool:
        """Return whether it is somebody's private room, or one of their own."""
        private = self.branch is not None and self.branch.owner == account.id
        return private or account.id in self.owners

    def lets_save(self, account: Account) -> bool:
        """Return whether somebody may save programs for all who are here: who may command."""
        holder = self.members.get(self.control.holder)
        operates = holder is not None and holder.account.id == account.id
        return account.leads_in(self.id) or operates or self.is_own(account)

    @property
    def crowd(self) -> int:
        """How many people are here; some have several pages open."""
        return len({member.account.id for member in self.members.values()})

    @property
    def reached(self) -> Reached | None:
        """How far the session has come; None: that is not known now."""
        return Reached(self.id, self.session, unpacked(self.frame).time_s) if self.frame else None

    @property
    def scene_url(self) -> str:
        """Where the scene can be fetched; empty while the session begins."""
        ready = self.process is not None and self.process.ready
        ready = ready or self.rest in ("falling", "asleep")
        return f"/scene/{self.id}/{self.session}" if ready else ""

    # --- telling ---------------------------------------------------------------------------------

    def pose(self, payload: bytes, now: float) -> None:
        """Pass a pose frame on to those for whom one is due."""
        self.frame = payload
        frame = binary_frame(payload)
        for member in self.members.values():
            member.pose(frame, now, self.pace)

    @property
    def seldom(self) -> bool:
        """Whether fewer frames will do at rest: in robots of their own, and where nobody is."""
        return self.own is not None or not any(m.door for m in self.members.values())

    def set_pace(self) -> None:
        """Have as many pose frames made as the fastest wants, few where nobody looks."""
        wanted = [m.rate for m in self.members.values() if m.door is not None]
        pace = max(FULL_RATE, *wanted) if wanted else UNWATCHED
        seldom, process = self.seldom, self.process
        if process is not None and process.ready and (pace, seldom) != (self.pace, process.seldom):
            self.pace = pace
            process.set_pace(pace, seldom=seldom)

    def forget(self, name: str) -> None:
        """Forget what somebody said who was purged."""
        kept = [
            (structs.replace(line, to="") if line.to == name else line, to)
            for line, to in self.chat
            if line.name != name
        ]
        self.notes = [note for note in self.notes if note.name != name]
        if self.stopped is not None and self.stopped.name == name:
            self.stopped = structs.replace(self.stopped, name=SOMEBODY)
            self.show(self.stopped)
        self.have_said(kept)

    def have_said(self, lines: list[tuple[Chat, Audience]]) -> None:
        """Have only some lines been said; who comes back is told everything again."""
        self.chat.clear()
        self.chat.extend(lines)
        self.sent.forget_all()

    def next_number(self) -> int:
        """Return the number of the reliable message that is sent next."""
        self.number += 1
        return self.number

    def tell(self, message: Message, number: int, to: Audience = EVERYBODY) -> None:
        """Send a reliable message, and remember it for those who come back."""
        frame = text_frame(encode(message))
        self.sent.add(number, to, frame, steady())
        for member in self.audience(to):
            member.send(frame)

    def show(self, message: Message, to: Audience = EVERYBODY) -> None:
        """Send a state, which a later one replaces."""
        frame = text_frame(encode(message))
        for member in self.audience(to):
            member.send(frame)

    def show_status(self, status: bytes) -> None:
        """Pass the session's status on, latest value wins."""
        self.status = status
        frame = text_frame(encode(Now(msgspec.Raw(status))))
        for member in self.members.values():
            if member.door is not None and member.settled:
                member.door.latest("now", frame)

    def audience(self, to: Audience) -> Iterable[Member]:
        """Return who is meant."""
        everybody = self.members.values()
        return everybody if to.everybody else [m for m in everybody if to.includes(m)]

    def chat_for(self, member: Member) -> tuple[Chat, ...]:
        """Return the history of the chat that somebody may read."""
        return tuple(line for line, to in self.chat if to.includes(member))

    # --- the session ------------------------------------------------------------------------------

    def ask(self, ref: int, kind: str, member: Member, of: int, action: bytes = b"") -> None:
        """Remember who waits for an answer of the session."""
        account = member.account
        self.asked[ref] = Asked(kind, member.id, of, account.id, account.name, action)

    def panic(self, member: Member) -> None:
        """Pass a panic on at once; while one is on its way, another would change nothing."""
        self.panicked = steady()
        ready = self.process is not None and self.process.ready
        if self.process is not None and ready and not self.halting and self.rest == "awake":
            self.halting = True
            self.ask(self.process.halt(), "panic", member, 0, PANIC)

    # --- states ----------------------------------------------------------------------------------

    def show_control(self) -> None:
        """Tell everybody who has the control right, and the holder the lease."""
        for_all = text_frame(encode(self.control_for(None)))
        for member in self.members.values():
            if member.id == self.control.holder:
                member.send(text_frame(encode(self.control_for(member))))
            else:
                member.send(for_all)

    def control_for(self, member: Member | None) -> Control:
        """Return the state of the control right as somebody may know it."""
        control = self.control
        holds = member is not None and member.id == control.holder
        return Control(
            holder=control.holder,
            lease=control.lease if holds else "",
            queue=tuple(control.queue),
            locked=control.locked,
            frozen=self.frozen,
            chat=self.kept.chat,
            turn_s=control.turn_s,
            idle_s=control.idle_s,
            ends=_shown(control.ends()),
        )

    def show_waits(self, waits: NoSession | None) -> None:
        """Tell everybody why there is no session, or that one comes."""
        self.waits = waits
        for member in self.members.values():
            member.send(text_frame(encode(self.waits_for(member))))

    def waits_for(self, member: Member) -> NoSession:
        """Return what somebody may know of why there is no session."""
        waits = self.waits or NoSession()
        chooses = member.supervisor or self.asleep or member.account.id in self.owners
        return waits if chooses else NoSession(waits.why)

    def tell_people_soon(self) -> None:
        """Have everybody told soon who is here."""
        self.crowd_changed = self.crowd_changed or steady()

    def show_people(self, muted: Bars) -> None:
        """Tell everybody who is here."""
        self.crowd_changed = 0.0
        with_rates, without = (
            text_frame(encode(self.people(muted, rates=rates))) for rates in (True, False)
        )
        for member in self.members.values():
            if member.account.supervisor or not member.supervisor:
                member.send(with_rates if member.supervisor else without)
            else:  # who leads some rooms does not learn who is not heard elsewhere
                here = {one.account.id for one in self.members.values()}
                few = {account: name for account, name in muted.items() if account in here}
                member.send(text_frame(encode(self.people(few, rates=True))))

    def people(self, muted: Bars, *, rates: bool) -> People:
        """Return who is here; `rates`: with what only supervisors are told."""
        return People(
            tuple(
                Person(
                    member.id,
                    member.account.name,
                    self.role(member),
                    member.hand or self.has_hand_of(member.account),
                    member.account.id in muted,
                    member.door is None,
                    member.rate if rates else 0,
                )
                for member in self.members.values()
            ),
            tuple(sorted(set(self.barred.values()))) if rates else (),
            tuple(sorted(set(muted.values()))) if rates else (),
        )

    def has_hand_of(self, account: Account) -> bool:
        """Return whether somebody has raised a hand in a room of their own."""
        return self.own is not None and self.own.hand_at > 0.0 and self.own.hand_by == account.id

    def role_of(self, person: str) -> Role | None:
        """Return what somebody may do here, None when they are gone."""
        member = self.members.get(person)
        return None if member is None else self.role(member)

    def role(self, member: Member) -> Role:
        """Return what somebody may do here."""
        if member.supervisor:
            return "supervisor"
        return "operator" if member.id == self.control.holder else "viewer"


def _shown(ends: float) -> float:
    """Return when a turn ends as browsers are told it: Unix time [s]; 0: it is open."""
    return wall() + ends - steady() if ends else 0.0
