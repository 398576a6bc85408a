"""Instructions without structure to the IR."""

from vrts.base.numbers import single
from vrts.base.source import SourceFile
from vrts.ir import expressions as x
from vrts.ir import instructions as i
from vrts.ir.module import Origin
from vrts.lang.dialect import Angles
from vrts.lang.joined import span_in
from vrts.lang.lowering.values import ValueLowering
from vrts.lang.meaning.forms import device_is_opaque, prompt_parts
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Element,
    FormatItem,
    Item,
    Name,
    Number,
    Prefix,
    Variable,
)
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Device,
    Give,
    Put,
    ReactStatement,
    Rest,
    Setting,
    Simple,
    SpeedStatement,
)
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

ACCURACY_FINE = 1.0  # [mm] AS's normal accuracy; what is larger is COARSE [assumed]
# what VAL's channels lack to be inputs of VAL-II [assumed, manual language/signals#channels]
FIRST_INPUT = 1000.0
MAX_TEXT = 60  # characters of an instruction in a message

_UNITS = {None: i.SpeedUnit.PERCENT, "MMPS": i.SpeedUnit.MM_PER_S, "IPS": i.SpeedUnit.INCH_PER_S}
_PER_MINUTE = {"MM/MIN": 1.0 / 60.0, "CM/MIN": 10.0 / 60.0}  # to mm/s


