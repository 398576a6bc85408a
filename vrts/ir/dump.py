"""Stable text of a module: for people, tests and bug reports (`--emit ir`).

One line an instruction: its index, its step, its name and operands. Jumps name indices.
"""

from enum import Enum

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.base.stack import deep_stack
from vrts.base.units import deg
from vrts.ir.expressions import (
    Apply,
    Binary,
    Compose,
    Constant,
    Expression,
    Format,
    Global,
    Load,
    Place,
    Slot,
    Unary,
    WholeArray,
)
from vrts.ir.instructions import Call, CallNamed, Instruction
from vrts.ir.module import Module, Program
from vrts.ir.values import Type, Value

_WORDS = frozenset({"not", "com"})


@deep_stack()
def dump(module: Module) -> str:
    """Return the text form of a module. The same module gives the same bytes."""
    parts = [_program(program) for program in module.programs.values()]
    if module.data:
        lines = ["data"]
        for datum in module.data:
            subscripts = f"[{','.join(map(str, datum.subscripts))}]" if datum.subscripts else ""
            lines.append(f"  {datum.name}{subscripts} = {_value(datum.value)}")
        parts.append("\n".join(lines))
    return "\n\n".join(parts) + "\n"


def _program(program: Program) -> str:
    formals = ", ".join(
        f"{slot.name or '_'}{'[]' if slot.number in program.array_formals else ''}: "
        f"{slot.type.value}"
        for slot in program.formals
    )
    lines = [f"program {program.name}({formals})"]
    if program.autos:
        lines[0] += " auto " + ", ".join(
            f"{slot.name}: {slot.type.value}" for slot in program.autos
        )
    for index, (instruction, origin) in enumerate(
        zip(program.instructions, program.origins, strict=True)
    ):
        lines.append(f"{index:4} {origin.step:4}  {_instruction(instruction)}")
    return "\n".join(lines)


def _instruction(instruction: Instruction) -> str:
    parts = [type(instruction).__name__.lower()]
    for field, operand in zip(instruction._fields, instruction, strict=True):
        if operand is None or isinstance(operand, Span):
            continue
        if isinstance(instruction, Call | CallNamed) and field == "arguments":
            parts.append(f"arguments=({', '.join(map(_passed, instruction.arguments))})")
        else:
            parts.append(f"{field}={text_of(operand)}")
    return " ".join(parts)


def _passed(argument: Expression | Place | WholeArray | None) -> str:
    """Return an argument; `&` marks what is passed by reference."""
    if argument is None:
        return "_"
    mark = "&" if isinstance(argument, Place | WholeArray) else ""
    return mark + text_of(argument)


def text_of(operand: object) -> str:
    """Return an operand or expression as text, fully parenthesised."""
    match operand:
        case Constant(value):
            return _value(value)
        case Load(place):
            return text_of(place)
        case Place(variable, subscripts):
            inside = ",".join(map(text_of, subscripts))
            return _variable(variable) + (f"[{inside}]" if subscripts else "")
        case WholeArray(variable):
            return f"{_variable(variable)}[]"
        case Unary(operator, inner):
            blank = " " if operator.value in _WORDS else ""
            return f"({operator.value}{blank}{text_of(inner)})"
        case Binary(operator, left, right):
            return f"({text_of(left)} {operator.value} {text_of(right)})"
        case Apply(function, arguments):
            inside = ", ".join("_" if a is None else text_of(a) for a in arguments)
            return f"{function.value}({inside})"
        case Compose(parts):
            return ":".join(map(text_of, parts))
        case Format(kind, width, decimals):
            size = "" if width is None else str(width)
            return f"/{kind.value}{size}" + ("" if decimals is None else f".{decimals}")
        case Enum():
            return str(operand.value)
        case tuple():
            return "(" + ", ".join("_" if o is None else text_of(o) for o in operand) + ")"  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
        case _:
            return str(operand).lower() if isinstance(operand, bool) else str(operand)


def _variable(variable: Global | Slot) -> str:
    kind = {Type.REAL: "r", Type.POSE: "p", Type.DYNAMIC: "?"}.get(variable.type, "")
    mark = f":{kind}" if kind else ""
    return f"{variable.name}{mark}" if isinstance(variable, Global) else f"%{variable.name}{mark}"


def _value(value: Value) -> str:
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, Pose):
        return "trans(" + ", ".join(_number(c) for c in components(value)) + ")"
    if isinstance(value, tuple):
        return "#ppoint(" + ", ".join(_number(deg(joint)) for joint in value) + ")"
    return f"{value:.9g}"


def _number(value: float) -> str:
    return f"{round(value, 4) + 0.0:g}"
