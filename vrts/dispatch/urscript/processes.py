"""The second program of VAL-II as a thread of URScript: its cycles, beside the first program.

It has functions of its own (`beside_...`), which move nothing. It ends with the first program, as
every thread of URScript does.
"""

from typing import NamedTuple

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.parts import constant
from vrts.dispatch.saying.reactions import Shared, called, executed, shared
from vrts.dispatch.urscript.values import Values
from vrts.ir import instructions as ir
from vrts.ir.module import Module

STATE = ("global v_cycles = 0.0", "global v_beside = False")
THREAD = """
thread v_beside_NAME():
  while norm(v_cycles) > 0.5:
    beside_NAME()
    if v_cycles > 0.5:
      global v_cycles = v_cycles - 1.0
    end
    sync()
  end
  global v_beside = False
end
"""


class Processes(NamedTuple):
    """The programs that are started beside the first one."""

    programs: tuple[str, ...]
    shared: Shared  # with the programs of the first
    module: Module

    def threads(self) -> list[str]:
        """Return the threads, which stand behind the programs that they carry out."""
        rows: list[str] = []
        for name in self.programs:
            rows += THREAD.strip("\n").replace("NAME", plain(name)).split("\n")
        return rows

    def start(self, step: ir.StartProcess, values: Values) -> list[str]:
        """Return the lines of PCEXECUTE.

        Raises:
            CannotSay: URScript cannot do it so.
        """
        if step.program is None or step.step is not None:
            raise CannotSay(
                "PCEXECUTE goes on with a program, or begins at a step", "name it alone"
            )
        if self.module.programs[step.program].formals:
            raise CannotSay(f"`{step.program}` takes arguments and is started beside this one")
        cycles = "1.0" if step.cycles is None else values.real(step.cycles)
        return [
            f"global v_cycles = {cycles}",
            "global v_beside = True",
            f"global v_thread = run v_beside_{plain(step.program)}()",
        ]


def end(step: ir.EndProcess) -> list[str]:
    """Return the lines of PCEND: the cycle under way is the last one.

    Raises:
        CannotSay: It takes back what was said before.
    """
    mode = 1.0 if step.mode is None else constant(step.mode)
    if mode is None or mode < 0.0:
        raise CannotSay("PCEND takes back that the program ends", "write PCEND where it is to end")
    return ["global v_cycles = 0.0"]


def abort() -> list[str]:
    """Return the lines of PCABORT."""
    return ["if v_beside:", "  kill v_thread", "  global v_beside = False", "end"]


def processes(module: Module, entry: str) -> Processes | None:
    """Return the programs that are started beside the first; None: there are none."""
    steps = (s for name in executed(module, (entry,)) for s in module.programs[name].instructions)
    found = (s.program for s in steps if isinstance(s, ir.StartProcess))
    programs = tuple(dict.fromkeys(name for name in found if name is not None))
    if not programs:
        return None
    return Processes(programs, shared(module, called(module, programs)), module)
