"""What candidates are made from, and how they are priced."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from types import MappingProxyType

from vrts.base.diagnostic import Edit
from vrts.base.oat import oat_from_rotation
from vrts.base.pose import Pose
from vrts.base.units import MM
from vrts.check.task.task import Task
from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Item, Name, Number
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    HereStatement,
    SetLocation,
    Simple,
)
from vrts.repair.blame.blame import Blame
from vrts.repair.edit import Candidate, Change, Does, replacement
from vrts.repair.nodes import operands, parts
from vrts.repair.visits import Habits, habits, oddness, visits
from vrts.repair.written import Written, WrittenStep
from vrts.scene.model import Scene

FOR_SIZE = 0.55  # what a node of an edit speaks against it
# what it speaks against an edit that its line is not to blame at all: less where there are few
TRUST = MappingProxyType(
    {
        Does.WORD: 1.2,
        Does.REMOVE: 1.2,
        Does.NAME: 1.6,
        Does.ORDER: 1.8,
        Does.ADD: 2.2,
        Does.ROW: 2.2,
        Does.NUMBER: 2.6,
    }
)
PRIOR = MappingProxyType({Does.WORD: -0.4, Does.REMOVE: -0.2, Does.NUMBER: 0.1})
SAID = re.compile("[^aeiou][^aeiou]?[aeiou]")  # how most words begin
MOVES_TO = frozenset({"MOVE", "MOVES", "APPRO", "APPROS", "MOVET", "MOVEST"})


class Asked:
    """A program, its scene, and what is to blame."""

    def __init__(
        self,
        written: Written,
        scene: Scene,
        task: Task,
        blame: Blame,
        dialect: Dialect = VAL2,
    ) -> None:
        """Take what is known."""
        self.written, self.scene, self.task, self.blame = written, scene, task, blame
        self.dialect = dialect

    def against(self, line: int) -> float:
        """Return how little a line is to blame, 0 to 1."""
        return 1.0 - self.blame.weight(line)

    def matters(self, line: int) -> bool:
        """Return whether an edit of a line can change the run: it was executed, or read."""
        return line in self.blame.executed

    def candidate(
        self,
        does: Does,
        line: int,
        edits: Iterable[Edit],
        *,
        size: float = 1,
        unusual: float = 0.0,
        against: float | None = None,
        old: str = "",
        new: str = "",
        priced: float | None = None,
        trust: float | None = None,
        group: int | None = None,
        doubt: float = 0.0,
    ) -> Candidate:
        """Return a candidate with its price.

        Args:
            does: What it does.
            line: The line that it blames.
            edits: What to write where.
            size: Nodes of the syntax that differ.
            unusual: How unusual the mistake would be.
            against: What the blame speaks against it; None: as the line says.
            old: What stands there.
            new: What is to stand there.
            priced: Nodes that count for the price, where a mistake is one but for its places.
            trust: What it costs that the line is not to blame; None: as usual.
            group: Where it belongs: of those at one place that come to nothing the rest waits.
            doubt: What a teacher says against it, even if it earns the full mark.
        """
        blamed = self.against(line) if against is None else against
        counted = size if priced is None else priced
        blamed *= TRUST[does] if trust is None else trust
        cost = 1.0 + FOR_SIZE * (counted - 1) + blamed + unusual + PRIOR.get(does, 0.0)
        made = tuple(edits)
        at = made[0].span.start if group is None and made else group
        change = Change(does, line, made, round(size), old, new)
        return Candidate(cost, change, (does.value, at or 0), doubt)

    def instead(
        self,
        does: Does,
        line: int,
        item: Item,
        text: str,
        *,
        size: float = 1,
        unusual: float = 0.0,
        trust: float | None = None,
        doubt: float = 0.0,
    ) -> Candidate:
        """Return the candidate that writes a text in place of an expression."""
        source = self.written.source
        old = source.text[item.start : item.end]
        edit = replacement(source, item.start, item.end, text)
        return self.candidate(
            does,
            line,
            (edit,),
            size=size,
            unusual=unusual,
            old=old,
            new=text,
            trust=trust,
            doubt=doubt,
        )

    def text_of(self, item: Item) -> str:
        """Return an expression as it is written."""
        return self.written.text[item.start : item.end]

    @cached_property
    def steps(self) -> tuple[WrittenStep, ...]:
        """The steps that were executed."""
        return tuple(step for step in self.written.steps if self.matters(step.line))

    @cached_property
    def oddness(self) -> float:
        """How far the program is from its own habits."""
        return oddness(self.written, self.usual)

    @cached_property
    def usual(self) -> Habits:
        """What most places of the program have."""
        return habits(self.written)

    def odder(self, steps: Sequence[WrittenStep]) -> float:
        """Return how much farther from its habits the program is with other steps."""
        return oddness(self.written._replace(steps=tuple(steps)), self.usual) - self.oddness

    @cached_property
    def row_names(self) -> frozenset[str]:
        """Names that data give a value."""
        return frozenset(key(name_of(row.node.target)) for row in self.written.rows)

    @cached_property
    def defined(self) -> frozenset[str]:
        """Names that anything gives a value."""
        found = set(self.row_names)
        for step in self.written.steps:
            target = target_of(step)
            if target is not None:
                found.add(key(name_of(target)))
        for program in self.written.programs:
            found.update(key(formal.name.text) for formal in program.formals if formal)
        return frozenset(found)

    @cached_property
    def locations(self) -> frozenset[str]:
        """Names of locations, arrays apart: as data, SET and motions tell."""
        found = {
            key(name_of(row.node.target))
            for row in self.written.rows
            if row.kind == "locations" and isinstance(row.node.target, Name)
        }
        for step in self.written.steps:
            match step.statement:
                case SetLocation(Name(text)):
                    found.add(key(text))
                case Simple(word, (Name(text), *_)) if word in MOVES_TO:
                    found.add(key(text))
                case HereStatement(Name(text)):
                    found.add(key(text))
                case _:
                    pass
        return frozenset(found)

    @cached_property
    def series(self) -> frozenset[str]:
        """Names with numbers in them that data have at least twice, without their numbers."""
        found = Counter(series(name) for name in self.row_names)
        return frozenset(name for name, times in found.items() if times > 1 and "#" in name)

    @cached_property
    def used(self) -> Counter[str]:
        """How often steps name each variable."""
        return Counter(key(name.text) for step in self.written.steps for name in names_in(step))

    @cached_property
    def ways(self) -> frozenset[str]:
        """Motions, as they are written, to places where the hand does nothing: to go by there."""
        handled = {visit.target for visit in visits(self.written)}
        return frozenset(
            step.text
            for step in self.written.steps
            if isinstance(step.statement, Simple)
            and step.statement.word in ("MOVE", "MOVES")
            and isinstance(step.statement.operands[0], Name)
            and key(step.statement.operands[0].text) not in handled
        )

    @cached_property
    def idle(self) -> frozenset[str]:
        """Locations that the data have and no step names."""
        return frozenset(
            name for name in self.row_names if name in self.locations and not self.used[name]
        )

    @cached_property
    def undefined(self) -> frozenset[str]:
        """Names that steps use and nothing gives a value."""
        return frozenset(self.used) - self.defined

    def familiar(self, name: str) -> int:
        """Return how many parts of a name other names have, too, and how many can be said.

        A misspelt part no other name has, and often nobody could say it.
        """
        parts = re.findall(r"[a-z]+", name)
        return sum((self._parts[part] > 1) + bool(SAID.match(part)) for part in parts)

    @cached_property
    def _parts(self) -> Counter[str]:
        """How many names of the program and the scene have each part."""
        names = {*self.row_names, *self.used, *self.taught, *(b.name for b in self.scene.bodies)}
        return Counter(part for name in names for part in set(re.findall(r"[a-z]+", name)))

    @cached_property
    def arrays(self) -> frozenset[str]:
        """Names of arrays."""
        return frozenset(
            key(part.name.text)
            for step in self.written.steps
            for item in operands(step.statement)
            for part in parts(item)
            if isinstance(part, Element)
        )

    @cached_property
    def numbers(self) -> frozenset[str]:
        """Names of numbers, arrays apart."""
        found: set[str] = set()
        for step in self.written.steps:
            if isinstance(step.statement, Assignment | For):
                target = step.statement.target
                if isinstance(target, Name) and target.text[0] not in "$#":
                    found.add(key(target.text))
        return frozenset(found)

    @cached_property
    def constants(self) -> dict[str, float]:
        """Numbers that one step gives a value as it stands, and no other step."""
        targets = [target_of(step) for step in self.written.steps]
        times = Counter(key(name_of(target)) for target in targets if target is not None)
        return {
            key(step.statement.target.text): step.statement.value.value
            for step in self.written.steps
            if isinstance(step.statement, Assignment)
            and isinstance(step.statement.target, Name)
            and isinstance(step.statement.value, Number)
            and times[key(step.statement.target.text)] == 1
        }

    @cached_property
    def called(self) -> frozenset[str]:
        """Names of programs that are called."""
        return frozenset(
            key(step.statement.program.text)
            for step in self.written.steps
            if isinstance(step.statement, CallStatement)
        )

    def callee(self, call: CallStatement) -> int | None:
        """Return which program of the file a step calls, from 0; None: none of them."""
        names = [program.name for program in self.written.programs]
        called = key(call.program.text)
        return names.index(called) if called in names else None

    @cached_property
    def taught(self) -> dict[str, tuple[float, ...]]:
        """The scene's own locations: X, Y, Z [mm], O, A, T [deg]."""
        return {key(name): components(pose) for name, pose in self.scene.locations.items()}


