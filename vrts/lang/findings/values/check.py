"""Asks about every number that matters: first what is written, then what is known on the way."""

from collections.abc import Mapping

from vrts.base.diagnostic import Severity
from vrts.ir.module import Datum, Program
from vrts.ir.values import Type
from vrts.lang.findings.endless import runs_beside
from vrts.lang.findings.values.comparisons import check_comparison, inner_of
from vrts.lang.findings.values.complaints import NO_SUCH_SIGNAL, Complaint, divisor, root
from vrts.lang.findings.values.conditions import check_condition
from vrts.lang.findings.values.evaluate import Known, evaluate, nothing_known
from vrts.lang.findings.values.flow import Followed, State, states
from vrts.lang.findings.values.intervals import ANY, Interval, point
from vrts.lang.findings.values.joined import check_joined, check_same
from vrts.lang.findings.values.loops import check_loop
from vrts.lang.findings.values.questions import (
    DIVISIONS,
    Question,
    asked_names,
    questions,
    variables,
)
from vrts.lang.findings.values.stretches import Stretches
from vrts.lang.findings.values.switched import check_switched, says_off_by_zero
from vrts.lang.findings.values.units.angles import check_angles, check_taught
from vrts.lang.findings.values.units.lengths import MOTIONS, check_data, check_lengths, goals
from vrts.lang.findings.values.units.times import check_times
from vrts.lang.findings.values.units.turning import TURNS, Turned, check_turning, turned
from vrts.lang.grammar.build import PRECEDENCE
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.meaning.scope import Entry
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Infix,
    Item,
    Name,
    Number,
    Prefix,
)
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    Give,
    If,
    Put,
    ReactStatement,
    SetLocation,
    Simple,
    SpeedStatement,
    Until,
    While,
)

MOST_NAMES = 60  # that are followed through one program
MOST_WORK = 1_000_000  # steps times names; programs beyond are not looked into
MOST_PROGRAMS = 300  # called from one; beyond, a call may change anything


