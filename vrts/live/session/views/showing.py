"""What clients are shown of a session: news of each beat, and everything at once."""

from collections import deque

from msgspec import Struct

from vrts.check.rules.scheme import TOTAL
from vrts.engine.memory.events import Answered, Event, ProgramEnded, ProgramStarted, Prompted
from vrts.ir.entry import entry_among
from vrts.live.session.channel.messages import (
    Happened,
    Json,
    Marked,
    Moved,
    News,
    Output,
    Programs,
    Snapshot,
    Status,
)
from vrts.live.session.channel.rows import HandPlace, ProgramEntry
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.operator.conversation import Conversation
from vrts.live.session.operator.held_key import HeldKey
from vrts.live.session.views.frame import packed
from vrts.live.session.views.status import (
    Placements,
    location,
    mode,
    pose_frame,
    step_under_way,
    tool,
)
from vrts.monitor.desk import ALONE
from vrts.monitor.programs import StoredProgram
from vrts.report.event_words import event_text

STATUS_PAUSE = 0.1  # [s] between states at least
MOST_EVENTS_A_BEAT = 50  # rows; a program may write and signal at will
MOST_OUTPUT_A_BEAT = 8_000  # characters
EVENTS_KEPT = 200
OUTPUT_KEPT = 20_000  # characters
CONTACTS_KEPT = 250  # rows of contacts, and of near misses: so many first ones, and last ones


class Shown(Struct, frozen=True):
    """What was told, as far as it is not told again by what there is now."""

    events: tuple[Happened, ...]
    output: str
    alone: bool
    prompt: str | None
    contacts: tuple[Json, ...]
    near: tuple[Json, ...]
    forgotten: int
    checked_s: float
    marked: Marked | None


