"""Numbers and conditions of the program as expressions of G-code.

TRUE is -1 in VAL-II and 1 in G-code: a comparison is turned into the one or the other by what is
made of it. What has to be worked out before the line is given to `before`.
"""

from collections.abc import Callable

from vrts.dispatch.linuxcnc.memory import Memory
from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.signals import FIRST_INPUT, FIRST_INTERNAL, bits_of, signal_of
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.timers import timer_of
from vrts.ir.expressions import (
    Apply,
    Argument,
    Binary,
    BinaryOperator,
    Constant,
    Expression,
    Function,
    Load,
    Place,
    Slot,
    Unary,
    UnaryOperator,
)

COMPARISONS = {
    BinaryOperator.EQUAL: "EQ",
    BinaryOperator.NOT_EQUAL: "NE",
    BinaryOperator.LESS: "LT",
    BinaryOperator.LESS_EQUAL: "LE",
    BinaryOperator.GREATER: "GT",
    BinaryOperator.GREATER_EQUAL: "GE",
}
LOGIC = {BinaryOperator.AND: "AND", BinaryOperator.OR: "OR", BinaryOperator.XOR: "XOR"}
ARITHMETIC = {
    BinaryOperator.ADD: "+",
    BinaryOperator.SUBTRACT: "-",
    BinaryOperator.MULTIPLY: "*",
    BinaryOperator.DIVIDE: "/",
}
FUNCTIONS = {
    Function.ABS: "ABS",
    Function.SIN: "SIN",
    Function.COS: "COS",
    Function.TAN: "TAN",
    Function.SQRT: "SQRT",
}
COORDINATES = {Function.DX: 9, Function.DY: 10, Function.DZ: 11}

CLOCK = "o<v_clock> call"

Address = Callable[[Expression], str]


