"""Commands that go somewhere: forward, backward, to a line or a time."""

from vrts.debug.breakpoints import resolve
from vrts.debug.debugger import Way
from vrts.debug.marks.same import comes_to
from vrts.debug.passages import Instant, statements_at
from vrts.debug.scripted.session import Deed, Done, Refusal, Session, nothing, one_of
from vrts.engine.run import Run


def _step(session: Session, rest: str, done: Done) -> None:
    done.moved = True
    if rest == "back":
        session.debugger.step_back(process=session.process)
        return
    ways = {"": Way.OVER, "over": Way.OVER, "into": Way.INTO, "out": Way.OUT}
    session.debugger.step(one_of(rest, ways, "step"), process=session.process)


def _tick(session: Session, rest: str, done: Done) -> None:
    done.moved = True
    session.debugger.tick(one_of(rest, {"": 1, "back": -1}, "tick"))


def _continue(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "continue")
    done.moved = True
    session.debugger.go_on()


def _reverse(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "reverse")
    done.moved = True
    session.debugger.reverse()


def _to(session: Session, rest: str, done: Done) -> None:
    done.moved = True
    source, line = session.place(rest)
    if resolve(session.debugger.run.history.code, source, line) is None:
        raise Refusal(f"no step of a program follows line {line}")
    session.debugger.run_to(source, line)


def _at(session: Session, rest: str, done: Done) -> None:
    done.moved = True
    debugger = session.debugger
    run = debugger.run
    known = {"begin": 0.0, "end": run.horizon_s}
    time, _, step = (part.strip() for part in rest.partition(" step "))
    try:
        time_s = known[time] if time in known else float(time)
    except ValueError:
        raise Refusal("`at` takes a time [s], `begin` or `end`") from None
    if not -1.0 <= time_s <= 1e9:
        raise Refusal(f"the run goes from 0 to {run.horizon_s:.3f} s")
    if step:
        debugger.go(_within(run, time_s, step))
        return
    debugger.jump(time_s)
    if time_s > run.horizon_s + 1e-3:
        done.said.append(f"the run goes from 0 to {run.horizon_s:.3f} s")


def _within(run: Run, time_s: float, step: str) -> Instant:
    """Return the instant of a time at which so many statements are finished."""
    if not step.isdecimal() or len(step) > 12:
        raise Refusal(f"`{step}` is no number of statements: `at 6.2 step 17`")
    if not 0.0 <= time_s <= run.horizon_s:
        raise Refusal(f"the run goes from 0 to {run.horizon_s:.3f} s")
    instant = Instant(time_s, int(step))
    if not comes_to(run, instant):
        least, most = statements_at(run, time_s)
        some = f"{least:,} to {most:,}" if least < most else f"{most:,}"
        raise Refusal(f"at {time_s:g} s {some} statements are finished, not {int(step):,}")
    return instant


def _restart(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "restart")
    done.moved = True
    if session.restart is None:
        session.debugger.restart()
        return
    text = session.restart()
    if text:
        done.said.append(text)


def _program(session: Session, rest: str, done: Done) -> None:
    known = {"": not session.process, "robot": False, "process": True}
    process = one_of(rest, known, "program")
    if process and not session.debugger.passages(process=True).count:
        raise Refusal("there is no process control program")
    session.process = process
    done.moved = True


DEEDS: dict[str, Deed] = {
    "step": _step,
    "tick": _tick,
    "continue": _continue,
    "reverse": _reverse,
    "to": _to,
    "at": _at,
    "restart": _restart,
    "program": _program,
}
