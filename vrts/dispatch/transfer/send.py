"""A bundle to a controller: look, enter, read everything back.

Nothing is begun while a program executes, or where something else stands under the same name. What
is replaced is deleted before any location changes, so no old program ever meets new locations.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps, first_difference
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.entering import (
    delete_program,
    enter_place,
    enter_steps,
    leave,
    open_program,
)
from vrts.dispatch.transfer.held import asking
from vrts.dispatch.transfer.held.asking import (
    AT_COMMANDS,
    refuse_unless_at_commands,
    refuse_while_running,
)
from vrts.dispatch.transfer.held.looking import Options, States, Work, copy_of_old, key, look
from vrts.dispatch.transfer.held.read_back import same_value, verify_places, verify_program, where
from vrts.dispatch.transfer.talk import Talk
from vrts.pipeline.refused import Refused

BEGUN = "begun: how many steps it has is not known"
DELETING = "begun to be deleted: whether it is there is not known"
GIVING = "begun: its value is not known"


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
    states: dict[str, str] = field(default_factory=States)
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
        work = look(self.talk, self.profile, self.cargo, self.options, self.states)
        self.total = sum(len(e.program.rows) - e.first + 1 for e in work.programs)
        self.total += len(work.places) + sum(len(p.rows) for p in self.cargo.programs)
        copy = copy_of_old(self.talk, self.profile, work)
        if copy:
            self.kept(copy)
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

    # --- entering -------------------------------------------------------------------------------

    def _delete(self, work: Work) -> None:
        for old in work.old_programs:
            self.states[key(old)] = DELETING
            delete_program(self.talk, self.profile, old.name)
            self.states[key(old)] = "deleted, not yet entered"

    def _enter_places(self, work: Work) -> None:
        for place in work.places:
            self.states[key(place)] = GIVING
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
        """Leave the editor, and look what has become of what was begun; the line may be dead."""
        unknown = [
            entry.program
            for entry in work.programs
            if self.states[key(entry.program)] in (BEGUN, DELETING)
        ]
        given = [place for place in work.places if self.states[key(place)] == GIVING]
        if self.talk.at.prompt in AT_COMMANDS and self.talk.line_in_doubt:
            return  # RETURN could carry out what stands in the line
        try:
            if self.talk.prompt_missed:
                self.talk.begin()
            else:
                self.talk.take_back()
            if not leave(self.talk, self.profile):
                return
            for program in unknown:
                found = asking.program_on(self.talk, self.profile, program.name)
                self.states[key(program)] = self._how_far(program, found)
            present = asking.all_places(self.talk, self.profile) if given else {}
            for place in given:
                there = present.get(place.name)
                value = "not there" if there is None else f"{' '.join(there.values)} there"
                self.states[key(place)] = value
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
