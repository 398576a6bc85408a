"""How a step of a program leaves the machine, and what ends a run from within."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import Span

BLOCKED = -1  # look again at `Context.wake`
SWITCHED = -2  # the innermost frame changed
CYCLE_ENDED = -3  # STOP, or RETURN of the first program
HALTED = -4
PAUSED = -5

INSTANT = 1e-9  # [s] of two times nearer than this neither is earlier

STATEMENTS = Rule("V510", "too-many-statements")
SIMULATED_TIME = Rule("V511", "too-long")
MOTIONS = Rule("V512", "too-many-motions")
OUTPUT = Rule("V513", "too-much-output")
WAIT_NEVER_ENDS = Rule("V502", "wait-never-ends")


class LimitReached(Exception):  # noqa: N818 -- a result of the run, not an error of ours
    """A limit of the scenario ends the run; the diagnostic says which and where."""

    def __init__(self, rule: Rule, headline: str, span: Span, note: str, remedy: str) -> None:
        """Make the diagnostic."""
        super().__init__(headline)
        self.diagnostic = Diagnostic(
            rule, Severity.ERROR, headline, Label(span), notes=(note,), help=(remedy,)
        )
