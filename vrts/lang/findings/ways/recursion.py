"""Programs that call themselves on every way through them: each call calls again."""

from collections.abc import Mapping

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.ir import instructions as i
from vrts.ir.module import Program
from vrts.lang.findings.ways.reached import Endless, following
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText

ENDLESS_CALL = Rule("V243", "endless-call")

MOST_LOOKED_AT = 200_000  # instructions of all programs; no more are looked at then


class CallCheck:
    """Looks at the programs of a compilation that is without errors."""

    def __init__(self, problems: Problems, lowered: Mapping[str, Program]) -> None:
        self.problems = problems
        self.lowered = lowered
        self.left = MOST_LOOKED_AT

    def check(self, texts: list[ProgramText]) -> None:
        """Warn of programs of which no call can come to its end."""
        calls = {name: _calls(program) for name, program in self.lowered.items()}
        inside = _in_circles(calls)
        if not inside:
            return
        first: dict[str, int] = {}  # the call at which such a program is lost
        lost = set(inside)
        while lost:
            first = {name: self._lost_at(name, lost) for name in sorted(lost)}
            ends = {name for name, at in first.items() if at < 0}
            lost -= ends
            if not ends:
                break
        told: set[str] = set()
        for text in texts:
            if text.name in lost and text.name not in told:
                self._warn(text, first, told)

    def _lost_at(self, name: str, lost: set[str]) -> int:
        """Return a call that every way through a program leads to; -1 where one does not."""
        program = self.lowered[name]
        no_tests: dict[int, Endless] = {}
        waiting, seen, found = [0], set[int](), -1
        while waiting:
            at = waiting.pop()
            if at in seen:
                continue
            seen.add(at)
            self.left -= 1
            code = program.instructions[at]
            if isinstance(code, i.Call) and code.program in lost:
                found = at if found < 0 else min(found, at)
                continue
            if self.left < 0 or isinstance(code, _LEAVING):
                return -1
            waiting += following(program, at, no_tests)
        return found

    def _warn(self, text: ProgramText, first: Mapping[str, int], told: set[str]) -> None:
        row = [text.name]  # programs that call each other
        while True:
            program = self.lowered[row[-1]]
            call = program.instructions[first[row[-1]]]
            assert isinstance(call, i.Call)
            told.add(row[-1])
            if call.program in row:
                break
            if call.program in told:
                return  # leads to a circle that was told
            row.append(call.program)
        row = row[row.index(call.program) :]
        told.update(row)
        spans = [self.lowered[name].origins[first[name]].span for name in row]
        alone = len(row) == 1
        self.problems.add(
            Diagnostic(
                ENDLESS_CALL,
                Severity.WARNING,
                f"`{row[0]}` calls itself each time: the calls never end"
                if alone
                else f"{' and '.join(f'`{name}`' for name in row)} call each other without an end",
                Label(spans[0], "on every way through it"),
                tuple(Label(span, "and this goes on") for span in spans[1:]),
                ("each CALL waits for its program to come back, until memory is full",),
                (
                    "to do it all again write a loop: a label before the first step, and GOTO",
                    "or put the CALL under a condition: IF",
                ),
            )
        )


_LEAVING = (i.Return, i.Stop, i.Halt, i.ReturnError, i.CallNamed, i.Opaque)


def _calls(program: Program) -> set[str]:
    return {code.program for code in program.instructions if type(code) is i.Call}


def _in_circles(calls: Mapping[str, set[str]]) -> set[str]:
    """Return the programs that call themselves, over whatever others, or call such ones."""
    left = {name: {n for n in called if n in calls} for name, called in calls.items()}
    callers: dict[str, list[str]] = {}
    for name, called in left.items():
        for other in called:
            callers.setdefault(other, []).append(name)
    waiting = [name for name, called in left.items() if not called]
    while waiting:
        name = waiting.pop()
        del left[name]
        for caller in callers.get(name, ()):
            left[caller].discard(name)
            if not left[caller]:
                waiting.append(caller)
    return set(left)
