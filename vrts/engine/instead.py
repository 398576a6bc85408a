"""A run that goes on with other programs, of which nothing that differs was executed yet."""

from collections.abc import Iterable

from vrts.engine.code.executable import Executable
from vrts.engine.run import Run
from vrts.ir.module import Datum, Module


def instead(run: Run, module: Module, changed: Iterable[str], data: Iterable[Datum]) -> Run | None:
    """Return a run as it would have come to its horizon with other programs; None: nobody knows.

    What was executed keeps its places in the former text.

    Args:
        run: A run, no statement of which would have been another.
        module: The other programs, of the same names, and their data.
        changed: Names of the programs that differ.
        data: Values that differ.
    """
    machine = run.machine.copy()
    machine.write()
    before = machine.executable
    programs = Module({name: module.programs[name] for name in changed}, ())
    after = Executable(programs, before.call_depth, before)
    if after.layout.arrays != before.layout.arrays:
        return None
    after.module = module
    machine.take_over(after)
    memory = machine.system.memory
    after.layout.extend(memory)
    for datum in data:
        after.layout.variable(memory, datum.name, datum.subscripts).assign(
            datum.value, machine.finished
        )
    for context in (machine.robot, machine.process):
        for frame in context.frames:
            name = before.programs.loaded[frame.program].program.name
            frame.program = after.programs.numbers[name]
    return Run(machine, run.until_s, (machine,))
