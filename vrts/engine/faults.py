"""What ends a program from within: run-time errors, and limits of the run.

They are raised where they are found, and made a diagnostic once by the machine.
Headlines are ours; VAL's own words stand in a note.
"""

from collections.abc import Mapping
from types import MappingProxyType

from vrts.base.diagnostic import NO_DATA, Datum, Diagnostic, Label, Rule, Severity
from vrts.base.source import Span
from vrts.ir.runtime_errors import RuntimeErrorKind

UNDEFINED_VALUE = Rule("V250", "undefined-value")
DIVISION_BY_ZERO = Rule("V251", "division-by-zero")
ARITHMETIC_OVERFLOW = Rule("V252", "arithmetic-overflow")
ILLEGAL_VALUE = Rule("V253", "value-out-of-range")
ARRAY_INDEX = Rule("V254", "array-index")
UNDEFINED_PROGRAM = Rule("V255", "undefined-program")
ARGUMENT_MISMATCH = Rule("V256", "argument-mismatch")
NEGATIVE_ROOT = Rule("V257", "negative-square-root")
STACK_FULL = Rule("V258", "too-many-calls")
STRING_OVERFLOW = Rule("V259", "string-too-long")
CONTROL_STRUCTURE = Rule("V260", "loop-not-entered")
NOT_SIMULATED = Rule("V261", "not-simulated")
ILLEGAL_SIGNAL = Rule("V501", "signal-number")
OUT_OF_REACH = Rule("V301", "out-of-reach")
JOINT_LIMIT = Rule("V303", "joint-limit")
BRANCH_CHANGE = Rule("V304", "branch-change")
LINE_FROM_SINGULARITY = Rule("V305", "line-from-singularity")
SINGULAR_JUMP = Rule("V306", "singular-jump")
JOINT_NUMBER = Rule("V307", "joint-number")
POWER_OFF = Rule("V308", "arm-power-off")
PART_MISSING = Rule("V314", "part-missing")
UNREADABLE_ANSWER = Rule("V262", "unreadable-answer")
PROCESS_EXECUTING = Rule("V263", "process-executing")
ROBOT_INSTRUCTION = Rule("V264", "robot-instruction")
RETURN_FROM_NO_ERROR = Rule("V265", "return-from-no-error")
NO_SUCH_SWITCH = Rule("V266", "no-such-switch")
STATEMENTS = Rule("V510", "too-many-statements")
SIMULATED_TIME = Rule("V511", "too-long")
MOTIONS = Rule("V512", "too-many-motions")
OUTPUT = Rule("V513", "too-much-output")
WAIT_NEVER_ENDS = Rule("V502", "wait-never-ends")
NO_ANSWER = Rule("V504", "no-answer")

RULES: Mapping[RuntimeErrorKind, Rule] = MappingProxyType(
    {
        RuntimeErrorKind.UNDEFINED_VALUE: UNDEFINED_VALUE,
        RuntimeErrorKind.DIVISION_BY_ZERO: DIVISION_BY_ZERO,
        RuntimeErrorKind.ARITHMETIC_OVERFLOW: ARITHMETIC_OVERFLOW,
        RuntimeErrorKind.ILLEGAL_VALUE: ILLEGAL_VALUE,
        RuntimeErrorKind.INVALID_ARGUMENT: ILLEGAL_VALUE,
        RuntimeErrorKind.ILLEGAL_ARRAY_INDEX: ARRAY_INDEX,
        RuntimeErrorKind.UNDEFINED_PROGRAM: UNDEFINED_PROGRAM,
        RuntimeErrorKind.ARGUMENT_MISMATCH: ARGUMENT_MISMATCH,
        RuntimeErrorKind.NEGATIVE_SQUARE_ROOT: NEGATIVE_ROOT,
        RuntimeErrorKind.STACK_FULL: STACK_FULL,
        RuntimeErrorKind.STRING_OVERFLOW: STRING_OVERFLOW,
        RuntimeErrorKind.CONTROL_STRUCTURE: CONTROL_STRUCTURE,
        RuntimeErrorKind.NOT_INSTALLED: NOT_SIMULATED,
        RuntimeErrorKind.ILLEGAL_SIGNAL: ILLEGAL_SIGNAL,
        RuntimeErrorKind.TOO_FAR: OUT_OF_REACH,
        RuntimeErrorKind.TOO_CLOSE: OUT_OF_REACH,
        RuntimeErrorKind.OUT_OF_RANGE: OUT_OF_REACH,
        RuntimeErrorKind.JOINT_OUT_OF_RANGE: JOINT_LIMIT,
        RuntimeErrorKind.CANNOT_ALTER_CONFIGURATION: BRANCH_CHANGE,
        RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE: LINE_FROM_SINGULARITY,
        RuntimeErrorKind.ILLEGAL_JOINT: JOINT_NUMBER,
        RuntimeErrorKind.ROBOT_POWER_OFF: POWER_OFF,
        RuntimeErrorKind.HAND_CLOSED_TOO_FAR: PART_MISSING,
        RuntimeErrorKind.INVALID_NUMBER: UNREADABLE_ANSWER,
        RuntimeErrorKind.PROCESS_EXECUTING: PROCESS_EXECUTING,
        RuntimeErrorKind.ILLEGAL_IN_PROCESS: ROBOT_INSTRUCTION,
        RuntimeErrorKind.ILLEGAL_RETURNE: RETURN_FROM_NO_ERROR,
        RuntimeErrorKind.INVALID_SWITCH: NO_SUCH_SWITCH,
    }
)


class RuntimeFault(Exception):  # noqa: N818 -- VAL's run-time errors are faults of the program
    """A VAL run-time error, with what a reader needs to know about it."""

    def __init__(
        self,
        kind: RuntimeErrorKind,
        headline: str,
        span: Span | None = None,
        *,
        rule: Rule | None = None,
        label: str = "",
        notes: tuple[str, ...] = (),
        help: tuple[str, ...] = (),  # noqa: A002 -- the diagnostic's own word
        joint: int = 0,
        data: Mapping[str, Datum] = NO_DATA,
    ) -> None:
        """Keep everything; `span` None stands for the whole instruction."""
        super().__init__(headline)
        self.kind = kind
        self.headline = headline
        self.span = span
        self.rule = rule or RULES[kind]
        self.label = label
        self.notes = notes
        self.help = help
        self.joint = joint
        self.data = data

    @property
    def number(self) -> int:
        """VAL's number of the error."""
        return self.kind.value.number - self.joint * (
            self.kind is RuntimeErrorKind.JOINT_OUT_OF_RANGE
        )

    @property
    def words(self) -> str:
        """VAL's words for the error."""
        return self.kind.value.words.format(joint=self.joint)

    def diagnostic(self, instruction: Span) -> Diagnostic:
        """Return the diagnostic, at the failing operand or else at the instruction."""
        return Diagnostic(
            self.rule,
            Severity.ERROR,
            self.headline,
            Label(self.span or instruction, self.label),
            notes=(*self.notes, f"VAL-II says *{self.words}*"),
            help=self.help,
            data=self.data,
        )


class LimitReached(Exception):  # noqa: N818 -- a result of the run, not an error of ours
    """A limit of the scenario ends the run; the diagnostic says which and where."""

    def __init__(self, rule: Rule, headline: str, span: Span, note: str, remedy: str) -> None:
        """Make the diagnostic."""
        super().__init__(headline)
        self.diagnostic = Diagnostic(
            rule, Severity.ERROR, headline, Label(span), notes=(note,), help=(remedy,)
        )