class ValueCheck:
    """Looks at the numbers of one compilation."""

    def __init__(
        self, types: NameUses, programs: list[ProgramText], *, refuses: bool = True
    ) -> None:
        """Look at programs; `refuses`: numbers that no controller takes are errors."""
        self.refuses = refuses
        self.types = types
        self.problems = types.problems
        self.scope = types.scope
        self.programs = programs
        self.open: dict[str, list[Question | Asked]] = {}  # by program: what variables decide
        self.changes: dict[str, frozenset[str] | None] = {}  # by a call of a program
        self.fine: set[tuple[object, ...]] = set()  # forms without variables and without faults
        self.absolute: frozenset[str] = frozenset()  # locations that the arm goes to as they are
        self.beside = False  # whether another program may run between two steps
        self.in_radians: set[int] = set()  # steps of which it was said
        self.turned: Turned = {}
        self.timers = True  # whether this file has any
        self.zeros = False  # whether `SIGNAL n, 0` stands for off in this file
        self.misread = Stretches([])  # conditions that AND and OR take apart
        self.within: set[tuple[int, int]] = set()  # parts of conditions that were looked at
        self.direct: dict[str, set[str]] = {}  # variables that a program itself changes

    def written(self, data: list[Datum]) -> None:
        """Look at numbers that stand in the text, and keep the rest for `followed`."""
        self.absolute = goals(self.types)
        self.beside = runs_beside(self.programs)
        check_data(self.types, data, self.absolute)
        check_taught(self.types, data)
        self.turned = turned(self.types)
        self.timers = "timer" in self.problems.source.text.lower()
        self.zeros = says_off_by_zero(self.types)
        found = self.problems.found
        self.misread = Stretches(
            (d.primary.span.start, d.primary.span.end)
            for d in found
            if d.rule is PRECEDENCE and d.primary is not None
        )
        for asked in self.types.asked:
            node = asked.node
            form = None
            if isinstance(node, (Application, Simple)):
                form = _literal(node, asked.program)
            if form is None:
                self._look(asked)
            elif form not in self.fine:
                before = len(found)
                self._look(asked)
                if len(found) == before and asked.step not in self.in_radians:
                    self.fine.add(form)

    def _look(self, asked: Asked) -> None:
        """Ask what there is to ask about one place."""
        node = asked.node
        if isinstance(node, Infix):
            if node.operator not in DIVISIONS:
                self._condition(asked, node)
            elif asked.program is not None:
                self._question(Question(asked.program, asked.step, node.right, divisor))
            return
        if isinstance(node, For):
            if not self._turns(asked):
                self._loop(asked, node)
            return
        if isinstance(node, SpeedStatement | SetLocation):
            check_lengths(self.types, asked, self.absolute)
            return
        if isinstance(node, Simple) and node.word in MOTIONS:
            check_lengths(self.types, asked, self.absolute)
            return
        if isinstance(node, Application | Simple):
            if asked.step in self.in_radians or check_angles(self.types, asked):
                self.in_radians.add(asked.step)
                return
            if isinstance(node, Application):
                check_lengths(self.types, asked, self.absolute)
        if isinstance(node, Simple | Put | Give) and check_times(self.types, asked):
            return
        if isinstance(node, Simple) and self._switches(node):
            return
        if isinstance(node, If | While | Until | Simple):
            check_condition(self.types, asked, beside=self.beside)
        for question in questions(asked, self.problems.dialect):
            self._question(question)

    def _turns(self, asked: Asked) -> bool:
        return bool(self.turned) and check_turning(self.types, asked, self.turned)

    def _switches(self, node: Simple) -> bool:
        return node.word == "SIGNAL" and check_switched(self.types, node, zeros=self.zeros)

    def _condition(self, asked: Asked, node: Infix) -> None:
        """Look at a comparison, or at what AND or OR joins; once, where several join each other."""
        if (node.start, node.end) in self.within or self.misread.hold(node.start, node.end):
            return
        if node.operator in ("AND", "OR"):
            for part in inner_of(node):
                self.within.add((part.start, part.end))
            if check_joined(self.types, node):
                return
        elif check_comparison(self.types, asked, node):
            for part in inner_of(node):
                self.within.add((part.start, part.end))
            return
        elif (self.timers and check_times(self.types, asked)) or self._turns(asked):
            return
        else:
            check_same(self.types, node)
        check_condition(self.types, asked, beside=self.beside)

    def _question(self, question: Question) -> None:
        asks = question.node
        if isinstance(asks, Application) and asks.name.text.lower() == "sig" and asks.arguments:
            self._sig_for_number(asks)
            return
        value = evaluate(question.node, nothing_known)
        complaint = question.complain(value)
        if complaint is not None:
            certain = self.refuses and complaint.certain and value[0] == value[1]
            self._warn(question.node, complaint, "", certain=certain)
        elif (
            question.complain is not root
            and value[0] != value[1]
            and self._may_be_known(question.program, question.node)
        ):
            self.open.setdefault(question.program, []).append(question)

    def _sig_for_number(self, node: Application) -> None:
        """`REACT SIG(1003), stop.it`: SIG tells whether it is on, and here its number belongs."""
        first = node.arguments[0]
        if first is None:
            return
        number = self.problems.source.text[first.start : first.end]
        self.problems.warning(
            NO_SUCH_SIGNAL,
            "the number of a signal belongs here, and SIG yields -1 or 0",
            node.start,
            node.end,
            help=(f"write the number alone: `{number}`",),
            fix=self.problems.replace(node.start, node.end, number, sure=False),
        )

    def _loop(self, asked: Asked, node: For) -> None:
        if asked.program is None or check_loop(self.problems, node, nothing_known):
            return
        ends = (node.first, node.last, node.increment)
        if any(self._may_be_known(asked.program, part) for part in ends):
            self.open.setdefault(asked.program, []).append(asked)

    def followed(self, lowered: Mapping[str, Program]) -> None:
        """Look at numbers that variables hold, on the ways through each program."""
        if not self.open or _leaps(self.programs):
            return
        for text in self.programs:
            if text.name in self.open:
                self._program(text, lowered[text.name])

    def _program(self, text: ProgramText, program: Program) -> None:
        names = self._names(text)
        if not names or len(names) > MOST_NAMES or len(names) * len(text.steps) > MOST_WORK:
            return
        called = {
            key(node.program.text)
            for step in text.steps
            if isinstance(node := step.statement, CallStatement)
        }
        changed_by = {name: self.changed_by(name) for name in sorted(called)}
        followed = Followed(names, changed_by, not self.problems.dialect.tolerant)
        known = states(text, program, followed, self._start(text.name, names))
        by_place = {s.statement.start: s.number for s in text.steps if s.statement is not None}
        for what in self.open[text.name]:
            state = known.get(by_place.get(what.step, -1))
            if state is None:
                continue  # no way leads there
            if isinstance(what, Question):
                value = evaluate(what.node, _lookup(state))
                complaint = what.complain(value)
                if complaint is not None:
                    self._warn(what.node, complaint, _shown(value))
            elif isinstance(what.node, For):
                check_loop(self.problems, what.node, _lookup(state))

    def _warn(self, node: Item, complaint: Complaint, text: str, *, certain: bool = False) -> None:
        self.problems.error(
            complaint.rule,
            complaint.headline,
            node.start,
            node.end,
            text,
            notes=(complaint.note,),
            help=(complaint.help,),
            severity=Severity.ERROR if certain else Severity.WARNING,
        )

    # --- which variables are followed -----------------------------------------------------------

    def _may_be_known(self, program: str, node: Item | None) -> bool:
        """Return whether a variable of an expression may be known somewhere."""
        return any(
            self._is_plain(entry) and (program in entry.written_in or len(entry.values) == 1)
            for entry in (self.scope.entry(program, name) for name in variables(node))
        )

    def _is_plain(self, entry: Entry) -> bool:
        own = entry.slot is None or entry.automatic
        loose = entry.asked or entry.array is not None or entry.name in self.types.bad_names
        return own and not loose and entry.type is Type.REAL

    def _names(self, text: ProgramText) -> frozenset[str]:
        """Return the variables that the questions are about, and those that decide about them."""
        deciding: dict[str, list[Item | None]] = {}
        for step in text.steps:
            node = step.statement
            if isinstance(node, Assignment) and isinstance(node.target, Name):
                deciding.setdefault(key(node.target.text), []).append(node.value)
            elif isinstance(node, For) and isinstance(node.target, Name):
                ends = (node.first, node.last, node.increment)
                deciding.setdefault(key(node.target.text), []).extend(ends)
        waiting = [name for what in self.open[text.name] for name in asked_names(what)]
        found: dict[str, None] = {}
        while waiting:
            name = waiting.pop()
            if name in found or len(found) > MOST_NAMES:
                continue
            entry = self.scope.entry(text.name, name)
            if not self._is_plain(entry) or (entry.passed and text.formals):
                continue
            if self.beside and not entry.written_in <= {text.name, None}:
                continue
            found[name] = None
            for value in deciding.get(name, ()):
                waiting += variables(value)
        return frozenset(found)

    def _start(self, program: str, names: frozenset[str]) -> State:
        """Return the variables that only ever hold one number."""
        start: State = {}
        for name in sorted(names):
            entry = self.scope.entry(program, name)
            if program not in entry.written_in and len(entry.values) == 1:
                value = constant(self.scope, program, Name(name, 0, 0))
                if value is not None:
                    start[name] = point(value)
        return start

    def changed_by(self, name: str) -> frozenset[str] | None:
        """Return the variables that a call of a program may change; None: any."""
        if name in self.changes:
            return self.changes[name]
        if not self.changes:
            for entry in self.scope.entries.values():
                for program in entry.written_in:
                    self.direct.setdefault(program or "", set()).add(entry.name)
        changed: set[str] = set()
        seen: dict[str, None] = {name: None}
        for called in (waiting := [name]):
            program = self.scope.programs.get(called)
            if program is None or len(seen) > MOST_PROGRAMS:
                self.changes[name] = None
                return None
            changed |= self.direct.get(called, set())
            for step in program.steps:
                node = step.statement
                if isinstance(node, CallStatement) and key(node.program.text) not in seen:
                    seen[key(node.program.text)] = None
                    waiting.append(key(node.program.text))
        self.changes[name] = found = frozenset(changed)
        return found


