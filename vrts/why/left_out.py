"""Things that were never done: the step that would have done it, and why it did not come to it."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, distance
from vrts.base.source import Span
from vrts.engine.memory.cells import Array, Cell, cells_of
from vrts.ir.control import BeginCase, Jump, JumpIf, TestCase, TestFor
from vrts.ir.expressions import Constant, Place
from vrts.ir.module import Program
from vrts.why.chain import Link
from vrts.why.hands import box_at, gap
from vrts.why.loops.ended import loop_left
from vrts.why.slicing.conditions import by_values, with_values
from vrts.why.slicing.executed import Steps
from vrts.why.slicing.given import is_of_scene
from vrts.why.slicing.read import element, places_in
from vrts.why.slicing.sources import element_text

AT_IT = 0.12  # [m] from a thing: a location so near is for it [assumed]


class Use(NamedTuple):
    """A step of the source that names a place, and how often it was executed."""

    program: Program
    base: int
    within: int  # its index in the program
    place: Place

    @property
    def span(self) -> Span:
        """Where it stands."""
        return self.program.origins[self.within].span


def never_reached(steps: Steps, body: str) -> Iterator[Link]:
    """Yield why no motion went to a thing, though the program knows its place."""
    unused: Cell | None = None
    for cell in _cells_at(steps, body):
        uses = list(uses_of(steps, cell))
        unused = cell if not uses and unused is None else unused
        for use in uses:
            numbers = steps.times(use.base + use.within)
            if not numbers:
                yield Link(
                    None, use.span, f"this step would use `{cell.name}`, and is never executed"
                )
                yield from skipped(steps, use.program, use.base, use.within)
                return
            if any(_meant(steps, n, use.place) == cell.name for n in numbers):
                continue
            used = ", ".join(dict.fromkeys(f"`{_meant(steps, n, use.place)}`" for n in numbers))
            last = steps.step(numbers[-1])
            assert last is not None
            says = f"`{element_text(use.place)}` is only {used} here, never `{cell.name}`"
            yield Link(steps.time_of(last), use.span, says)
            yield from loop_left(steps, last)
            return
    if unused is not None:
        yield from no_use(steps, unused)


def no_use(steps: Steps, cell: Cell) -> Iterator[Link]:
    """Yield that no step names a location that the file teaches."""
    datum = steps.data.get(cell.name)
    if datum is not None:
        yield Link(None, datum.span, f"no step goes to `{cell.name}`")


def _cells_at(steps: Steps, body: str) -> list[Cell]:
    """Return variables whose value is a place at a thing: elements of arrays first."""
    box = box_at(steps, body, 0.0)
    found: list[tuple[bool, bool, float, Cell]] = []
    for bound in steps.history.memory.bound:
        cells = list(bound.elements.values()) if isinstance(bound, Array) else [bound]
        for cell in cells:
            last = cell.at(steps.history.finished)
            if isinstance(last, Pose) and gap(box, last.translation) < AT_IT:
                middle = tuple((a + b) / 2 for a, b in zip(box.lower, box.upper, strict=True))
                apart = distance(last.translation, (middle[0], middle[1], middle[2]))
                given = is_of_scene(steps, last)
                found.append((not isinstance(bound, Array), not given, apart, cell))
    return [cell for *_, cell in sorted(found, key=lambda one: one[:3])]


def places_at(steps: Steps, point: Vector, within: float) -> list[Cell]:
    """Return variables whose value is a place within a distance of a point [m]."""
    cells = (cell for bound in steps.history.memory.bound for cell in cells_of(bound))
    found: list[Cell] = []
    for cell in cells:
        last = cell.at(steps.history.finished)
        if isinstance(last, Pose) and distance(last.translation, point) <= within:
            found.append(cell)
    return found


def uses_of(steps: Steps, cell: Cell) -> Iterator[Use]:
    """Yield the steps that name a variable, or its array with computed subscripts."""
    name = cell.name.partition("[")[0]
    code = steps.history.code
    for program, base in zip(code.programs, code.bases, strict=True):
        for index, instruction in enumerate(program.instructions):
            written = getattr(instruction, "place", None)
            for place in places_in(tuple(instruction)):
                if place.variable.name != name or place is written:
                    continue
                fixed = all(isinstance(each, Constant) for each in place.subscripts)
                if fixed and element_text(place).replace(" ", "") != cell.name:
                    continue
                yield Use(program, base, index, place)


def _meant(steps: Steps, number: int, place: Place) -> str:
    step = steps.step(number)
    assert step is not None
    return element(steps, place, number - 1, step.activation)


def skipped(
    steps: Steps, program: Program, base: int, within: int, until: int | None = None
) -> Iterator[Link]:
    """Yield the branch that led past a step that was never executed.

    Args:
        steps: Of the run.
        program: In which the step is.
        base: Number of the program's first instruction.
        within: The step's index in the program.
        until: The statement before which it was not executed; None: it never was.
    """
    for k in range(within - 1, -1, -1):
        one = program.instructions[k]
        target = one.leave if isinstance(one, TestFor) else getattr(one, "target", None)
        if isinstance(one, TestCase):
            target = one.otherwise
        if not isinstance(target, int) or target <= within:
            continue
        numbers = [n for n in steps.times(base + k) if until is None or n < until]
        if not numbers:
            continue
        step = steps.step(numbers[-1])
        assert step is not None
        if isinstance(one, Jump):
            says = "the program goes past it from here"
        else:
            asked = with_values(steps, getattr(one, "condition", None), step)
            says = f"the program goes past it because of this{asked}"
        yield Link(steps.time_of(step), step.cause.span, says)
        if isinstance(one, TestCase):
            yield from _selected(steps, program, base, one.case, step.number)
        elif isinstance(one, JumpIf):
            yield from by_values(steps, one.condition, step)
        return
    yield from _never_called(steps, program, base)


def _selected(steps: Steps, program: Program, base: int, case: int, before: int) -> Iterator[Link]:
    """Yield by which value a CASE chose, and where that was written."""
    for index, one in enumerate(program.instructions):
        if not isinstance(one, BeginCase) or one.case != case:
            continue
        numbers = [n for n in steps.times(base + index) if n <= before]
        step = steps.step(numbers[-1]) if numbers else None
        if step is not None:
            yield from by_values(steps, one.selector, step)
        return


def _never_called(steps: Steps, program: Program, base: int) -> Iterator[Link]:
    """Yield that the program of a step was never called, or that a run ended before the step."""
    if any(steps.times(base + k) for k in range(len(program.instructions))):
        return
    yield Link(None, program.span, f"`{program.name}` is never called")
