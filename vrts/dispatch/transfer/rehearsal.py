"""What would be typed: a controller that agrees with everything takes the place of the real one."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.dispatch.allowed import Prompt, permits
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.entering import enter_place, enter_steps, open_program
from vrts.dispatch.transfer.problems import NOT_SENT, stop, visible
from vrts.dispatch.transfer.talk import Answer, At


class Line(NamedTuple):
    """A line that would be typed."""

    at: At
    text: str

    @property
    def looks(self) -> bool:
        """Whether it changes nothing and only looks whether the editor still asks for a step."""
        return self.at.prompt is Prompt.STEP and not self.text

    @property
    def shown(self) -> str:
        """The line behind what the controller would ask."""
        match self.at.prompt:
            case Prompt.STEP:
                asked = f"step {self.at.step}"
            case Prompt.INSERT:
                asked = f"insert {self.at.step}"
            case Prompt.CHANGE:
                asked = "change?"
            case Prompt.CONFIRM:
                asked = "sure?"
            case Prompt.READY | Prompt.RUNNING:
                asked = "command"
        return f"{asked:>12}  {self.text if self.text.strip() else repr(self.text)}"


class Rehearsal:
    """Agrees with everything, and keeps what it is told."""

    def __init__(self, profile: Profile) -> None:
        """Begin where a controller waits for a command."""
        self._profile = profile
        self._at = At(Prompt.READY)
        self.lines: list[Line] = []

    @property
    def at(self) -> At:
        """What would be waited for."""
        return self._at

    def say(self, text: str, complete: Callable[[str], bool] | None = None) -> Answer:
        """Keep a line."""
        if not permits(text, self._at.prompt):
            raise stop(NOT_SENT, f"{visible(text)} is not sent at {self._at.prompt.value}")
        self.lines.append(Line(self._at, text))
        shown, self._at = self._answer(text)
        return Answer(shown, self._at)

    def _answer(self, text: str) -> tuple[str, At]:
        commands, step = self._profile.commands, self._at.step
        match self._at.prompt:
            case Prompt.READY | Prompt.RUNNING:
                return "", self._after_command(text)
            case Prompt.STEP if text == commands.leave:
                return "", At(Prompt.READY)
            case Prompt.STEP if text == commands.insert:
                return "", At(Prompt.INSERT, step)
            case Prompt.STEP if not text:  # behind the last step it asks again
                return "", self._at
            case Prompt.INSERT if not text:
                return "", At(Prompt.STEP, step)
            case Prompt.STEP | Prompt.INSERT:
                return "", At(self._at.prompt, step + 1)
            case Prompt.CHANGE if text:
                return f"{text.replace(',', ' ')}\n", self._at
            case Prompt.CHANGE | Prompt.CONFIRM:
                return "", At(Prompt.READY)

    def _after_command(self, text: str) -> At:
        verb = text.split(" ", 1)[0]
        commands = self._profile.commands
        if verb == commands.point.split(" ", 1)[0]:
            return At(Prompt.CHANGE)
        if verb == commands.delete.split(" ", 1)[0]:
            return At(Prompt.CONFIRM)
        if verb in (commands.new.split(" ", 1)[0], commands.edit.split(" ", 1)[0]):
            return At(Prompt.STEP, 1)
        return self._at


def rehearsed(cargo: Cargo, profile: Profile) -> list[Line]:
    """Return all lines that would be typed at a controller that holds nothing of it."""
    talk = Rehearsal(profile)
    commands = profile.commands
    _ask(talk, commands.status)
    for program in cargo.programs:
        _ask(talk, commands.list_program.format(name=program.name))
    if cargo.places:
        _ask(talk, commands.list_locations)
    for place in cargo.places:
        enter_place(talk, profile, place)
    for program in cargo.programs:
        open_program(talk, profile, program, 1)
        enter_steps(talk, profile, program, 1, lambda: None)
    for program in cargo.programs:
        _ask(talk, commands.list_program.format(name=program.name))
    if cargo.places:
        _ask(talk, commands.list_locations)
    for name, _ in cargo.values:
        form = commands.list_strings if name[0] == "$" else commands.list_reals
        _ask(talk, form.format(name=name))
    return talk.lines


def _ask(talk: Rehearsal, command: str) -> None:
    talk.say(command)
