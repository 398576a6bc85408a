"""The plainest way to execute the IR: walk the trees, dispatch on types, keep nothing."""

from collections.abc import Callable
from typing import Any, cast

from vrts.base.numbers import single
from vrts.ir import expressions as x
from vrts.ir import instructions as ir
from vrts.ir.module import Module, Program

OPERATORS: dict[x.BinaryOperator, Callable[[float, float], float]] = {
    x.BinaryOperator.ADD: lambda a, b: single(a + b),
    x.BinaryOperator.SUBTRACT: lambda a, b: single(a - b),
    x.BinaryOperator.MULTIPLY: lambda a, b: single(a * b),
    x.BinaryOperator.DIVIDE: lambda a, b: single(a / b),
    x.BinaryOperator.MOD: lambda a, b: a - b * int(a / b),
    x.BinaryOperator.EQUAL: lambda a, b: -1.0 if a == b else 0.0,
    x.BinaryOperator.GREATER: lambda a, b: -1.0 if a > b else 0.0,
}


def walk(module: Module) -> int:
    """Execute the first program; return how many statements that took."""
    memory: dict[Any, Any] = {}
    for datum in module.data:
        memory[(datum.name, *datum.subscripts)] = datum.value
    assert module.main is not None
    return _program(module, module.programs[module.main], memory, {})


def _program(
    module: Module, program: Program, memory: dict[Any, Any], slots: dict[int, Any]
) -> int:
    index = done = 0
    limits: dict[int, tuple[float, float]] = {}
    while True:
        instruction = program.instructions[index]
        done += 1
        index += 1
        match instruction:
            case ir.Assign(place=place, value=value):
                memory[_key(place, memory, slots)] = _value(value, memory, slots)
            case ir.Jump(target=target):
                index = target
            case ir.JumpIf(condition=condition, when=when, target=target):
                if (_value(condition, memory, slots) != 0.0) is when:
                    index = target
            case ir.BeginFor(place=place, first=first, last=last, increment=by, loop=loop):
                memory[_key(place, memory, slots)] = _value(first, memory, slots)
                step = 1.0 if by is None else _value(by, memory, slots)
                limits[loop] = (_value(last, memory, slots), step)
            case ir.TestFor(place=place, loop=loop, leave=leave):
                if memory[_key(place, memory, slots)] > limits[loop][0]:
                    index = leave
            case ir.NextFor(place=place, loop=loop, test=test):
                key = _key(place, memory, slots)
                memory[key] = single(memory[key] + limits[loop][1])
                index = test
            case ir.Call(program=name, arguments=arguments):
                given: dict[int, Any] = {}
                for k, argument in enumerate(arguments):
                    if isinstance(argument, x.WholeArray):
                        given[k] = argument.variable.name
                    elif isinstance(argument, x.Place):
                        given[k] = _key(argument, memory, slots)
                done += _program(module, module.programs[name], memory, given)
            case ir.Return():
                return done
            case ir.React():
                pass
            case _:
                raise ValueError(f"{type(instruction).__name__} is not walked")


def _key(place: x.Place, memory: dict[Any, Any], slots: dict[int, Any]) -> Any:
    variable = place.variable
    name: Any = slots[variable.number] if isinstance(variable, x.Slot) else variable.name
    if not place.subscripts:
        if isinstance(name, tuple):
            return cast("Any", name)
        return (name,)
    subscripts: list[int] = [int(_value(s, memory, slots)) for s in place.subscripts]
    return (str(name), *subscripts)


def _value(expression: x.Expression, memory: dict[Any, Any], slots: dict[int, Any]) -> Any:
    match expression:
        case x.Constant(value=value):
            return value
        case x.Load(place=place):
            return memory[_key(place, memory, slots)]
        case x.Binary(operator=operator, left=left, right=right):
            return OPERATORS[operator](_value(left, memory, slots), _value(right, memory, slots))
        case _:
            raise ValueError(f"{type(expression).__name__} is not walked")
