"""Which programs are executed, and in which order they have to be written."""

from vrts.dispatch.saying.cannot import CannotSay
from vrts.ir import instructions as ir
from vrts.ir.module import Module


def called_by(module: Module, *entries: str) -> list[str]:
    """Return the programs that some lead to by calls, each after those that it calls.

    Raises:
        CannotSay: One comes to call itself.
    """
    order: list[str] = []

    def visit(name: str, above: tuple[str, ...]) -> None:
        if name in above:
            raise CannotSay(f"`{name}` comes to call itself", "use a loop")
        if name in order or name not in module.programs:
            return
        for instruction in module.programs[name].instructions:
            if isinstance(instruction, ir.Call):
                visit(instruction.program, (*above, name))
        order.append(name)

    for entry in entries:
        visit(entry, ())
    return order
