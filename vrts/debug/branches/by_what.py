"""What was done to make a branch, in words."""

from collections.abc import Sequence

from vrts.debug.branches.tree import By
from vrts.ir.commands import (
    Answer,
    Command,
    ForceSignals,
    GoTo,
    MonitorSpeed,
    SetLocal,
    SetVariable,
)
from vrts.monitor.listings import value_text
from vrts.report.plain import one_line

LONGEST = 60  # characters


def by_what(commands: Sequence[Command]) -> tuple[By, str]:
    """Return which kind of change some commands are, and what they do."""
    first = commands[0]
    match first:
        case (
            SetVariable(name=name, subscripts=inside, value=value)
            | SetLocal(name=name, subscripts=inside, value=value)
        ):
            element = f"[{','.join(map(str, inside))}]" if inside else ""
            shown = "nothing" if value is None else value_text(value).strip()
            return By.VALUE, _short(f"{name}{element} = {shown}")
        case ForceSignals(signals=signals):
            said = [f"signal {abs(n)} {'on' if n > 0 else 'off'}" for n in signals]
            return By.VALUE, _short(", ".join(said))
        case MonitorSpeed(percent=percent):
            return By.VALUE, f"speed {percent:g} %"
        case GoTo(step=step):
            return By.STEP, f"step {step} comes next"
        case Answer(text=text):
            return By.COMMAND, _short(f"answered `{text}`")
        case _:
            return By.COMMAND, type(first).__name__.upper()


def _short(text: str) -> str:
    plain = one_line(text)
    return plain if len(plain) <= LONGEST else f"{plain[: LONGEST - 1]}…"
