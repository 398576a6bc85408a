"""Who waits for whom, in words: "`main` waits for signal 2001; only `b` could set it, …"."""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.machine.forever.reach import texts
from vrts.engine.machine.forever.touches import Changes, Looks, changes_of, passed
from vrts.engine.machine.forever.waits import waiting
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import Ending
from vrts.engine.programs.context import Context
from vrts.engine.programs.signals import INPUTS
from vrts.engine.programs.watches import Watch
from vrts.ir import instructions as ir

MOST = 3  # things that are told of
MOST_NAMED = 3  # programs
MOST_LINKS = 3  # of a chain of programs that wait for one another
OVER = {
    Ending.NOT_STARTED: "is never executed",
    Ending.COMPLETED: "has ended",
    Ending.HALTED: "has ended",
    Ending.PAUSED: "stands still",
    Ending.STEPPED: "stands still",
    Ending.ERROR: "has stopped with an error",
    Ending.ABORTED: "was stopped",
    Ending.LIMIT: "was stopped",
}


class Thing(NamedTuple):
    """A signal or a global variable."""

    signal: int = 0
    name: str = ""

    @property
    def words(self) -> str:
        """What it is called."""
        return f"signal {self.signal}" if self.signal else f"`{self.name}`"

    @property
    def verb(self) -> str:
        """What programs do to it."""
        return "set" if self.signal else "change"

    @property
    def looks(self) -> Looks:
        """The same as something that is looked at."""
        one = frozenset({self.signal}) if self.signal else frozenset[int]()
        return Looks(one, frozenset({self.name}) if self.name else frozenset())


def things(looks: Looks) -> list[Thing]:
    """Return the signals and variables that are looked at, as far as they can be told."""
    return [*map(Thing, sorted(looks.signals)), *(Thing(name=n) for n in sorted(looks.names))]


def waits(machine: Machine, c: Context) -> tuple[str, ...]:
    """Return for each thing that a program waits for why it never comes."""
    found = waiting(machine, c)
    if found is None or found.looks.other:
        return ()
    told = [(thing, _never(machine, c, thing)) for thing in things(found.looks)]
    worth = [(thing, why) for thing, why in told if why.who or not found.looks.arm] or told
    words = [f"{thing.words}; {why.words}" for thing, why in worth[:MOST]]
    if found.looks.arm:
        words.append("arm or hand, which stand still")
    return tuple(f"`{c.program}` waits for {what}" for what in words)


def why_never(machine: Machine, c: Context, thing: Thing) -> str:
    """Return why nothing changes a thing that a program looks at.

    Args:
        machine: Where no input, fault or command is to come any more.
        c: The program.
        thing: What it looks at.
    """
    return _never(machine, c, thing).words


class _Why(NamedTuple):
    """Why nothing changes a thing."""

    who: str  # could do it: "only `b`"; empty for nobody
    verb: str
    fate: str = ""  # why it does not

    @property
    def words(self) -> str:
        if not self.who:
            return f"no program {self.verb}s it"
        return f"{self.who} could {self.verb} it{f', {self.fate}' if self.fate else ''}"

    @property
    def which(self) -> str:
        """The same behind the name of the thing."""
        if not self.who:
            return f"which no program {self.verb}s"
        return f"which {self.who} could {self.verb}{f', {self.fate}' if self.fate else ''}"


def _never(machine: Machine, c: Context, thing: Thing, seen: tuple[Thing, ...] = ()) -> _Why:
    """Return why nothing changes a thing; things in `seen` wait for it in their turn."""
    other = machine.process if c.is_robot else machine.robot
    programs = machine.system.programs
    if thing.signal in INPUTS:
        return _Why("only the scenario", "change", "and it does not any more")
    if other.program and _may(machine, texts(programs, other.program), thing):
        fate = _fate(machine, other, (*seen, thing))
        return _Why(f"only `{other.program}`", thing.verb, fate)
    for watch in c.watches:
        if watch.program is None:
            continue
        name = programs.loaded[watch.program].program.name
        if _may(machine, texts(programs, name), thing):
            reaction = f"only the reaction `{name}`"
            return _Why(reaction, thing.verb, _not_taken(machine, c, watch, (*seen, thing)))
    known = machine.executable.module.programs.values()
    able = [program.name for program in known if _may(machine, program.instructions, thing)]
    if able and _may(machine, texts(programs, c.program), thing):
        return _Why(f"only `{c.program}` itself", thing.verb)
    if able:
        names = " or ".join(f"`{name}`" for name in able[:MOST_NAMED])
        return _Why(f"only {names}", thing.verb, "and it is never executed")
    return _Why("", thing.verb)


def _not_taken(machine: Machine, c: Context, watch: Watch, seen: tuple[Thing, ...]) -> str:
    if watch.priority <= c.priority:
        return f"and its priority {watch.priority} is not above {c.priority}"
    thing = Thing(watch.signal)
    if thing in seen:
        return f"and it waits for {thing.words}"
    return f"and it waits for {thing.words}, {_never(machine, c, thing, seen).which}"


def _may(machine: Machine, code: Iterable[ir.Instruction], thing: Thing) -> bool:
    changes: Changes = changes_of(code, passed(machine.executable.module))
    return changes.touch(thing.looks)


def _fate(machine: Machine, c: Context, seen: tuple[Thing, ...]) -> str:
    """Return what a program does instead of something."""
    if not c.running:
        return f"and it {OVER.get(c.ending, 'is over')}"
    found = waiting(machine, c)
    if found is None:
        return "and it never does"
    if found.answer:
        return "and it waits for an answer that nobody gives"
    asked = things(found.looks)[:1]
    if not asked:
        return "and it waits, too"
    thing = asked[0]
    if len(seen) >= MOST_LINKS:
        return f"and it waits for {thing.words}"
    other = machine.process if c.is_robot else machine.robot
    if other.program and _may(machine, texts(c.system.programs, other.program), thing):
        who = f"which only `{other.program}` could {thing.verb}"
        return f"and it waits for {thing.words}, {who}: each waits for the other"
    return f"and it waits for {thing.words}, {_never(machine, c, thing, seen).which}"
