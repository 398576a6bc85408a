"""Which statements the programs executed, and which program called which, as columns."""

from collections.abc import Mapping, Sequence

from vrts.engine.history import Code
from vrts.engine.memory.cells import Array, Bound
from vrts.engine.memory.trace import Activation, Trace
from vrts.engine.storage.cells import CellWriter
from vrts.engine.storage.columns import (
    NONE,
    ascending,
    check_below,
    check_firsts,
    column,
    counts_of,
    firsts,
    wholes,
)
from vrts.engine.storage.container import Table
from vrts.engine.storage.damage import require
from vrts.ir.module import Program

COUNTS = ("instructions", "begun", "counts", "rested", "resting", "changed")
PROGRAMS = ("robot", "process")

LAYOUT: Mapping[str, tuple[str, int]] = {
    "calls.program": ("<u4", 0),
    "calls.called_from": ("<i8", 0),  # number of an instruction
    "calls.caller": ("<i8", 0),  # row of the call of the program that called
    "calls.first": ("<u4", 0),  # row of its first argument
    "calls.slots": ("<u4", 0),  # numbers of names
    **{f"{program}.{part}": ("<u4", 0) for program in PROGRAMS for part in COUNTS},
    **{f"{program}.calls": ("<i8", 0) for program in PROGRAMS},  # rows of calls
}


def write_traces(traces: Mapping[str, Trace], finished: int, cells: CellWriter) -> dict[str, Table]:
    """Return the columns of both programs' traces, by the names in `PROGRAMS`."""
    calls: list[Activation] = []
    numbers: dict[int, int] = {}

    def number(activation: Activation | None) -> int:
        chain: list[Activation] = []
        at = activation
        while at is not None and id(at) not in numbers:
            chain.append(at)
            at = at.caller
        for new in reversed(chain):
            numbers[id(new)] = len(calls)
            calls.append(new)
        return NONE if activation is None else numbers[id(activation)]

    found: dict[str, Table] = {}
    for name, whole in traces.items():
        trace = whole.copy()
        trace.cut(finished)
        for part in COUNTS:
            found[f"{name}.{part}"] = column(getattr(trace, part), "<u4")
        found[f"{name}.calls"] = column([number(a) for a in trace.activations], "<i8")
    slots = [[cells.number(slot) for slot in call.slots] for call in calls]
    return {
        **found,
        "calls.program": column([call.program for call in calls], "<u4"),
        "calls.called_from": column(
            [NONE if call.called_from is None else call.called_from for call in calls], "<i8"
        ),
        "calls.caller": column([number(call.caller) for call in calls], "<i8"),
        "calls.first": firsts(len(part) for part in slots),
        "calls.slots": column([slot for part in slots for slot in part], "<u4"),
    }


def read_traces(
    tables: Mapping[str, Table], code: Code, bounds: Sequence[Bound], finished: int
) -> dict[str, Trace]:
    """Return both programs' traces.

    Raises:
        Damaged: The columns do not fit together, or not to the programs.
    """
    calls = _read_calls(tables, code, bounds)
    return {name: _read_trace(tables, name, code, calls, finished) for name in PROGRAMS}


def _read_calls(
    tables: Mapping[str, Table], code: Code, bounds: Sequence[Bound]
) -> list[Activation]:
    programs, places, callers, slots = (
        tables[f"calls.{part}"] for part in ("program", "called_from", "caller", "slots")
    )
    first = check_firsts(tables["calls.first"], len(slots), "calls")
    rows = len(programs) == len(places) == len(callers) == len(first) - 1
    require(rows, "columns of calls differ in length")
    check_below(programs, len(code.programs), "the programs of calls")
    check_below(places, len(code.causes), "the steps of calls", NONE)
    check_below(callers, len(programs), "the callers of calls", NONE)
    check_below(slots, len(bounds), "the arguments of calls")
    own = wholes(slots)
    found: list[Activation] = []
    for row, (program, place, caller) in enumerate(
        zip(wholes(programs), wholes(places), wholes(callers), strict=True)
    ):
        require(caller < row, "a call comes before its caller")
        given = [bounds[number] for number in own[first[row] : first[row + 1]]]
        require(_fits(code.programs[program], given), "a call has other arguments")
        found.append(
            Activation(
                program,
                given,
                None if place == NONE else place,
                None if caller == NONE else found[caller],
            )
        )
    return found


def _fits(program: Program, slots: Sequence[Bound]) -> bool:
    wanted = [slot.number in program.array_formals for slot in (*program.formals, *program.autos)]
    return [isinstance(slot, Array) for slot in slots] == wanted


def _read_trace(
    tables: Mapping[str, Table],
    name: str,
    code: Code,
    calls: Sequence[Activation],
    finished: int,
) -> Trace:
    columns = {part: tables[f"{name}.{part}"] for part in (*COUNTS, "calls")}
    check_below(columns["instructions"], len(code.causes), "statements")
    check_below(columns["resting"], len(code.causes), "statements")
    check_below(columns["calls"], len(calls), "calls", NONE)
    check_below(columns["counts"], len(columns["instructions"]) + 1, "statements")
    for pair in (("begun", "counts"), ("rested", "resting"), ("changed", "calls")):
        require(len(columns[pair[0]]) == len(columns[pair[1]]), "columns differ in length")
    for part in ("begun", "counts", "rested", "changed"):
        require(ascending(columns[part]), "statements are not in order")
    for part in ("begun", "rested", "changed"):
        check_below(columns[part], finished + 1, "statements")
    trace = Trace()
    for part in COUNTS:
        setattr(trace, part, counts_of(columns[part]))
    trace.activations = [None if row == NONE else calls[row] for row in wholes(columns["calls"])]
    return trace
