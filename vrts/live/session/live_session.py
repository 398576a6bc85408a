"""A session: orders with their stamps and beats of the clock in, messages out.

It reads no clock and writes no pipe: `process` does, and tests drive it with times of their own.
What it does depends on session times only, so `replay` repeats it exactly.
"""

import dataclasses
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from vrts.engine.faults import RuntimeFault
from vrts.engine.run import Run
from vrts.ir.commands import Command, Load, Panic, SetVariable
from vrts.ir.module import Module
from vrts.lang.dialect import DIALECTS
from vrts.live import actions as do
from vrts.live.session.acting import Acting
from vrts.live.session.channel import messages as m
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.growing.past import Past
from vrts.live.session.operator.conversation import Conversation
from vrts.live.session.operator.folders import Folders
from vrts.live.session.operator.held_key import HeldKey
from vrts.live.session.views.places import places_of
from vrts.live.session.views.showing import Showing
from vrts.live.session.views.status import runs
from vrts.live.session.views.task_view import task_view
from vrts.monitor.desk import Desk
from vrts.pipeline.setting import Setting
from vrts.scene.model import Limits, Scenario

DAY = 86_400.0  # [s]
LIMITS = Limits(
    time_s=30 * DAY, statements=2_000_000_000, motions=200_000, output_characters=50_000_000
)
MOST_WAITING = 16  # actions
WAITING = "commands wait"  # until the next tick, as a rule
LATE = 2.0  # [s] behind the clock beyond which that time is given up: the machine slept

Send = Callable[[m.News | bytes], None]
Clock = Callable[[], float]


class _Waiting(NamedTuple):
    """An action whose turn has not come."""

    ref: int
    stamp_s: float
    owner: str
    action: do.Action


