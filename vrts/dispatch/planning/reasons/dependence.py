"""What a path depends on beside the program's own text and data: inputs, the clock, the operator.

A value is *outside* when it comes from an input, a timer, chance, the operator, the hand's sensor,
or a variable that nothing gives a value, or is computed from one that is. Which variable may hold
such a value is told without regard to order, so rather too many are told than too few. Inputs are
not looked at here: every future of the program is (`futures`), whatever way they lead. What that
does not try in every way is refused here; that a value depends on *which* way was taken is not
followed.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, error
from vrts.dispatch.manifest import Reads
from vrts.dispatch.planning.reasons.coverage import MOVING, Covered
from vrts.dispatch.planning.reasons.refusals import NOT_COVERED
from vrts.engine.programs.signals import INPUTS
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Constant, Function, Global, Load, Place, WholeArray
from vrts.ir.module import Module, Program

_CLOCK = {
    Function.TIMER: "TIMER",
    Function.TIME: "TIME",
    Function.TIME_TEXT: "TIME",
    Function.DATE_TEXT: "DATE",
    Function.RANDOM: "RANDOM",
}
_ASKED = {
    Function.ADC: "analog input",
    Function.PENDANT: "pendant",
    Function.HAND: "hand",
    Function.STATE: "state of the robot",
    Function.STATUS: "state of a program",
}
_SIGNALS = (Function.SIG, Function.BITS)
_UNSET = (Function.DEFINED, Function.LAST)

Key = tuple[str, str]  # program, or "" for the controller's own, and name of a variable
Sources = frozenset[str]
NONE: Sources = frozenset()
Add = Callable[[str, object, Sources], None]  # program, place, and what it may hold


class Dependence(NamedTuple):
    """Which variables hold values from outside, and from where."""

    module: Module
    held: Mapping[Key, Sources]

    def of(self, program: str, node: object) -> Sources:
        """Return what the value of a part of the IR depends on."""
        return _sources(self.held, program, node)


def dependence(module: Module) -> Dependence:
    """Return what variables of a module depend on, spread until nothing is added."""
    held: dict[Key, Sources] = {}
    while _spread(module, held):
        pass
    return Dependence(module, held)


def _spread(module: Module, held: dict[Key, Sources]) -> bool:
    changed = False

    def add(program: str, place: object, sources: Sources) -> None:
        nonlocal changed
        if isinstance(place, Place | WholeArray) and sources:
            key = _key(program, place)
            before = held.get(key, NONE)
            if not sources <= before:
                held[key] = before | sources
                changed = True

    for program in module.programs.values():
        for instruction in program.instructions:
            for place, value in _given(instruction):
                add(program.name, place, _sources(held, program.name, value))
            if isinstance(instruction, ir.Prompt):
                for place in instruction.places:
                    add(program.name, place, frozenset(("operator",)))
            if isinstance(instruction, ir.Call):
                _passed(module, program, instruction, held, add)
    return changed


def _passed(
    module: Module, program: Program, call: ir.Call, held: Mapping[Key, Sources], add: Add
) -> None:
    """Spread through a call, both ways: arguments are passed by reference."""
    called = module.programs.get(call.program)
    if called is None:
        return
    for slot, argument in zip(called.formals, call.arguments, strict=False):
        if argument is None:
            continue
        formal = Place(slot)
        add(called.name, formal, _sources(held, program.name, argument))
        add(program.name, argument, held.get((called.name, slot.name), NONE))


def _given(instruction: ir.Instruction) -> tuple[tuple[Place, object], ...]:
    """Return which places an instruction gives values, and of what these are made."""
    match instruction:
        case ir.Assign(place, value):
            return ((place, value),)
        case ir.BeginFor(place, first, last, increment, _):
            return ((place, (first, last, increment)),)
        case ir.Decompose(place, location, _):
            return ((place, location),)
        case ir.Pack(place, first, length, text):
            return ((place, (first, length, text)),)
        case ir.AssignHere(place, frame):
            return ((place, frame),)
        case _:
            return ()


def _key(program: str, place: Place | WholeArray) -> Key:
    variable = place.variable
    return ("" if isinstance(variable, Global) else program, variable.name)


def _sources(held: Mapping[Key, Sources], program: str, node: object) -> Sources:
    match node:
        case Apply(function=function, arguments=arguments):
            own = _of_function(function, arguments)
            return own.union(*(_sources(held, program, part) for part in arguments))
        case Load(place=place):
            return _sources(held, program, place)
        case Place() | WholeArray():
            inside = node.subscripts if isinstance(node, Place) else ()
            found = held.get(_key(program, node), NONE)
            return found.union(*(_sources(held, program, part) for part in inside))
        case Constant():
            return NONE
        case tuple():
            parts: tuple[object, ...] = node  # pyright: ignore[reportUnknownVariableType]
            return NONE.union(*(_sources(held, program, part) for part in parts))
        case _:
            return NONE


def _of_function(function: Function, arguments: Sequence[object]) -> Sources:
    if function in _CLOCK:
        return frozenset((_CLOCK[function],))
    if function in _ASKED:
        return frozenset((_ASKED[function],))
    if function in _SIGNALS:
        return frozenset(filter(None, map(_signal, arguments)))
    if function in _UNSET:
        names = (a.variable.name for a in arguments if isinstance(a, Place | WholeArray))
        return frozenset(f"whether `{name}` has a value" for name in names)
    return NONE


def _signal(number: object) -> str | None:
    """Return the name of an input; None for a signal that the program itself sets."""
    value = number.value if isinstance(number, Constant) else None
    if not isinstance(value, float):
        return "inputs"  # which, is computed
    signal = abs(round(value))
    return f"input {signal}" if signal in INPUTS else None


# --- what is read, and what is not covered ------------------------------------------------------


def reads(known: Dependence) -> Reads:
    """Return all that the programs of a module read from outside."""
    found: set[str] = set()
    for program in known.module.programs.values():
        for instruction in program.instructions:
            found |= known.of(program.name, tuple(instruction))
            if isinstance(instruction, ir.React):
                found |= {_signal(instruction.signal) or "internal signal"}
            if isinstance(instruction, ir.Prompt):
                found.add("operator")
            if isinstance(instruction, ir.Grasp):
                found.add("hand")
    clocks = set(_CLOCK.values())
    unset = {name for name in found if name.startswith("whether ")}
    return Reads(
        tuple(sorted(found - clocks - unset)), tuple(sorted(found & clocks)), tuple(sorted(unset))
    )


def not_covered(
    known: Dependence, seen: Covered, is_tried: Callable[[str], bool]
) -> Iterator[Diagnostic]:
    """Yield a refusal for every place where the path depends on what was not tried.

    Args:
        known: What depends on what.
        seen: What scenarios executed.
        is_tried: Whether a source is tried in every way, whatever scenarios did.
    """
    for program in known.module.programs.values():
        told: set[int] = set()
        for index, (instruction, origin) in enumerate(
            zip(program.instructions, program.origins, strict=True)
        ):
            if (program.name, index) not in seen.executed or origin.step in told:
                continue
            said = _open(known, program, index, instruction, seen)
            if said is not None:
                why, what, remedy = said
                what = frozenset(source for source in what if not is_tried(source))
                if not what:
                    continue
                told.add(origin.step)
                yield error(
                    NOT_COVERED,
                    f"{why} in step {origin.step} of `{program.name}` depends on "
                    f"{', '.join(sorted(what))}",
                    Label(origin.span),
                    help=(remedy,),
                    data={"program": program.name, "step": origin.step},
                )


def _open(
    known: Dependence, program: Program, index: int, instruction: ir.Instruction, seen: Covered
) -> tuple[str, Sources, str] | None:
    """Return what of an executed instruction depends on what, untried, and what to do about it."""
    name = program.name
    ways = _ways(instruction, index)
    untried = [way for way in ways if (name, index, way) not in seen.followed]
    match instruction:
        case ir.JumpIf() | ir.TestCase() | ir.TestFor() | ir.Grasp():
            what = _decided_by(known, program, instruction)
            if what and untried and ways:
                return "one way", what, "add a `--scenario` in which the other way is taken"
        case ir.React(program=reaction):
            if (reaction or "") not in seen.reactions:
                what = frozenset((_signal(instruction.signal) or "a signal",))
                return "a reaction", what, "add a `--scenario` in which the signal comes"
        case ir.CallNamed():
            what = known.of(name, instruction.program)
            if what:
                return "the program that is called", what, _FIXED
        case ir.SetTool() | ir.SetBase() | ir.SetSpeed() | ir.SetBaseFrame():
            what = known.of(name, tuple(instruction))
            if what:
                return "a setting of motions", what, _FIXED
        case _ if isinstance(instruction, MOVING) and not isinstance(instruction, ir.Opaque):
            what = known.of(name, tuple(instruction))
            if what:
                return "where the arm goes", what, _FIXED
        case _:
            pass
    return None


_FIXED = "let a decision choose among fixed values, and try each in a `--scenario`"


def _decided_by(known: Dependence, program: Program, instruction: ir.Instruction) -> Sources:
    match instruction:
        case ir.JumpIf(condition=condition):
            return known.of(program.name, condition)
        case ir.TestCase(case=case, values=values):
            begun = (i for i in program.instructions if isinstance(i, ir.BeginCase))
            selectors = tuple(i.selector for i in begun if i.case == case)
            return known.of(program.name, (selectors, values))
        case ir.TestFor(loop=loop):
            begun_loops = (i for i in program.instructions if isinstance(i, ir.BeginFor))
            limits = tuple((i.first, i.last, i.increment) for i in begun_loops if i.loop == loop)
            return known.of(program.name, limits)
        case ir.Grasp():
            return frozenset(("hand",))
        case _:
            return NONE


def _ways(instruction: ir.Instruction, index: int) -> tuple[int, ...]:
    """Return the instructions that may come after a decision."""
    match instruction:
        case ir.JumpIf(target=target):
            return (index + 1, target)
        case ir.TestCase(otherwise=otherwise):
            return (index + 1, otherwise)
        case ir.TestFor(leave=leave):
            return (index + 1, leave)
        case ir.Grasp(missing=int(missing)):
            return (index + 1, missing)
        case _:
            return ()