def series(name: str) -> str:
    """Return a name with its numbers left out: those of a series are alike."""
    return re.sub(r"\d+", "#", name)


def components(pose: Pose) -> tuple[float, ...]:
    """Return X, Y, Z [mm] and O, A, T [deg] of a pose."""
    places = (x / MM for x in pose.translation)
    return (*places, *oat_from_rotation(pose.rotation))


def name_of(target: Name | Element) -> str:
    """Return the name of a variable as it is written."""
    return target.text if isinstance(target, Name) else target.name.text


def target_of(step: WrittenStep) -> Name | Element | None:
    """Return the variable that a step gives a value, if it does."""
    statement = step.statement
    if isinstance(statement, Assignment | SetLocation | For):
        return statement.target
    if isinstance(statement, HereStatement) and isinstance(statement.target, Name | Element):
        return statement.target
    return None


def written_number(value: float) -> str:
    """Return a number as programs write it: at most two decimals."""
    text = f"{round(value, 2) + 0.0:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def names_in(step: WrittenStep) -> Iterator[Name]:
    """Yield the names of variables in a step, those of arrays too; the name of a program apart."""
    statement = step.statement
    for item in operands(statement):
        if isinstance(statement, CallStatement) and item is statement.program:
            continue
        for part in parts(item):
            if isinstance(part, Name):
                yield part
            elif isinstance(part, Element):
                yield part.name
