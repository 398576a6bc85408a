"""Functions that ask the controller: timers, speeds, switches, states, errors, date and time.

The controller's clock begins at a fixed instant, so that a run is the same whenever it is made.
"""

import math
from datetime import datetime, timedelta

from vrts.base.numbers import round_half_away
from vrts.base.source import Span
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.values.arithmetic import integer, logical, rounded
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import parameter_cell
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.records import Ending
from vrts.engine.programs.context import Context
from vrts.ir.expressions import Apply, Constant, Function
from vrts.ir.ranges import ANALOG_INPUTS
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.taken import TAKEN_SWITCHES
from vrts.ir.values import Value

POWERED_UP = datetime(1988, 1, 1)
MONTHS = ("JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC")
ENDS = (ANALOG_INPUTS[0], ANALOG_INPUTS[-1])
MEMORY_CELLS = 100_000  # of a controller that is empty; FREE tells the share left [assumed]
UNDER_PROGRAM_CONTROL = 7.0  # STATE(1) [assumed, manual language/functions#state]
AT_REST, MOVING, STOPPING = 0.0, 1.0, 2.0  # STATE(2) [assumed, manual language/functions#state]
UNKNOWN, IDLE, RUNNING, PAUSED, WAITING = -1.0, 0.0, 1.0, 2.0, 3.0  # STATUS [assumed]


def controller_function(compiler: Compiler, expression: Apply) -> Evaluate:
    """Return a closure that asks the controller."""
    span, arguments = expression.span, expression.arguments
    match expression.function:
        case Function.SWITCH:
            return _switch(_name(expression), span)
        case Function.PARAMETER:
            given = arguments[1] if len(arguments) > 1 else None
            which = compiler.real_argument(given) if given is not None else None
            name = _name(expression)

            def read(c: Context) -> Value:
                index = None if which is None else which(c)
                return parameter(c, name, parameter_cell(name, index, span), span)

            return read
        case Function.ADC:
            channel = compiler.real_argument(arguments[0])

            def analog(c: Context) -> Value:
                number = integer(channel(c), span, *ENDS, "analog input")
                return float(c.signals.count(number))

            return analog
        case Function.PENDANT:
            key = compiler.real_argument(arguments[0])

            def pressed(c: Context) -> Value:
                key(c)
                return 0.0  # nobody presses a key

            return pressed
        case Function.PRIORITY:
            return lambda c: float(c.priority)
        case Function.STATE:
            selector = compiler.real_argument(arguments[0])
            return lambda c: _state(c, round_half_away(selector(c)))
        case Function.STATUS:
            program = compiler.string_argument(arguments[0])
            return lambda c: _status(c, program(c).strip().lower())
        case Function.ERROR:
            source = arguments[0] if arguments else None
            ask = compiler.real_argument(source) if source is not None else None

            def error(c: Context) -> Value:
                if ask is not None:
                    ask(c)
                return float(c.last_error.number) if c.last_error is not None else 0.0

            return error
        case Function.ERROR_TEXT:
            code = compiler.real_argument(arguments[0])
            return lambda c: error_words(round_half_away(code(c)))
        case Function.FREE:
            selector = compiler.real_argument(arguments[0])

            def free(c: Context) -> Value:
                selector(c)
                share = c.memory.size / MEMORY_CELLS
                return rounded(100.0 * max(1.0 - share, 0.0), span)

            return free
        case Function.TIME:
            return lambda c: _seconds_of_day(c, span)
        case Function.TIME_TEXT:
            return lambda c: f"{_date(_clock(c), 2)} {_clock(c):%H:%M:%S}"
        case Function.DATE_TEXT:
            return lambda c: _date(_clock(c), 4)
        case _:
            raise ValueError(f"function without a meaning: {expression.function}")


def read_timer(c: Context, number: int) -> float:
    """Return the seconds of a timer; one never set reads as TIMER(0), the time since power-up."""
    c.system.clock_reads += 1
    return c.now - c.system.timers.get(number, 0.0)