class Showing:
    """Hears what happens and tells it once."""

    def __init__(
        self, growing: GrowingRun, conversation: Conversation, key: HeldKey, session: int
    ) -> None:
        """Begin with what there is."""
        self._growing = growing
        self._conversation = conversation
        self._key = key
        self._session = session
        self._placements = Placements(growing)
        self._events: deque[Happened] = deque(maxlen=EVENTS_KEPT)
        self._fresh: list[Happened] = []
        self._more: list[News] = []
        self._output = ""  # the end of it
        self._alone = False  # what executes is a single instruction
        self._said = ""  # since the last beat
        self._prompt: str | None = None
        self._status: Status | None = None
        self._status_s = -1.0
        self._programs: tuple[StoredProgram, ...] = ()
        self.contacts: list[Json] = []
        self.near: list[Json] = []
        self.forgotten = 0  # contacts between the first and the last ones
        self.places: tuple[HandPlace, ...] = ()
        self.checked_s = 0.0
        self.marked: Marked | None = None
        self.task: Json | None = None  # what is shown of it
        self.total = float(TOTAL)

    def put_away(self) -> Shown:
        """Return what was told, for one that goes on elsewhere."""
        return Shown(
            tuple(self._events),
            self._output,
            self._alone,
            self._prompt,
            tuple(self.contacts),
            tuple(self.near),
            self.forgotten,
            self.checked_s,
            self.marked,
        )

    def take_back(self, shown: Shown) -> None:
        """Have told what another one has told."""
        self._placements = Placements(self._growing)
        self._events.extend(shown.events)
        self._output, self._alone, self._prompt = shown.output, shown.alone, shown.prompt
        self.contacts[:], self.near[:] = shown.contacts, shown.near
        self.forgotten, self.checked_s, self.marked = (
            shown.forgotten,
            shown.checked_s,
            shown.marked,
        )
        self._programs = tuple(self._conversation.monitor.desk.programs.values())

    # --- what happens -------------------------------------------------------------------------

    def hear(self) -> None:
        """Take the events whose time has come."""
        events = self._growing.news()
        if events:
            for event in events:
                if isinstance(event, Prompted):
                    self._conversation.asks = True
                elif isinstance(event, Answered | ProgramEnded):
                    self._conversation.asks = False
            self.say(self._conversation.told(events))
            for event in events:
                self._note(event)
        for said in (self._key.said, self._growing.said):
            for text in said:
                self._row(Happened(self._growing.time_s, "note", text))
            said.clear()

    def say(self, text: str) -> None:
        """Let the terminal show a text."""
        self._said += text

    def tell(self, news: News) -> None:
        """Send something with the next beat."""
        self._more.append(news)

    def forget_contacts(self) -> None:
        """Forget contacts and near misses but the first and last ones: some programs never end.

        The first are those that a task with a time limit counts.
        """
        self.forgotten += max(len(self.contacts) - 2 * CONTACTS_KEPT, 0)
        for rows in (self.contacts, self.near):
            if len(rows) > 2 * CONTACTS_KEPT:
                del rows[CONTACTS_KEPT:-CONTACTS_KEPT]

    def jumped(self) -> None:
        """Forget what was told: session time is another one."""
        self._placements = Placements(self._growing)
        self._events.clear()
        self._fresh.clear()
        self._status = None
        self._status_s = -1.0
        time_s = self._growing.time_s
        self.contacts = [row for row in self.contacts if _start(row) <= time_s]
        self.near = [row for row in self.near if _start(row) <= time_s]
        self.checked_s = min(self.checked_s, time_s)
        if self.forgotten and len(self.contacts) <= CONTACTS_KEPT:  # they are looked for again
            self.forgotten = 0
            self.checked_s = min([self.checked_s, *map(_start, self.contacts[-1:])])
        self.marked = None

    @property
    def mark(self) -> float | None:
        """The public mark; None: no task, or not judged yet."""
        return None if self.marked is None else self.marked.mark

    def tell_again(self) -> None:
        """Have the state told with the next beat, though nothing has changed."""
        self._status, self._status_s = None, -1.0

    def _note(self, event: Event) -> None:
        if isinstance(event, ProgramStarted) and not event.process:
            self._alone = event.program == ALONE
        comes_and_goes = isinstance(event, ProgramStarted | ProgramEnded) and not event.process
        row = event_text(event)
        if row is None or (self._alone and comes_and_goes):
            return
        cause = event.cause
        program = "" if cause is None or cause.program == ALONE else cause.program
        self._row(Happened(event.time_s, *row, program, cause.step if program and cause else 0))

    def _row(self, row: Happened) -> None:
        self._events.append(row)
        if len(self._fresh) < MOST_EVENTS_A_BEAT:
            self._fresh.append(row)

    # --- what is told -------------------------------------------------------------------------

    def frame(self, sequence: int) -> bytes:
        """Return the pose frame of now."""
        return packed(pose_frame(self._growing, self._session, sequence))

    def news(self) -> list[News]:
        """Return what is new since the last beat."""
        time_s = self._growing.time_s
        found: list[News] = [*self._fresh, *self._more]
        self._fresh.clear()
        self._more.clear()
        bodies = self._placements.news()
        if bodies:
            found.append(Moved(time_s, bodies))
        prompt = self._conversation.prompt
        if self._said or prompt != self._prompt:
            text = self._said
            if len(text) > MOST_OUTPUT_A_BEAT:
                text = f"{text[:MOST_OUTPUT_A_BEAT]}\n(more was written than can be shown)\n"
            self._output = (self._output + text)[-OUTPUT_KEPT:]
            self._said, self._prompt = "", prompt
            found.append(Output(time_s, text, prompt))
        programs = tuple(self._conversation.monitor.desk.programs.values())
        if programs != self._programs:
            self._programs = programs
            found.append(Programs(_entries(programs)))
        if time_s - self._status_s >= STATUS_PAUSE:
            status = self.status()
            if self._status is None or _differs(status, self._status):
                self._status, self._status_s = status, time_s
                found.append(status)
        return found

    def status(self) -> Status:
        """Return the state of now."""
        growing = self._growing
        system, robot = growing.machine.system, growing.machine.robot
        cause = step_under_way(growing)
        named = robot.program if robot.program != ALONE else ""
        stored = self._conversation.monitor.desk.programs.get(cause.program) if cause else None
        step = cause.step if cause is not None and stored is not None else 0
        known = stored is not None and 0 < step <= len(stored.lines)
        return Status(
            time_s=growing.time_s,
            joints_rad=tuple(round(q, 6) for q in growing.configuration),
            location=location(growing),
            hand_m=round(growing.opening, 6),
            program=named,
            mode=mode(growing, jogging=self._key.active),
            step=step,
            line=step if known else 0,
            text=stored.lines[step - 1].strip() if stored is not None and known else "",
            speed=round(100.0 * system.planner.scale.rate, 3),
            signals=tuple(sorted(system.signals.on)),
            held=system.hand.held or "",
            prompt=self._conversation.prompt,
            contacts=self.forgotten + len(self.contacts),
            checked_s=self.checked_s,
            mark=self.mark,
            tool=tool(growing),
            total=self.total,
        )

    def snapshot(self, ref: int) -> Snapshot:
        """Return everything."""
        return Snapshot(
            ref,
            self.status(),
            self._placements.now,
            _entries(tuple(self._conversation.monitor.desk.programs.values())),
            tuple(self.contacts),
            tuple(self.near),
            tuple(self._events),
            self._output,
            self.task,
            self.marked,
            self.places,
        )


def _start(row: Json) -> float:
    start = row["start"]
    assert isinstance(start, float | int)
    return start


def _differs(a: Status, b: Status) -> bool:
    """Return whether more has changed than the time."""
    names = (name for name in Status.__struct_fields__ if name not in ("time_s", "checked_s"))
    return any(getattr(a, name) != getattr(b, name) for name in names)


def _entries(programs: tuple[StoredProgram, ...]) -> tuple[ProgramEntry, ...]:
    main = entry_among([p.program.outline for p in programs if p.program is not None])
    return tuple(
        ProgramEntry(
            p.name,
            p.lines,
            p.faults[0].headline if p.faults else "",
            main is not None and p.name == main.name,
        )
        for p in programs
    )