class InstructionLowering(ValueLowering):
    """Lowers the instructions of one program, one after the other."""

    def __init__(
        self, source: SourceFile, scope: Scope, types: NameUses, program: ProgramText
    ) -> None:
        super().__init__(source, scope, types, program.name)
        self.code: list[i.Instruction] = []
        self.origins: list[Origin] = []
        self.gotos: list[tuple[int, int | str]] = []  # instruction, label
        self.origin = Origin(1, span_in(source, program.start, program.end))

    def _emit(self, instruction: i.Instruction) -> int:
        self.code.append(instruction)
        self.origins.append(self.origin)
        return len(self.code) - 1

    def simple(self, node: Simple) -> None:
        """Lower an instruction with a plain list of operands."""
        word = node.word
        values = [self._optional(v) for v in node.operands if not isinstance(v, FormatItem)]
        first = values[0] if values else None
        joint, linear = i.Interpolation.JOINT, i.Interpolation.LINEAR
        match word:
            case "MOVE" | "MOVES" if len(values) > 1:
                self._clamping(node)
            case "MOVE" | "MOVES" | "APPRO" | "APPROS":
                assert first is not None
                retreat = values[1] if len(values) > 1 else None
                self._emit(i.Move(linear if word[-1] == "S" else joint, first, retreat))
            case "MOVET" | "MOVEST":
                assert first is not None
                path = linear if word == "MOVEST" else joint
                self._emit(i.Move(path, first, None, values[1]))
            case "DEPART" | "DEPARTS":
                assert first is not None
                self._emit(i.Depart(linear if word[-1] == "S" else joint, first))
            case "DRIVE":
                change = values[1]
                assert first is not None
                assert change is not None
                self._emit(i.Drive(first, change, values[2] if len(values) > 2 else None))
            case "READY":
                self._emit(i.Ready())
            case "DELAY":
                assert first is not None
                self._emit(i.Delay(first))
            case "BREAK":
                self._emit(i.Break())
            case "RETURN":
                self._emit(i.Return(first))
            case "RETURNE":
                self._emit(i.ReturnError())
            case "FLIP" | "NOFLIP":
                self._emit(i.RequestBranch(i.BranchRequest(word.lower())))
            case "ALIGN":
                self._emit(i.Align())
            case "NEST":
                self._emit(i.Nest())
            case "BRAKE":
                self._emit(i.Brake())
            case "DRAW" | "TDRAW":
                padded = (*values, *([None] * 7))
                self._emit(i.Draw(tuple(padded[:6]), word == "TDRAW", padded[6]))
            case "GRASP":
                assert first is not None
                at = self._emit(i.Grasp(first))
                if len(node.operands) > 1:
                    label = node.operands[1]
                    assert isinstance(label, Number)
                    self.gotos.append((at, int(label.value)))
            case "OPEN" | "CLOSE" | "RELAX" | "OPENI" | "CLOSEI" | "RELAXI":
                if first is not None and self.dialect.is_as:  # the number of a clamp
                    if not _is_hand(node.operands[0]):
                        self._emit(i.Opaque(self._text(node)))
                        return
                    first = None
                action = i.HandAction(word.removesuffix("I").lower())
                self._emit(i.MoveHand(action, word[-1] == "I", first))
            case "TOOL":
                self._emit(i.SetTool(first))
            case "BASE" if self.dialect.is_as:
                self._emit(i.SetBaseFrame(first or x.Apply(x.Function.NULL)))
            case "BASE":
                self._emit(i.SetBase(*(values + [None] * 4)[:4]))
            case "STOP":
                self._emit(i.Stop(first))
            case "HALT":
                self._emit(i.Halt(first))
            case "PAUSE":
                self._emit(i.Pause(first))
            case "SIGNAL":
                self._emit(i.Signal(tuple(v for v in values if v is not None)))
            case "WAIT" if self.dialect.is_val and first is not None:
                channel = self._input(first)
                self._emit(i.Wait(x.Apply(x.Function.SIG, (channel,), self.origin.span)))
            case "WAIT":
                self._emit(i.Wait(first))
            case "TYPE":
                self._emit(i.Type(self.written(node.operands)))
            case "TYPEI":
                assert first is not None
                self._emit(i.Type((first,)))
            case "RESET":
                self._emit(i.Reset())
            case "ENABLE" | "DISABLE":
                names = tuple(o.text.upper() for o in node.operands if isinstance(o, Name))
                self._emit(i.Switch(names, word == "ENABLE"))
            case "PROMPT":
                text, variables = prompt_parts(node.operands)
                places = tuple(self.place(v) for v in variables if isinstance(v, Name | Element))
                self._emit(i.Prompt(None if text is None else self.value(text), places))
            case "LOCK":
                self._emit(i.Lock(first))
            case "REACTE":
                self._emit(i.ReactError(_program(node.operands)))
            case "PCEXECUTE":
                cycles, step = (*values[1:], None, None)[:2]
                self._emit(i.StartProcess(_program(node.operands), cycles, step))
            case "PCABORT":
                self._emit(i.AbortProcess())
            case "PCEND":
                self._emit(i.EndProcess(first))
            case _:
                self._relative(node, values)

    def _clamping(self, node: Simple) -> None:
        """Lower `LMOVE location, clamp` of AS: a negative number opens [AS2015] 6-2."""
        location, clamp = node.operands
        if location is None or not _is_hand(clamp):
            self._emit(i.Opaque(self._text(node)))
            return
        path = i.Interpolation.LINEAR if node.word == "MOVES" else i.Interpolation.JOINT
        self._emit(i.Move(path, self.value(location)))
        opens = isinstance(clamp, Prefix)
        self._emit(i.MoveHand(i.HandAction.OPEN if opens else i.HandAction.CLOSE, True))

    def _relative(self, node: Simple, values: list[x.Expression | None]) -> None:
        """Lower an instruction that only V+ or AS has."""
        first = values[0] if values else None
        second = values[1] if len(values) > 1 else None
        match node.word:
            case "JMOVE":
                joints = self._filled(node.operands, (0.0,) * 6)
                goal = x.Apply(x.Function.PPOINT, joints, self.origin.span)
                self._emit(i.Move(i.Interpolation.JOINT, goal))
            case "TWAIT":
                assert first is not None
                self._emit(i.WaitTime(first))
            case "STABLE":
                assert first is not None
                self._emit(i.Break())
                self._emit(i.WaitTime(first))
            case "SWAIT":
                signals = tuple(v for v in values if v is not None)
                self._emit(i.Wait(x.Apply(x.Function.SIG, signals, self.origin.span)))
            case "PULSE":
                assert first is not None
                self._emit(i.Pulse(first, second))
            case "DLYSIG":
                assert first is not None
                assert second is not None
                self._emit(i.DelayedSignal(first, second))
            case "WAIT.EVENT" if second is not None:
                self._emit(i.WaitTime(second))
            case word:
                assert INSTRUCTIONS[word].opaque or word == "WAIT.EVENT", f"no lowering for {word}"
                self._emit(i.Opaque(self._text(node)))

    def speed(self, node: SpeedStatement) -> None:
        """Lower SPEED and the settings written like it."""
        scope = i.Scope.ALWAYS if node.always else i.Scope.NEXT_MOTION
        values = [self.value(level.value) for level in node.levels]
        if not values:
            return  # `ACCEL (2)` chooses a profile only
        first, second = values[0], values[1] if len(values) > 1 else None
        match node.word:
            case "ACCEL":
                self._emit(i.SetAcceleration(first, second, scope))
            case "DECEL":
                self._emit(i.SetAcceleration(None, first, scope))
            case "DURATION":
                self._emit(i.SetDuration(first, scope))
            case "ACCURACY":
                fine = isinstance(first, x.Constant) and first.value <= ACCURACY_FINE  # type: ignore[operator]
                accuracy = i.Accuracy.FINE if fine else i.Accuracy.COARSE
                self._emit(i.SetAccuracy(accuracy, scope))
            case _:
                units = [level.unit for level in node.levels]
                self._speed(first, second, units, scope)

    def _speed(
        self,
        value: x.Expression,
        rotation: x.Expression | None,
        units: list[str | None],
        scope: i.Scope,
    ) -> None:
        unit = next((u for u in units if u not in (None, "DEG/S")), None)
        if unit == "MONITOR":
            self._emit(i.SetMonitorSpeed(value))
        elif unit == "S":
            self._emit(i.SetDuration(value, scope))
        elif unit in _PER_MINUTE:
            factor = x.Constant(single(_PER_MINUTE[unit]))
            per_second = x.Binary(x.BinaryOperator.MULTIPLY, value, factor)
            self._emit(i.SetSpeed(per_second, i.SpeedUnit.MM_PER_S, scope))
        else:
            turning = None if "DEG/S" in units else rotation
            self._emit(i.SetSpeed(value, _UNITS[unit], scope, turning))

    def setting(self, node: Setting) -> None:
        """Lower a word that sets something for the next motion, or for all."""
        word, value = node.word, self._optional(node.value)
        scope = i.Scope.ALWAYS if node.always else i.Scope.NEXT_MOTION
        match word:
            case "COARSE" | "FINE":
                self._emit(i.SetAccuracy(i.Accuracy(word.lower()), scope, value))
            case "CPON" | "CPOFF" if node.always:
                self._emit(i.Switch(("CP",), word == "CPON"))
            case "CPON" | "CPOFF" | "OVERLAP" | "NOOVERLAP":
                self._emit(i.Opaque(self._text(node)))
            case "NULL" | "NONULL":
                self._emit(i.SetNulling(word == "NULL", scope))
            case "INTON" | "INTOFF":
                self._emit(i.SetIntegration(word == "INTON", scope))
            case "SINGLE" | "MULTIPLE":
                self._emit(i.SetTurns(word == "MULTIPLE", scope))
            case _:
                self._emit(i.RequestBranch(i.BranchRequest(word.lower())))

    def give(self, node: Give) -> None:
        """Lower PARAMETER, DECOMPOSE and the assignments of VAL."""
        target = node.target
        values = [self.value(value) for value in node.values]
        match node.word:
            case "PARAMETER":
                name = target if isinstance(target, Name) else target.name
                index = target.subscripts[0] if isinstance(target, Element) else None
                self._emit(i.SetParameter(name.text.upper(), self._optional(index), values[0]))
            case "SWITCH":
                self._set_switch(target, values[0])
            case "DECOMPOSE":
                if isinstance(target, Element) and not target.subscripts:
                    target = target._replace(subscripts=(Number(0.0, target.start, target.end),))
                plain = self.dialect.angles is Angles.ZYZ
                self._emit(i.Decompose(self.place(target), values[0], plain))
            case "SETI":
                self._emit(i.Assign(self.place(target), values[0]))
            case word:
                function = x.Function(word.lower())
                value = x.Apply(function, tuple(values), self.origin.span)
                self._emit(i.Assign(self.place(target), value))

    def _set_switch(self, target: Variable, value: x.Expression) -> None:
        """`SWITCH CP = value`: one of two steps, as the value says."""
        name = target if isinstance(target, Name) else target.name
        at = len(self.code)
        self._emit(i.JumpIf(value, False, at + 3))
        self._emit(i.Switch((name.text.upper(),), True))
        self._emit(i.Jump(at + 4))
        self._emit(i.Switch((name.text.upper(),), False))

    def put(self, node: Put) -> None:
        """Lower TIMER, BITS, DAC and IOPUT."""
        target, value = self.value(node.target), self.value(node.value)
        match node.word:
            case "TIMER":
                self._emit(i.SetTimer(target, value))
            case "BITS":
                assert node.length is not None
                self._emit(i.SetBits(target, self.value(node.length), value))
            case "DAC":
                self._emit(i.SetAnalog(target, value))
            case _:
                self._emit(i.Opaque(self._text(node)))

    def react(self, node: ReactStatement) -> None:
        """Lower REACT, REACTI, IGNORE, and ON and ONI of AS."""
        signal = self._optional(node.operands[0])
        assert signal is not None
        if self.dialect.is_val:
            signal = self._input(signal)
        if node.word == "IGNORE":
            self._emit(i.Ignore(signal))
            return
        priority = self._optional(node.operands[2]) if len(node.operands) > 2 else None
        self._emit(
            i.React(
                signal,
                _program(node.operands[1:]),
                priority,
                node.word in ("REACTI", "ONI"),
                node.always,
                node.word == "ON",
            )
        )

    def _input(self, channel: x.Expression) -> x.Expression:
        """Return the input that a channel number of VAL means: 1 is 1001, -1 is -1001."""
        first = x.Constant(FIRST_INPUT)
        sign = x.Apply(x.Function.SIGN, (channel,))
        offset = x.Binary(x.BinaryOperator.MULTIPLY, first, sign)
        return x.Binary(x.BinaryOperator.ADD, channel, offset)

    def device(self, node: Device) -> None:
        """Lower ATTACH, WRITE and their like: the terminal is written to, the rest is opaque."""
        if device_is_opaque(node):
            self._emit(i.Opaque(self._text(node)))
        elif node.word == "WRITE":
            self._emit(i.Type(self.written(node.operands)))

    def _text(self, node: Simple | Device | Put | Rest | Setting) -> str:
        """Return an instruction as written, for the message of one that is opaque."""
        return " ".join(self.source.text[node.start : node.end].split())[:MAX_TEXT]

    def opaque(self, node: Rest) -> None:
        """Lower an instruction that is not looked into."""
        self._emit(i.Opaque(self._text(node)))


def _program(operands: tuple[Item | None, ...]) -> str | None:
    """Return the program that the first operand names."""
    first = operands[0] if operands else None
    return key(first.text) if isinstance(first, Name) else None


def _is_hand(clamp: Item | None) -> bool:
    """Return whether the number of a clamp of AS is that of the hand: clamp 1."""
    number = clamp.operand if isinstance(clamp, Prefix) and clamp.operator == "-" else clamp
    return isinstance(number, Number) and number.value == 1.0