def hand_state(c: Context) -> float:
    """HAND: 1 when a pneumatic hand is open, else 0."""
    return 1.0 if c.hand.opening(c.now) >= 0.5 * c.hand.gripper.opening_max else 0.0


def speed(c: Context, which: int) -> float:
    """SPEED: 1 the monitor speed, 2 the permanent program speed, 3 that of the next motion."""
    planner = c.planner
    if which == 1:
        return 100.0 * planner.scale.rate
    settings = planner.settings.always
    if which == 3 and "speed" in planner.settings.next:
        settings = settings._replace(speed=planner.settings.next["speed"])  # type: ignore[arg-type]
    return settings.speed.value


def error_words(number: int) -> str:
    """Return VAL's words for the number of a run-time error; empty for an unknown one."""
    for kind in RuntimeErrorKind:
        if kind is RuntimeErrorKind.JOINT_OUT_OF_RANGE:
            joint = kind.value.number - number
            if 1 <= joint <= 6:
                return f"*{kind.value.words.format(joint=joint)}*"
        elif kind.value.number == number:
            return f"*{kind.value.words}*"
    return ""


def _name(expression: Apply) -> str:
    named = expression.arguments[0]
    assert isinstance(named, Constant)
    return str(named.value).upper()


def _switch(name: str, span: Span | None) -> Evaluate:
    def state(c: Context) -> Value:
        if name not in SWITCHES and name not in TAKEN_SWITCHES:
            raise RuntimeFault(
                RuntimeErrorKind.INVALID_SWITCH, f"there is no switch `{name}`", span
            )
        return logical(c.system.is_on(name))

    return state


def parameter(c: Context, name: str, wanted: str, span: Span | None) -> float:
    """Return what a parameter is.

    Args:
        c: The program that asks.
        name: Of the parameter, upper case.
        wanted: The same with its index, if it has one.
        span: What asks.

    Raises:
        RuntimeFault: There is no such parameter, or no such index.
    """
    known = PARAMETERS.get(name)
    if known is None:
        return rounded(c.system.parameter(wanted, 0.0), span)
    arm, gripper, model = c.planner.arm, c.hand.gripper, c.planner.model
    of_the_robot = {
        "HAND.TIME": gripper.stroke_time
        if model.programs.hand_s is None
        else model.programs.hand_s,
        "SPEED.MAX": model.pace.most_speed_percent,
        "HAND.MAX": 1e3 * gripper.opening_max,
        "VEL.LIN": 1e3 * arm.linear_speed,
        "TACC": arm.acceleration_time,
    }
    otherwise = of_the_robot.get(name, known.value or 0.0)
    if name == "NEST.POS":
        otherwise = math.degrees(arm.ready[known.cells.index(wanted)])
    return rounded(c.system.parameter(wanted, otherwise), span)


def _state(c: Context, which: int) -> float:
    if which == 1:
        return UNDER_PROGRAM_CONTROL
    if which == 2:
        if c.planner.braking_until > c.now:
            return STOPPING
        return MOVING if c.planner.motion_end > c.now else AT_REST
    return 0.0


def _status(c: Context, name: str) -> float:
    if name not in c.system.programs.numbers:
        return UNKNOWN
    for program in (c.robot, c.process):
        if program.program == name:
            if program.running:
                blocked = program is not c and program.phase and program.wake > c.now
                return WAITING if blocked else RUNNING
            if program.frames and program.ending is not Ending.COMPLETED:
                return PAUSED
    return IDLE


def _clock(c: Context) -> datetime:
    c.system.clock_reads += 1
    return POWERED_UP + timedelta(seconds=c.now)


def _date(day: datetime, digits: int) -> str:
    return f"{day.day:02d}-{MONTHS[day.month - 1]}-{str(day.year)[-digits:]}"


def _seconds_of_day(c: Context, span: Span | None) -> float:
    now = _clock(c)
    return rounded(float(3600 * now.hour + 60 * now.minute + now.second), span)
