"""A bundle to a controller: look, enter, read everything back.

Nothing is begun while a program executes, or where something else stands under the same name. What
is replaced is deleted before any location changes, so no old program ever meets new locations.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from vrts.dispatch import asking
from vrts.dispatch.asking import AT_COMMANDS, refuse_unless_at_commands, refuse_while_running
from vrts.dispatch.cargo import Cargo
from vrts.dispatch.entering import (
    delete_program,
    enter_place,
    enter_steps,
    leave,
    open_program,
)
from vrts.dispatch.fetch import Fetched, fetched_text
from vrts.dispatch.listed import Place
from vrts.dispatch.locations import is_nowhere, same_place
from vrts.dispatch.problems import LISTING_UNREADABLE, THERE_ALREADY, stop
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.read_back import same_value, verify_places, verify_program, where
from vrts.dispatch.rehearsal import Line, Rehearsal
from vrts.dispatch.steps import Steps, first_difference
from vrts.dispatch.talk import Says, Talk
from vrts.pipeline.settings import Refused

BEGUN = "begun: how many steps it has is not known"


class Options(NamedTuple):
    """What may be done with what is on the controller already."""

    replace: bool = False
    resume: bool = False


class Entry(NamedTuple):
    """A program that has to be entered."""

    program: Steps
    first: int = 1  # step
    old: Steps | None = None  # deleted before


class Work(NamedTuple):
    """What is left to be done."""

    programs: tuple[Entry, ...]
    places: tuple[Place, ...]
    old_places: tuple[Place, ...] = ()  # that get other values

    @property
    def old_programs(self) -> tuple[Steps, ...]:
        """Those that are deleted."""
        return tuple(entry.old for entry in self.programs if entry.old is not None)


Told = Callable[[int, int, str], None]
"""Called with lines done, lines in all, and what is being done."""
Kept = Callable[[str], None]
"""Called with the text of what is about to be replaced; returns when it is safe."""


@dataclass(slots=True)
class Sending:
    """One transfer; `states` tells what is known of the controller, at any time."""

    talk: Talk
    profile: Profile
    cargo: Cargo
    options: Options
    told: Told
    kept: Kept
    states: dict[str, str] = field(default_factory=dict[str, str])
    missing: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    done: int = 0
    total: int = 0

    def run(self) -> None:
        """Send what is not there yet, and compare everything.

        Raises:
            Refused: Something is wrong; `states` says what the controller holds.
        """
        everything = (*self.cargo.programs, *self.cargo.places)
        self.states.update({key(each): "not looked at" for each in everything})
        self._begin()
        work = self._look()
        self.total = sum(len(e.program.rows) - e.first + 1 for e in work.programs)
        self.total += len(work.places) + sum(len(p.rows) for p in self.cargo.programs)
        self._keep(work)
        self.told(0, self.total, "begun")
        try:
            self._delete(work)
            self._enter_places(work)
            self._enter_programs(work)
        except (Refused, KeyboardInterrupt):
            self._recover(work)
            raise
        self._read_back()

    def _begin(self) -> None:
        at = self.talk.begin()
        if self.options.resume and at.prompt not in AT_COMMANDS:
            leave(self.talk, self.profile)
        refuse_unless_at_commands(self.talk.at)
        refuse_while_running(self.talk, self.profile)

    # --- looking --------------------------------------------------------------------------------

    def _look(self) -> Work:
        conflicts: list[str] = []
        entries = [self._look_at(program, conflicts) for program in self.cargo.programs]
        present = asking.all_places(self.talk, self.profile) if self.cargo.places else {}
        wanted: list[Place] = []
        for place in self.cargo.places:
            found = present.get(place.name)
            if found is not None and same_place(place, found, self.profile):
                self.states[key(place)] = "there already, the same"
                continue
            self.states[key(place)] = "not there" if found is None else "there, with another value"
            wanted.append(place)
            if found is not None and not self._may_change(found):
                conflicts.append(
                    f"location `{place.name}` is {' '.join(found.values)} there, "
                    f"and {' '.join(place.values)} here"
                )
        if conflicts:
            raise stop(
                THERE_ALREADY,
                "the controller holds something else under the same name",
                *conflicts,
                remedy="`--replace` keeps a copy of it in a file and replaces it",
            )
        old = tuple(present[place.name] for place in wanted if place.name in present)
        return Work(tuple(entry for entry in entries if entry is not None), tuple(wanted), old)

    def _may_change(self, found: Place) -> bool:
        begun = is_nowhere(found, self.profile.language)  # POINT, and no numbers yet
        return self.options.replace or (self.options.resume and begun)

    def _look_at(self, program: Steps, conflicts: list[str]) -> Entry | None:
        found = asking.program_on(self.talk, self.profile, program.name)
        if found is None:
            self.states[key(program)] = "not there"
            return Entry(program)
        differs = first_difference(program, found, self.profile.language)
        if differs is None:
            self.states[key(program)] = "there already, the same"
            return None
        steps = len(found.rows)
        begun = differs.found is None and differs.step == steps + 1
        self.states[key(program)] = f"another program ({steps} step{'' if steps == 1 else 's'})"
        if begun:
            self.states[key(program)] = f"steps 1 to {steps} of {len(program.rows)}"
        if begun and self.options.resume:
            return Entry(program, steps + 1)
        if self.options.replace:
            return Entry(program, 1, found)
        if begun:
            conflicts.append(
                f"program `{program.name}` has the first {steps} of {len(program.rows)} steps: "
                "`--resume` goes on"
            )
        else:
            conflicts.append(f"program `{program.name}` is another one: {where(differs)}")
        return Entry(program)

    def _keep(self, work: Work) -> None:
        if not work.old_programs and not work.old_places:
            return
        for old in work.old_programs:  # a second time: a listing has no check sum
            again = asking.program_on(self.talk, self.profile, old.name)
            if again != old:
                raise stop(
                    LISTING_UNREADABLE,
                    f"`{old.name}` was listed twice, and not alike",
                    "nothing was changed on the controller",
                )
        self.kept(fetched_text(Fetched(work.old_programs, work.old_places)))

    # --- entering -------------------------------------------------------------------------------

    def _delete(self, work: Work) -> None:
        for old in work.old_programs:
            delete_program(self.talk, self.profile, old.name)
            self.states[key(old)] = "deleted, not yet entered"

    def _enter_places(self, work: Work) -> None:
        for place in work.places:
            self.states[key(place)] = "begun: its value is not known"
            enter_place(self.talk, self.profile, place)
            self.states[key(place)] = "entered, not yet read back"
            self._step(f"location {place.name}")

    def _enter_programs(self, work: Work) -> None:
        for entry in work.programs:
            program, first = entry.program, entry.first
            open_program(self.talk, self.profile, program, first)
            self.states[key(program)] = BEGUN
            doing = f"program {program.name}"
            enter_steps(
                self.talk, self.profile, program, first, lambda doing=doing: self._step(doing)
            )
            self.states[key(program)] = "entered, not yet read back"

    def _step(self, doing: str) -> None:
        self.done += 1
        self.told(self.done, self.total, doing)

    def _recover(self, work: Work) -> None:
        """Leave the editor, and look how far a program has come; the line may be dead."""
        begun = [e.program for e in work.programs if self.states[key(e.program)] == BEGUN]
        if self.talk.at.prompt in AT_COMMANDS and self.talk.line_in_doubt:
            return  # RETURN could carry out what stands in the line
        try:
            if self.talk.prompt_missed:
                self.talk.begin()
            else:
                self.talk.take_back()
            if not leave(self.talk, self.profile):
                return
            for program in begun:
                found = asking.program_on(self.talk, self.profile, program.name)
                self.states[key(program)] = self._how_far(program, found)
        except Refused:
            return  # the first fault is what is told; the states say what is not known

    def _how_far(self, program: Steps, found: Steps | None) -> str:
        if found is None:
            return "not there"
        differs = first_difference(program, found, self.profile.language)
        if differs is None:
            return "all steps are there, not yet read back"
        if differs.found is None:
            return f"steps 1 to {len(found.rows)} of {len(program.rows)}, as sent"
        return f"not as sent: {where(differs)}"

    # --- reading back ---------------------------------------------------------------------------

    def _read_back(self) -> None:
        for program in self.cargo.programs:
            verify_program(self.talk, self.profile, program)
            self.states[key(program)] = "verified"
            self.done += len(program.rows)
            self.told(self.done, self.total, f"read back {program.name}")
        if self.cargo.places:
            verify_places(self.talk, self.profile, self.cargo.places)
            self.states.update({key(place): "verified" for place in self.cargo.places})
        for name, value in self.cargo.values:
            found = asking.value_on(self.talk, self.profile, name)
            if found is None or not same_value(value, found):
                self.missing.append((name, value))


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


def key(each: Steps | Place) -> str:
    """Return the name of a program or a location among all of them."""
    return f"{'program' if isinstance(each, Steps) else 'location'} {each.name}"


def _ask(talk: Says, command: str) -> None:
    talk.say(command)