def _literal(node: Application | Simple, program: str | None) -> tuple[object, ...] | None:
    """Return all that matters of a place without variables; None of others.

    The sine of a variable is such a place, too: what the variable holds on the way is not asked.
    """
    turns = isinstance(node, Application) and node.name.text.lower() in TURNS
    if isinstance(node, Application):
        parts, form = node.arguments, [node.name.text]
    else:
        parts, form = node.operands, [node.word]
        if node.word in MOTIONS and parts and isinstance(parts[0], Name):
            parts = parts[1:]
    values: list[object] = [*form]
    for part in parts:
        sign = part.operator if isinstance(part, Prefix) else ""
        number = part.operand if isinstance(part, Prefix) else part
        if isinstance(number, Number):
            values.append((sign, number.value))
        elif turns and isinstance(number, Name):
            values.append((sign, program, number.text))
        else:
            return None
    return tuple(values)


def _leaps(programs: list[ProgramText]) -> bool:
    """Return whether steps may be left out: RETURN with a number, and reactions to errors."""
    for program in programs:
        for step in program.steps:
            node = step.statement
            if isinstance(node, Simple) and (
                node.word == "REACTE" or (node.word == "RETURN" and node.operands)
            ):
                return True
            if isinstance(node, ReactStatement) and node.word == "ONE":
                return True
    return False


def _lookup(state: State) -> Known:
    return lambda name: state.get(name, ANY)


def _shown(value: Interval) -> str:
    if value[0] == value[1]:
        return f"this is {value[0]:g} here"
    return f"this is from {value[0]:g} to {value[1]:g} here"
