"""Names of a program under the debugger: which there are, near misses, and conditions as typed."""

import re
from collections.abc import Iterable

from vrts.base.diagnostic import Severity
from vrts.base.source import SourceFile
from vrts.debug.debugger import Debugger
from vrts.debug.near import near_words
from vrts.engine.memory.cells import Array
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.values import Value
from vrts.lang.names import key
from vrts.monitor.desk import ALONE, ANSWER
from vrts.monitor.programs import in_view

_SIGNAL = re.compile(r"(?:SIG|SIGNAL)?\s*\(?\s*(\d{1,5})\s*\)?", re.IGNORECASE)
_NAME = re.compile(r"[$#]?[A-Za-z][\w.]*\s*(\[[\d\s,]+\])?", re.ASCII)
_QUOTED = re.compile(r"`([^`]+)`")


def names_of(debugger: Debugger) -> dict[str, Value]:
    """Return every variable with a value of its kind: its last one, else one that stands for it."""
    run = debugger.run
    names = [f"{b.name}[0]" if isinstance(b, Array) else b.name for b in run.history.memory.bound]
    for program in run.history.code.programs:
        names += [
            f"{slot.name}[0]" if slot.number in program.array_formals else slot.name
            for slot in (*program.formals, *program.autos)
        ]
    found: dict[str, Value] = {name: _stand_in(name) for name in names}
    return found | dict(run.at(run.horizon_s).variables) | dict(debugger.state.locals)


def unwatchable(debugger: Debugger, name: str) -> str:
    """Return why a name cannot be watched, with the near misses; nothing where it can."""
    text = name.strip()
    signal = _SIGNAL.fullmatch(text)
    if signal is not None:
        number = int(signal[1])
        there = any(number in known for known in (INPUTS, OUTPUTS, INTERNAL))
        return "" if there else f"there is no signal {number}"
    if _NAME.fullmatch(text) is None:
        return f"`{text}` is no name of a variable and no signal: `i`, `a[3]` or `SIG(1001)`"
    known = bases(debugger)
    wanted = key(text).partition("[")[0].strip()
    if wanted in known:
        return ""
    return _unknown(text, known)


def _unknown(name: str, known: Iterable[str]) -> str:
    return f"there is no `{name}` here{near_words(key(name).partition('[')[0], known, 0.5)}"


def bases(debugger: Debugger) -> set[str]:
    """Return the names of variables, arrays without their indices."""
    return {name.partition("[")[0] for name in names_of(debugger)}


def wrong_condition(debugger: Debugger, text: str) -> str:
    """Return what is wrong with the condition of a breakpoint; nothing where it can be one."""
    if not text.strip():
        return ""
    step = f"{ANSWER} = {text}"
    source = SourceFile("condition", f".PROGRAM {ALONE}\n{step}\n.END\n")
    found = in_view(source, (step,), {}, names_of(debugger), debugger.dialect)
    known = bases(debugger)
    for problem in found.diagnostics:
        named = _QUOTED.search(problem.headline)
        if problem.severity is Severity.NOTE:
            continue
        if problem.rule.slug == "undefined-variable" and named is not None:
            if "[" in named[1] and named[1].partition("[")[0] in known:
                continue  # an element may get its value later
            return _unknown(named[1], known)
        if problem.rule.slug == "assigned-location" or ANSWER in problem.headline:
            return "a condition is a number: 0 does not stop"
        return f"the condition cannot be read: {problem.headline}"
    return "" if found.module is not None else "this is no condition"


def _stand_in(name: str) -> Value:
    if name.startswith("$"):
        return ""
    return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0) if name.startswith("#") else 0.0
