"""What becomes of an operator's action when its turn has come."""

from vrts.engine.faults import RuntimeFault
from vrts.engine.motion.requests import Stance
from vrts.live import actions as do
from vrts.live.session.channel import messages as m
from vrts.live.session.growing.deeds import Deeds
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.operator.conversation import Conversation
from vrts.live.session.operator.held_key import HeldKey
from vrts.live.session.operator.motions import (
    Instruction,
    branch_words,
    displaced,
    go,
    instructed,
    pose_of,
    turn_joint,
)
from vrts.live.session.operator.recording import Unrecordable, recorded, stored_row
from vrts.live.session.views.program import as_program, is_program_name
from vrts.live.session.views.showing import Showing
from vrts.live.session.views.status import runs

BUSY = "a program is running"
STOP_FIRST = "stop it first: ABORT, or the panic button"

Now = (
    do.Typed
    | do.Interrupt
    | do.Upload
    | do.Go
    | do.Step
    | do.Jog
    | do.Keep
    | do.LetGo
    | do.Hand
    | do.Ready
    | do.Record
    | do.Save
)
"""What leads to no other time."""


class Acting:
    """Does what an operator wants now, by the parts of a session."""

    def __init__(
        self, growing: GrowingRun, conversation: Conversation, key: HeldKey, showing: Showing
    ) -> None:
        """Take the parts."""
        self._growing = growing
        self._conversation = conversation
        self._key = key
        self._showing = showing

    def act(self, ref: int, owner: str, action: Now) -> m.Done:
        """Do something now, and return what became of it.

        Args:
            ref: Of the order.
            owner: Who gave it.
            action: What is to be done.

        Raises:
            RuntimeFault: The controller would refuse it.
        """
        at_s, talk = self._growing.time_s, self._conversation
        match action:
            case do.Typed(line=line):
                line = " ".join(line.splitlines())
                shown = talk.enter(line, owner)
                self._showing.say(shown)
                return m.Done(ref, at_s, True, shown)
            case do.Interrupt():
                self._showing.say(talk.interrupt(owner))
                return m.Done(ref, at_s, True)
            case do.Upload(name=name, text=text):
                shown, refused = talk.upload(name, text, owner)
                self._showing.say(shown)
                return m.Done(ref, at_s, not refused, refused or shown, code="file" * bool(refused))
            case do.Go() | do.Step() | do.Hand() | do.Ready() | do.Jog() if runs(self._growing):
                return m.Done(ref, at_s, False, BUSY, STOP_FIRST, "busy")
            case do.Go(position_m=position, oat_rad=oat, straight=straight):
                return self._move(ref, go(self._stance, pose_of(position, oat), straight=straight))
            case do.Step() as step:
                return self._move(ref, self._step(step))
            case do.Hand(open=opens):
                return self._order(ref, "OPENI" if opens else "CLOSEI")
            case do.Ready():
                return self._order(ref, "READY")
            case do.Jog() as jog:
                fault = self._key.press(jog)
                if fault is not None:
                    raise fault
                return m.Done(ref, at_s, True)
            case do.Keep():
                held = self._key.keep()
                return m.Done(ref, at_s, held, "" if held else "no key is held", counts=held)
            case do.LetGo():
                held = self._key.release()
                return m.Done(ref, at_s, held, "" if held else "no key is held", counts=held)
            case do.Record(name=name):
                return self._record(ref, name)
            case do.Save(name=name):
                return self._save(ref, name, owner)

    def program(self, name: str) -> str:
        """Return what was done as VAL-II text."""
        growing = self._growing
        return as_program(growing.run, name, growing.deeds() or Deeds(), growing.known_from_s)

    @property
    def _stance(self) -> Stance:
        """From where the next motion starts: the end of those given."""
        return self._growing.machine.system.planner.stance

    def _step(self, step: do.Step) -> Instruction:
        by = step.way * step.size
        if step.frame == "joint":
            return turn_joint(self._stance, step.axis, by)
        X_BT = displaced(self._stance, step.frame, step.axis, by)
        return go(self._stance, X_BT, straight=True)

    def _move(self, ref: int, instruction: Instruction) -> m.Done:
        self._key.drop()
        self._conversation.issue(instruction.command)
        return m.Done(ref, self._growing.time_s, True)

    def _order(self, ref: int, words: str) -> m.Done:
        """Carry out an instruction without operands."""
        self._conversation.issue(instructed(words))
        return m.Done(ref, self._growing.time_s, True)

    def _record(self, ref: int, name: str) -> m.Done:
        at_s = self._growing.time_s
        try:
            command, text = recorded(name, self._conversation.situation)
        except Unrecordable as problem:
            return m.Done(ref, at_s, False, str(problem), code="name")
        self._conversation.issue(command)
        self._showing.say(text)
        return m.Done(ref, at_s, True, text, row=stored_row(command))

    def _save(self, ref: int, name: str, owner: str) -> m.Done:
        at_s = self._growing.time_s
        if not is_program_name(name):
            return m.Done(ref, at_s, False, f"`{name}` is no name of a program", code="name")
        if self._growing.deeds() is None:
            text = f"what was done before {self._growing.reaches_s:.0f} s is forgotten"
            help_ = "reset the scene, and do what the program is to do"
            return m.Done(ref, at_s, False, text, help_, "time")
        shown, refused = self._conversation.upload(f"{name}.v2", self.program(name), owner)
        self._showing.say(shown)
        return m.Done(ref, at_s, not refused, refused or shown, code="file" * bool(refused))

    def reach(self, order: m.AskReach) -> m.Reached:
        """Return whether the tool can go where is asked, from the end of the motions given."""
        stance = self._stance
        X_BT = pose_of(order.position_m, order.oat_rad)
        try:
            found = go(stance, X_BT, straight=order.straight).planned
        except RuntimeFault as fault:
            return m.Reached(order.ref, False, fault.headline, fault.rule.code)
        return m.Reached(order.ref, True, "", "", branch_words(stance, found), found.goal)
