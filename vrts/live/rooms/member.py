"""Somebody in a room: one place, which outlasts a dropped connection for a while."""

from dataclasses import dataclass, field

from vrts.live import limits
from vrts.live.door import Door, text_frame
from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Message
from vrts.live.store.accounts import Account
from vrts.live.tokens import new_id, new_token

FULL_RATE = 50  # pose frames a second that a session makes unless somebody wants more


@dataclass(slots=True, eq=False)
class Member:
    """A place in a room."""

    account: Account
    room: str
    rate: int = FULL_RATE
    id: str = field(default_factory=new_id)
    resume: str = field(default_factory=new_token)
    door: Door | None = None  # None: away
    browsers: frozenset[bytes] = frozenset()  # digests by which the browser is known
    settled: bool = False  # has been sent a snapshot, and gets what is new
    seen: int | None = None  # number after which a returning client is told what it missed
    away_since: float = 0.0
    since: float = field(default_factory=steady)  # when there was this place first [s]
    came: float = 0.0  # when the connection began, of a clock that only goes on [s]
    address: str = ""  # from where the connection comes; never kept
    heard: float = 0.0  # when it last said something
    hand: bool = False
    wall: bool = False  # watches the wall
    due: float = 0.0  # when the next pose frame is due
    bad: int = 0  # messages that could not be read
    excess: int = 0  # messages beyond the limits
    messages: Bucket = field(default_factory=lambda: Bucket(*limits.MESSAGES))
    chat: Bucket = field(default_factory=lambda: Bucket(*limits.CHAT))
    questions: Bucket = field(default_factory=lambda: Bucket(*limits.QUESTIONS))
    looks: Bucket = field(default_factory=lambda: Bucket(*limits.LOOKS))
    programs: Bucket = field(default_factory=lambda: Bucket(*limits.PROGRAMS))

    @property
    def supervisor(self) -> bool:
        """Whether they lead this room: in it they may do what a supervisor may."""
        return self.account.leads_in(self.room)

    def share(self, other: "Member") -> None:
        """Share what one account may ask for with another place of it."""
        self.chat, self.questions = other.chat, other.questions
        self.looks, self.programs = other.looks, other.programs

    def send(self, frame: bytes) -> None:
        """Send a reliable frame, if there is somebody and they have their snapshot."""
        if self.door is not None and self.settled:
            self.door.send(frame)

    def tell(self, message: Message) -> None:
        """Send a message to the connection, if there is one, whatever was sent before."""
        if self.door is not None:
            self.door.send(text_frame(encode(message)))

    def pose(self, frame: bytes, now: float, made: int) -> None:
        """Send a pose frame if one is due; `made` are a second."""
        if self.door is None or not self.settled:
            return
        if self.rate < made:
            if now < self.due:
                return
            period = 1.0 / self.rate
            self.due = max(self.due + period, now)  # frames come when they come
        self.door.latest("pose", frame)
