"""Requests of ours: `vrts/who`, `vrts/next`, `vrts/why`, `vrts/events`, and `vrts/go` to a row."""

from collections.abc import Callable, Mapping

from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.session import Answer, Json, Session, source_body
from vrts.debug.events.asking import COLUMNS, TABLES
from vrts.debug.history.answers import Found
from vrts.debug.passages import Instant


def _who(session: Session, a: Fields) -> Answer:
    return _changed(session, a, "who")


def _next(session: Session, a: Fields) -> Answer:
    return _changed(session, a, "next")


def _changed(session: Session, a: Fields, word: str) -> Answer:
    found = session.console.changed(word, a.text("name"), session.frame(a))
    return Answer({"rows": [_row(each) for each in found]})


def _why(session: Session, a: Fields) -> Answer:
    effect, links = session.console.causes(a.optional("name"), session.frame(a))
    rows: list[Json] = []
    for text, link, place in links:
        row: Json = {"text": text}
        if link.span is not None:
            row |= {"source": source_body(link.span.source), "line": link.span.line}
        if place is not None:
            row["go"] = _place(place)
        rows.append(row)
    return Answer({"effect": effect, "rows": rows})


def _events(session: Session, a: Fields) -> Answer:
    """Return rows of the table of events, or of calls, that fit a question."""
    name = a.optional("table") or "events"
    if name not in TABLES:
        raise BadRequest(f"there is no table `{name}`: {' or '.join(TABLES)}")
    found = session.console.table(name, a.optional("query") or "")
    rows: list[Json] = []
    for each in found.rows:
        row: Json = {"number": each.number, "text": each.words, "go": _place(each.go.instant)}
        row |= each.values
        if each.cause is not None:
            row["source"] = source_body(each.cause.span.source)
        rows.append(row)
    columns = COLUMNS[name]
    named = [{"name": n, "unit": c.unit, "says": c.says} for n, c in columns.items()]
    return Answer({"columns": named, "rows": rows, "total": found.total, "says": found.says})


def _go(session: Session, a: Fields) -> Answer:
    """Go to a row or a mark, or to a place that an answer has named, as far as the run has it."""
    debugger = session.debugger
    row = a.whole_or_none("row")
    name = str(row) if row is not None else a.optional("mark")
    if name is not None:
        session.console.go(name)
        return Answer({}, session.stopped(debugger.stop))
    run = debugger.run
    time_s = min(max(a.number("time", 0.0), 0.0), run.horizon_s)
    finished = min(max(a.whole("statements"), 0), run.statements)
    return Answer({}, session.stopped(debugger.go(Instant(time_s, finished))))


def _row(found: Found | str) -> Json:
    if isinstance(found, str):
        return {"text": found}
    row: Json = {
        "text": f"{found.name} {found.text}",
        "time": found.instant.time_s,
        "settled": found.settled_s,
        "old": found.old,
        "new": found.new,
        "go": _place(found.go),
    }
    if found.cause is not None:
        cause = found.cause
        row |= {"program": cause.program, "step": cause.step, "line": cause.span.line}
        row["source"] = source_body(cause.span.source)
    return row


def _place(instant: Instant) -> Json:
    return {"time": instant.time_s, "statements": instant.finished}


ASKING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "vrts/who": _who,
    "vrts/next": _next,
    "vrts/why": _why,
    "vrts/events": _events,
    "vrts/go": _go,
}
