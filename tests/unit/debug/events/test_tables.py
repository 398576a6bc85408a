"""Tables of random programs: each event once, in order; questions as Python asks; exact jumps."""

import contextlib
import random
from collections.abc import Callable
from functools import cache
from typing import Any

import pytest

from tests.laws import first
from tests.unit.debug.history.test_tracks import drawn_run
from vrts.debug.alarms import Alarms
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell
from vrts.debug.events import calls, happened
from vrts.debug.events.asking import COLUMNS, Tables
from vrts.debug.events.columns import Column, texts_of
from vrts.debug.events.query import LONGEST, MOST, read_query
from vrts.debug.frames import frames
from vrts.debug.passages import Instant, executes
from vrts.engine.memory.events import SignalChanged
from vrts.engine.memory.records import INSTANT
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.lang.dialect import DIALECTS
from vrts.report.event_words import event_text

NUMBERS = first(3, (0, 2, 4, 9, 13, 17, 23, 31))
Fits = Callable[[Any], bool]


@cache
def run_of(number: int) -> Run:
    return drawn_run(number)


def tables(run: Run) -> Tables:
    return Tables(run, Alarms(run, None))


@pytest.mark.parametrize("number", NUMBERS)
def test_every_event_is_there_once_and_in_order(number: int) -> None:
    run = run_of(number)
    there = tables(run)
    rows = there.events(checked=True)
    assert [row.event for row in rows if row.alarm is None] == list(run.events)
    report = Alarms(run, None).report
    met = [row.event for row in rows if row.alarm is not None]
    assert sorted(met) == sorted([*report.contacts, *report.near_misses])
    times = [happened.time_of(row) for row in rows]
    assert times == sorted(times)
    for row in there.events(checked=False):
        words = event_text(row.event)  # type: ignore[arg-type]
        assert words is None or words[0] == COLUMNS["events"]["kind"].of(row)


@pytest.mark.parametrize("number", NUMBERS)
def test_a_row_leads_to_its_event(number: int) -> None:
    run = run_of(number)
    d = Debugger(run, DIALECTS["val2+"])
    d.tables.events(checked=False)
    for row in d.tables.events(checked=False):
        event = row.event
        d.go_to(happened.stop_at(run, row))
        assert d.at.time_s == event.time_s  # type: ignore[union-attr]
        done = [executes(run, row.number, process=process) for process in (False, True)]
        causes = [run.history.code.causes[k] for k in done if k is not None]
        at_once = abs(run.history.time_of(row.number) - d.at.time_s) < INSTANT
        if event.cause is not None and at_once and event.cause in causes:
            assert d.at.finished == row.number - 1
            assert d.current(process=d.stop.process) == event.cause
        else:
            assert d.stop.cause == event.cause
            assert run.at_moment(*d.at).finished == d.at.finished
        if isinstance(event, SignalChanged) and event.cause is not None and d.stop.by is None:
            assert (event.signal in d.state.signals) is not event.on
            assert (event.signal in run.at_statement(row.number).signals) is event.on


@pytest.mark.parametrize("number", NUMBERS)
def test_every_call_is_there_with_its_begin_and_end(number: int) -> None:
    run = run_of(number)
    rows = tables(run).calls()
    known = {
        id(activation): activation
        for history in (run.history.robot, run.history.process)
        for since, activation in zip(history.trace.changed, history.trace.activations, strict=True)
        if activation is not None and since <= run.statements
    }
    assert {*known} <= {id(row.activation) for row in rows}
    assert len({id(row.activation) for row in rows}) == len(rows)
    for row in rows:
        inside = frames(run, row.begin, process=row.process)
        assert inside[0].activation is row.activation
        assert len(inside) == row.depth
        assert row.begin <= row.end
        history = run.history.process if row.process else run.history.robot
        chain: list[Activation] = []
        activation = history.trace.activation(row.end.finished)
        while activation is not None:
            chain.append(activation)
            activation = activation.caller
        assert row.over is not any(each is row.activation for each in chain)


def condition(chance: random.Random, table: str, rows: list[Any], depth: int) -> tuple[str, Fits]:
    """Return a condition as text, and what Python makes of it."""
    kind = chance.random()
    if depth and kind < 0.25:
        text, fits = condition(chance, table, rows, depth - 1)
        return f"NOT ({text})", lambda row: not fits(row)
    if depth and kind < 0.6:
        (a, one), (b, two) = (condition(chance, table, rows, depth - 1) for _ in range(2))
        if chance.random() < 0.5:
            return f"({a}) and ({b})", lambda row: one(row) and two(row)
        return f"{a} or {b}", lambda row: one(row) or two(row)
    name = chance.choice([*COLUMNS[table]])
    column: Column[Any] = COLUMNS[table][name]
    known = [value for row in rows if (value := column.of(row)) is not None]
    if column.number:
        number = chance.choice([*(value for value in known if isinstance(value, float | int)), 2.5])
        sign = chance.choice(["=", "<>", "<", ">", "<=", ">="])
        compare: dict[str, Callable[[float, float], bool]] = {
            "=": lambda a, b: a == b,
            "<>": lambda a, b: a != b,
            "<": lambda a, b: a < b,
            ">": lambda a, b: a > b,
            "<=": lambda a, b: a <= b,
            ">=": lambda a, b: a >= b,
        }
        unit = f" {column.unit}" if column.unit and chance.random() < 0.3 else ""

        def numeric(row: Any) -> bool:
            value: Any = column.of(row)
            return value is not None and compare[sign](value, number)

        return f"{name} {sign} {number!r}{unit}", numeric
    choices = [*column.only, *(text for value in known for text in texts_of(value))]
    text = chance.choice([choice for choice in choices if '"' not in choice] or ["can1"])
    sign = chance.choice(["=", "<>", "~"])

    def textual(row: Any) -> bool:
        value = column.of(row)
        if value is None:
            return False
        texts = [each.lower() for each in texts_of(value)]
        if sign == "~":
            return any(text.lower() in each for each in texts)
        return (text.lower() in texts) is (sign == "=")

    return f'{name} {sign} "{text}"', textual


