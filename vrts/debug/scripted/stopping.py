"""Commands about where to stop: breakpoints, watches, alarms."""

from vrts.debug.alarms import LABELS, Filter
from vrts.debug.breakpoints import Breakpoint, Watch, resolve
from vrts.debug.changes import watchable
from vrts.debug.frames import frames
from vrts.debug.near import near_words
from vrts.debug.scripted.breaking import described, read_breakpoint
from vrts.debug.scripted.names import unwatchable, wrong_condition
from vrts.debug.scripted.session import Deed, Done, Refusal, Session, nothing


def _break(session: Session, rest: str, done: Done) -> None:
    asked = read_breakpoint(rest)
    if isinstance(asked, str):
        raise Refusal(asked)
    problem = wrong_condition(session.debugger, asked.condition)
    if problem:
        raise Refusal(problem)
    source, line = session.place(f"{asked.file}:{asked.line}" if asked.file else str(asked.line))
    found = resolve(session.debugger.run.history.code, source, line)
    if found is None:
        raise Refusal(f"no step of a program follows line {line}")
    point = Breakpoint(session.new_id(), source, found.line, asked.condition, asked.hits, asked.log)
    wishes = session.debugger.wishes
    others = [each for each in wishes.lines if (each.source, each.line) != point[1:3]]
    wishes.lines = [*others, point]
    done.said.append(described(point))


def _unbreak(session: Session, rest: str, done: Done) -> None:
    wishes = session.debugger.wishes
    if rest == "all":
        wishes.lines = []
        return
    source, line = session.place(rest)
    found = resolve(session.debugger.run.history.code, source, line)
    lines = {line} if found is None else {line, found.line}
    kept = [p for p in wishes.lines if p.source != source or p.line not in lines]
    if len(kept) == len(wishes.lines):
        raise Refusal(f"there is no breakpoint at line {line}")
    wishes.lines = kept


def _watch(session: Session, rest: str, done: Done) -> None:
    problem = unwatchable(session.debugger, rest) if rest else "`watch` takes a name"
    if problem:
        raise Refusal(problem)
    wishes = session.debugger.wishes
    run, at = session.debugger.run, session.debugger.at
    frame = next(iter(frames(run, at, process=session.process)), None)
    local = frame is not None and rest.partition("[")[0].strip().lower() in frame.declared(run)
    name = watchable(run, rest, frame).name if local else rest
    if name not in [watch.name for watch in wishes.watches]:
        wishes.watches = [*wishes.watches, Watch(session.new_id(), name)]
    done.said.append(_watched(session))


def _unwatch(session: Session, rest: str, done: Done) -> None:
    wishes = session.debugger.wishes
    kept = [
        watch
        for watch in wishes.watches
        if rest not in ("all", watch.name, watch.name.partition(" @ ")[0])
    ]
    if rest != "all" and len(kept) == len(wishes.watches):
        raise Refusal(f"`{rest}` is not watched")
    wishes.watches = kept
    done.said.append(_watched(session))


def _alarms(session: Session, rest: str, done: Done) -> None:
    wishes = session.debugger.wishes
    kinds = {kind.value: kind for kind in Filter}
    words = rest.replace(",", " ").split()
    if words in (["all"], ["none"]):
        wishes.filters = frozenset(Filter) if words == ["all"] else frozenset()
    elif words:
        unknown = next((word for word in words if word not in kinds), None)
        if unknown is not None:
            near = near_words(unknown, kinds)
            raise Refusal(f"there is no alarm `{unknown}`{near or ': ' + ', '.join(kinds)}")
        wishes.filters = frozenset(kinds[word] for word in words)
    for word, kind in kinds.items():
        stops = "stops" if kind in wishes.filters else "does not stop"
        done.said.append(f"{word}: {LABELS[kind].lower()}, {stops}")


def _stops(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "stops")
    wishes = session.debugger.wishes
    done.said += [described(point) for point in wishes.lines]
    done.said.append(_watched(session))
    kinds = sorted(kind.value for kind in wishes.filters)
    done.said.append("stops at alarms: " + (", ".join(kinds) or "none"))


def _watched(session: Session) -> str:
    names = [watch.name for watch in session.debugger.wishes.watches]
    return "stops at changes of: " + (", ".join(names) or "nothing")


DEEDS: dict[str, Deed] = {
    "break": _break,
    "unbreak": _unbreak,
    "watch": _watch,
    "unwatch": _unwatch,
    "alarms": _alarms,
    "stops": _stops,
}