class Values:
    """Writes the numbers and conditions of one program."""

    def __init__(self, memory: Memory, table: Table, before: list[str], address: Address) -> None:
        """Share what is known of variables and signals.

        Args:
            memory: Where variables are kept.
            table: Inputs and outputs.
            before: Takes the lines that come first.
            address: Tells where a location is, worked out before the line.
        """
        self.memory, self.table, self.before, self.address = memory, table, before, address
        self._named = 0

    def real(self, e: Expression) -> str:
        """Return a number."""
        match e:
            case Constant(float(value)):
                return number(value)
            case Load(place):
                return self.place(place)
            case Unary(UnaryOperator.MINUS, operand):
                return f"[0 - {self.real(operand)}]"
            case Unary(UnaryOperator.NOT):
                return f"[0 - {self.condition(e)}]"
            case Binary(operator) if operator in COMPARISONS or operator in LOGIC:
                return f"[0 - {self.condition(e)}]"
            case Binary(operator, left, right) if operator in ARITHMETIC:
                return f"[{self.real(left)} {ARITHMETIC[operator]} {self.real(right)}]"
            case Binary(BinaryOperator.MOD, left, right):
                one, other = (self.kept(f"[{self.real(part)}]") for part in (left, right))
                return f"[{one} - {other}*{self._whole(f'{one}/{other}')}]"
            case Binary(BinaryOperator.POWER, left, right):
                return f"[{self.real(left)} ** {self.real(right)}]"
            case Apply(Function.SIG):
                return f"[0 - {self.condition(e)}]"
            case Apply():
                return self._apply(e)
            case _:
                raise CannotSay(
                    "LinuxCNC has nothing that means this", "work the value out otherwise"
                )

    def condition(self, e: Expression) -> str:
        """Return 1 where an expression is true, 0 where it is false."""
        match e:
            case Binary(operator, left, right) if operator in COMPARISONS:
                return f"[{self.real(left)} {COMPARISONS[operator]} {self.real(right)}]"
            case Binary(operator, left, right) if operator in LOGIC:
                return f"[{self.condition(left)} {LOGIC[operator]} {self.condition(right)}]"
            case Unary(UnaryOperator.NOT, operand):
                return f"[1 - {self.condition(operand)}]"
            case Apply(Function.SIG, arguments):
                return self._signals(arguments)
            case _:
                return f"[{self.real(e)} NE 0]"

    def place(self, place: Place) -> str:
        """Return the parameter that holds a number."""
        variable = place.variable
        if isinstance(variable, Slot):
            if place.subscripts:
                raise CannotSay("LinuxCNC passes no arrays", "use an array that all programs know")
            return f"#<{plain(variable.name)}>"
        kept = self.memory.of(place)
        if kept is None:
            return f"#<_val_{plain(variable.name)}>"
        return f"#[{self.element(place)}]"

    def element(self, place: Place) -> str:
        """Return the address of a global location, or of an element of an array."""
        kept = self.memory.of(place)
        assert kept is not None
        if kept.elements is None or not place.subscripts:
            return f"#<{kept.parameter}>"
        (subscript,) = place.subscripts
        if isinstance(subscript, Constant) and isinstance(subscript.value, float):
            return f"#<{kept.parameter}> + {kept.width * round(subscript.value)}"
        at = self.real(subscript)
        called = f"o<v_element> call [#<{kept.parameter}>] [{at}] [{kept.elements}] [{kept.width}]"
        self.before.append(called)
        return self.kept("#<_v_at>")

    def kept(self, value: str) -> str:
        """Return a parameter of this program that keeps a value which the library gave."""
        self._named += 1
        name = f"#<k{self._named}>"
        self.before.append(f"{name} = {value}")
        return name

    def _signals(self, arguments: tuple[Argument, ...]) -> str:
        parts: list[str] = []
        for argument in arguments:
            signal, on = signal_of(argument)
            if signal >= FIRST_INTERNAL:
                read = f"#<_signal_{signal}>"
            elif signal >= FIRST_INPUT:
                self.before.append(f"o<v_input> call [{self.table.input(signal)}]")
                read = self.kept("#<_v_read>")
            else:
                read = f"#<_out_{signal}>"  # what the program has set
            parts.append(f"[{read} {'NE' if on else 'EQ'} 0]")
        return parts[0] if len(parts) == 1 else f"[{' AND '.join(parts)}]"

    def _whole(self, text: str) -> str:
        value = self.kept(f"[{text}]")  # FIX goes down, VAL-II's INT towards 0
        return f"[FIX[{value}] + [[{value} LT 0] AND [FIX[{value}] NE {value}]]]"

    def _apply(self, e: Apply) -> str:
        function, arguments = e.function, e.arguments
        if function in COORDINATES:
            return f"#[{self.address(_expression(arguments[0]))} + {COORDINATES[function]}]"
        if function is Function.DISTANCE:
            one, other = (self.kept(f"[{self.address(_expression(a))}]") for a in arguments)
            squares = (f"[#[{one} + {k}] - #[{other} + {k}]] ** 2" for k in (9, 10, 11))
            return f"SQRT[{' + '.join(squares)}]"
        if function is Function.BITS:
            bits = bits_of(*(*arguments, None)[:2])
            each = (self._signals((Constant(float(signal)),)) for signal in bits)
            return f"[{' + '.join(f'{2**k}*{bit}' for k, bit in enumerate(each))}]"
        if function is Function.TIMER:
            timer = timer_of(arguments[0])
            self.before.append(CLOCK)
            return self.kept(f"[#<_v_now> - #<_timer_{timer}>]")
        values = [self.real(_expression(argument)) for argument in arguments]
        match function:
            case _ if function in FUNCTIONS:
                return f"{FUNCTIONS[function]}[{values[0]}]"
            case Function.ATAN2:
                return f"ATAN[{values[0]}]/[{values[1]}]"
            case Function.SQR:
                return f"[{values[0]} * {values[0]}]"
            case Function.INT:
                return self._whole(values[0])
            case Function.SIGN:
                return f"[2*[{values[0]} GE 0] - 1]"
            case Function.MIN | Function.MAX if len(values) == 2:
                sign = "-" if function is Function.MIN else "+"
                one, other = (self.kept(f"[{value}]") for value in values)
                return f"[[{one} + {other} {sign} ABS[{one} - {other}]] / 2]"
            case _:
                raise CannotSay(f"LinuxCNC has nothing that means {function.value.upper()}")


def _expression(argument: Argument) -> Expression:
    if isinstance(argument, Constant | Load | Unary | Binary | Apply) or (
        argument is not None and type(argument).__name__ == "Compose"
    ):
        return argument  # type: ignore[return-value]
    raise CannotSay("an argument is left out", "write it")