class Session:
    """Everything about one session."""

    def __init__(
        self,
        start: m.Start,
        setting: Setting,
        send: Send,
        clock: Clock,
        *,
        forgets: bool = True,
        past: Past | None = None,
    ) -> None:
        """Begin at time 0.

        Args:
            start: What it is about.
            setting: Its scene and task, read.
            send: Takes messages and pose frames for the server.
            clock: Returns the time of a clock that only goes forward [s].
            forgets: Whether what is long past is forgotten.
            past: What it has forgotten already, where it goes on; None: nothing.
        """
        self.start = start
        self.setting = setting
        self._send = send
        self._clock = clock
        self._forgets = forgets
        self._sequence = 0
        self._task = None if setting.task is None else task_view(setting.scene, setting.task)
        self._folders = Folders(Path(start.folder), start.quota)
        own = Past(Path(start.folder), start.history) if forgets else None
        self._past = own if past is None else past
        self._begin(())

    def _begin(self, memory: tuple[Command, ...]) -> None:
        """Begin at time 0 with something in memory."""
        planned = self.setting.scenario
        scenario = planned.scenario if planned is not None else Scenario()
        scene = self.setting.scene
        scenario = dataclasses.replace(scenario, limits=LIMITS)
        task = self.setting.task
        if task is not None:
            scenario = dataclasses.replace(scenario, locks=task.locks)
        self.growing = GrowingRun(scene, scenario, self._past, forgets=self._forgets)
        desk = Desk(self._folders.of("nobody"), DIALECTS[self.start.dialect], replace=True)
        self.conversation = Conversation(self.growing, desk, self._folders)
        self._key = HeldKey(self.conversation)
        self.showing = Showing(self.growing, self.conversation, self._key, self.start.session)
        if task is not None:
            self.showing.total = float(task.mark.total)
        self.showing.task = self._task
        self.showing.places = places_of(scene)
        self._acting = Acting(self.growing, self.conversation, self._key, self.showing)
        self._waiting: deque[_Waiting] = deque()
        if memory:
            self.growing.issue(*memory)
        self.epoch_s = self._clock()

    @property
    def now_s(self) -> float:
        """Session time by the clock [s]."""
        return self._clock() - self.epoch_s

    # --- orders -------------------------------------------------------------------------------

    def take(self, order: m.ToSession) -> None:
        """Take an order that has arrived."""
        now_s = self.now_s
        match order:
            case m.Halt():
                self._halt(order, now_s)
            case m.Act():
                self._act(order, now_s)
            case m.AskReach():
                self._send(self.reach(order))
            case m.AskSnapshot():
                self._send(self.showing.snapshot(order.ref))
            case m.AskProgram():
                self._send(m.ProgramText(order.ref, order.name, self.program(order.name)))
            case m.Start() | m.Stop() | m.Pace() | m.AskBlock() | m.AskState() | m.Sleep():
                pass  # the process sees to them

    def beat(self) -> None:
        """Go on to now, and tell what there is to tell."""
        now_s = self.now_s
        if now_s - self.growing.time_s > LATE:
            self._lose(now_s - self.growing.time_s)
            now_s = self.growing.time_s
        self._advance(max(self._work(now_s), self.growing.time_s))
        self._send(self.showing.frame(self._sequence))
        self._sequence += 1
        for news in self.showing.news():
            self._send(news)

    def repeat(self, order: m.Act | m.Halt, at_s: float) -> None:
        """Do again what was done at a time [s].

        Raises:
            ValueError: The time is in the past.
        """
        self.go_on(at_s)
        if isinstance(order, m.Halt):
            self._panic()
        else:
            self._carry_out(_Waiting(order.ref, at_s, order.owner, order.action))

    def go_on(self, until_s: float) -> None:
        """Let session time pass, whatever the clock says.

        Raises:
            ValueError: The time is in the past.
        """
        if until_s < self.growing.time_s:
            raise ValueError(f"{until_s} s is before {self.growing.time_s} s, which was reached")
        self._advance(until_s)

    def stand_still(self, why: str) -> None:
        """Stop everything where it is, say why, and let the clock go on from here."""
        self._panic()
        self.growing.said.append(why)
        self.showing.hear()
        self.showing.tell_again()
        self.epoch_s = self._clock() - self.growing.time_s

    def go_on_from_here(self) -> None:
        """Let the clock go on from here; it stood still for long."""
        self.showing.tell_again()
        self.epoch_s = self._clock() - self.growing.time_s

    @property
    def under_way(self) -> str:
        """What keeps it from falling asleep, in words; empty: nothing."""
        growing = self.growing
        if self._waiting or growing.waits:
            return WAITING
        if growing.executing or growing.machine.process.running:
            return "a program is running"
        still = self.at_rest and not self._key.active
        return "" if still else "the arm moves"

    @property
    def past(self) -> Past | None:
        """What it has forgotten; None: it forgets nothing."""
        return self._past

    @property
    def at_rest(self) -> bool:
        """Whether nothing is under way: no program, no motion, no command."""
        growing = self.growing
        busy = growing.waits or growing.moving or growing.braking or growing.executing
        return not (busy or growing.machine.process.running)

    @property
    def run(self) -> Run:
        """The run so far, which nothing changes any more."""
        return self.growing.run

    def program(self, name: str) -> str:
        """Return what was done as VAL-II text."""
        return self._acting.program(name)

    def reach(self, order: m.AskReach) -> m.Reached:
        """Return whether the tool can go somewhere; nothing of what the way there touches."""
        return self._acting.reach(order)

    def _act(self, order: m.Act, now_s: float) -> None:
        waiting = _Waiting(order.ref, order.stamp_s, order.owner, order.action)
        if _overtakes(order.action):
            self._advance(self._time_of(order.stamp_s, now_s))
            self._carry_out(waiting)
        elif len(self._waiting) >= MOST_WAITING:
            at_s = self.growing.time_s
            text = "too many commands wait already"
            self._send(m.Done(order.ref, at_s, False, text, code="full", counts=False))
        else:
            self._waiting.append(waiting)
            self._work(now_s)

    def _halt(self, order: m.Halt, now_s: float) -> None:
        self._advance(self._time_of(order.stamp_s, now_s))
        self._panic()
        self._send(m.Done(order.ref, self.growing.time_s, True))

    def _panic(self) -> None:
        """Stop everything, and forget what waits."""
        self._key.drop()
        self.conversation.issue(Panic())
        while self._waiting:
            gone = self._waiting.popleft()
            text = "the arm was stopped before it was carried out"
            at_s = self.growing.time_s
            self._send(m.Done(gone.ref, at_s, False, text, code="stopped", counts=False))

    def _work(self, now_s: float) -> float:
        """Carry out what waits, as far as it can be done by now; return what now is then [s]."""
        while self._waiting and self._waiting[0].stamp_s <= now_s:
            first = self._waiting[0]
            self._advance(self._time_of(first.stamp_s, now_s))
            if not self._its_turn(first.action):
                break
            self._waiting.popleft()
            epoch_s = self.epoch_s
            self._carry_out(first)
            if self.epoch_s != epoch_s:  # session time has jumped, back as a rule
                now_s = self.growing.time_s
        return now_s

    def _its_turn(self, action: do.Action) -> bool:
        """Return whether nothing given before is still in the way of an action."""
        growing = self.growing
        if growing.waits:
            return False
        if not isinstance(action, do.Typed | do.Go | do.Step | do.Hand | do.Ready):
            return True
        return not growing.machine.robot.running or runs(growing)

    def _time_of(self, stamp_s: float, now_s: float) -> float:
        """Return when an order takes effect: at its stamp, if that is neither past nor to come."""
        return max(min(stamp_s, now_s), self.growing.time_s)

    def _advance(self, until_s: float) -> None:
        self._key.advance(until_s)
        self.showing.hear()

    def _carry_out(self, given: _Waiting) -> None:
        """Carry an action out now, and say what became of it."""
        at_s = self.growing.time_s
        try:
            done = self._done(given)
        except RuntimeFault as fault:
            text = fault.headline
            done = m.Done(given.ref, at_s, False, text, _first(fault.help), fault.rule.code)
        self._send(done)

    def _done(self, given: _Waiting) -> m.Done:
        match given.action:
            case do.Reset():
                return self._reset(given.ref)
            case do.Rewind(time_s=time_s):
                return self._rewind(given.ref, time_s)
            case action:
                return self._acting.act(given.ref, given.owner, action)

    # --- other times --------------------------------------------------------------------------

    def _reset(self, ref: int) -> m.Done:
        """Begin anew; programs and variables stay in memory."""
        at_s = self.growing.time_s
        programs = dict(self.conversation.monitor.desk.programs)
        loads = [p.program for p in programs.values() if p.program is not None]
        memory: list[Command] = [Load(Module({p.name: p}, ())) for p in loads]
        for cell, value in self.run.at(at_s).variables.items():
            name, _, indices = cell.rstrip("]").partition("[")
            subscripts = tuple(map(int, indices.split(","))) if indices else ()
            memory.append(SetVariable(name, subscripts, value))
        self._begin(tuple(memory))
        self.conversation.monitor.desk.programs.update(programs)
        self._jumped()
        return m.Done(ref, at_s, True)

    def _rewind(self, ref: int, time_s: float) -> m.Done:
        at_s = self.growing.time_s
        try:
            self.growing.rewind(time_s)
        except ValueError:
            text = f"only times from {self.growing.reaches_s:.0f} to {at_s:.0f} s are known"
            return m.Done(ref, at_s, False, text, code="time")
        self._key.drop()
        for number, waiting in enumerate(self._waiting):  # given before the jump: now, then
            self._waiting[number] = waiting._replace(stamp_s=min(waiting.stamp_s, time_s))
        self.showing.jumped()
        self.epoch_s = self._clock() - self.growing.time_s
        self._jumped()
        return m.Done(ref, at_s, True)

    def _lose(self, behind_s: float) -> None:
        """Go on from where the session is: its clock stands still for what was missed."""
        self.epoch_s += behind_s
        self._jumped()

    def _jumped(self) -> None:
        """Say that session time is another one."""
        self._send(m.Began(self.growing.time_s, self.epoch_s))
        self._send(self.showing.snapshot(0))


def _overtakes(action: do.Action) -> bool:
    """Return whether an action does not wait for its turn."""
    if isinstance(action, do.Typed):
        return action.line.strip().upper() in ("PANIC", "ABORT")
    return isinstance(action, do.Interrupt | do.Keep | do.LetGo)


def _first(help_: tuple[str, ...]) -> str:
    """Return the first hint that is of use in a browser: none that names a command of the shell."""
    return next((hint for hint in help_ if "`vrts " not in hint), "")