@pytest.mark.parametrize("seed", first(4, range(40)))
def test_questions_are_answered_as_python_would(seed: int) -> None:
    chance = random.Random(seed)
    run = run_of((0, 2, 4)[seed % 3])
    there, table = tables(run), ("events", "calls")[seed % 2]
    rows: list[Any] = there.calls() if table == "calls" else there.events(checked=False)
    for _ in range(25):
        text, fits = condition(chance, table, rows, chance.randrange(4))
        if len(text) > LONGEST - 60:
            continue
        limit = chance.choice(["", "first 3", "last 2"])
        by = chance.choice(["", *COLUMNS[table]])
        order = chance.choice(["", " down"]) if by else ""
        query = f"where {text}{' by ' if by else ''}{by}{order} {limit}"
        read = read_query(query, COLUMNS[table], 0.0, table)
        assert read.fits is not None
        wanted = [row for row in rows if fits(row)]
        assert [row for row in rows if read.fits(row)] == wanted, query
        if table == "events" and read.kinds is not None:
            kinds = {COLUMNS[table]["kind"].of(row) for row in wanted}
            assert kinds <= read.kinds, query
            if not read.kinds.isdisjoint(happened.CHECKED):
                continue
        elif table == "events":
            continue  # contacts are among the rows then
        answer = there.asked(table, query, Instant(0.0, 0))
        of = COLUMNS[table][by].of if by else None
        if of is not None:
            having: list[Any] = [row for row in wanted if of(row) is not None]
            without = [row for row in wanted if of(row) is None]
            having.sort(key=of, reverse=bool(order))  # type: ignore[arg-type]
            wanted = [*having, *without]
        kept = wanted[:3] if limit == "first 3" else wanted[-2:] if limit else wanted[:200]
        stops = [
            calls.stop_at(row) if table == "calls" else happened.stop_at(run, row) for row in kept
        ]
        assert [row.go for row in answer.rows] == stops, query
        assert answer.total == len(wanted)
        assert [row.number for row in answer.rows] == [*range(1, len(kept) + 1)]


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ("where bodi = can1", "no column `bodi`: `body`?\ncolumns: time [s], kind"),
        ("where kind = contcat", "`kind` is never `contcat`: `contact`?"),
        ("where time > 3 mm", "`time` is in s, not in mm"),
        ("where time > soon", "`time` is a number [s], not `soon`"),
        ("where time > nan", "`time` is a number [s], not `nan`"),
        ("where time", "a comparison is missing"),
        ("where time >", "a value is missing"),
        ("where body < can1", "`body` is a text"),
        ("where time ~ 3", "`~` is for texts"),
        ("where (time > 3", "a `)` is missing"),
        ("where time > 3)", "`)` is not understood here"),
        ("where", "a column is missing"),
        ("body = can1", "a condition begins with `where`"),
        ("by", "a column is missing"),
        ("by speed", "no column `speed`"),
        ("first 0", f"from 1 to {MOST:,}"),
        ("first many", "takes how many rows"),
        ('where body = "can1', "is not understood"),
        ("where " + "(" * 30 + "time > 3" + ")" * 30, "at most 20 deep"),
        ("where " + "not " * 100 + "time > 3", "at most 20 deep"),
        ("x" * (LONGEST + 1), f"at most {LONGEST} characters"),
    ],
)
def test_what_cannot_be_asked_is_refused_with_the_reason(query: str, words: str) -> None:
    with pytest.raises(CannotTell) as problem:
        read_query(query, COLUMNS["events"], 0.0, "events")
    assert words in str(problem.value)


def test_any_text_is_answered_or_refused() -> None:
    chance, there = random.Random(1), tables(run_of(0))
    pieces = ["where", "by", "first", "last", "3", "1e999", "kind", "=", "<", "~", "(", ")", "not"]
    pieces += ["and", "or", "signal", '"', "x", "body", "time", "here", "on", "\x1b", "ä", "down"]
    for _ in range(1_000):
        words = ["kind", "=", "signal", "and"] if chance.random() < 0.3 else []
        text = " ".join([*words, *chance.choices(pieces, k=chance.randrange(8))])
        with contextlib.suppress(CannotTell):
            assert there.asked("calls", f"where {text}", Instant(0.0, 0)).total >= 0
