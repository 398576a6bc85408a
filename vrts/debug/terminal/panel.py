"""What the terminal shows while a program is debugged: rows of styled text, for any size."""

from vrts.debug.breakpoints import resolve
from vrts.debug.debugger import Debugger, Stop, Why
from vrts.debug.scripted.places import WORDS, current, source_of
from vrts.debug.scripted.session import Session
from vrts.debug.terminal.fitting import Row, cut, fitted, typed, wrapped
from vrts.debug.terminal.side import side_width, value_rows
from vrts.debug.terminal.view import TERMINAL_ROWS, Page, Question, View
from vrts.report.plain import one_line, visible, width

LEAST_WIDTH, LEAST_HEIGHT = 72, 20
MOST_TITLE = 2  # rows
SHORT_HELP = " n s o c t forward  N S C T back  b breakpoint  : command  ? all keys  q end"
LIST_HELP = " up, down, PgUp, PgDn choose; Enter goes there, and n goes on; Escape goes back"
PAGE_HELP = " up, down, PgUp, PgDn scroll; Escape goes back"


def panel(session: Session, view: View, columns: int, rows: int) -> list[Row]:
    """Return the rows of the screen; what fits is noted in the view."""
    if columns < LEAST_WIDTH or rows < LEAST_HEIGHT:
        text = f"at least {LEAST_WIDTH} x {LEAST_HEIGHT} characters are needed"
        return [[("alarm", line)] for line in wrapped([text], columns)[: max(rows, 1)]]
    view.width, view.height = columns, rows
    if view.page is not None and view.question is None:
        return _page(view, view.page)
    debugger = session.debugger
    top = _title(session, columns)
    below = _below(debugger, view)
    body = rows - len(top) - len(below) - 3
    side = side_width(columns)
    left = source_rows(session, view, columns - side - 1, body)
    right = value_rows(debugger, side - 1, body)
    found = list(top)
    for k in range(body):
        row = fitted(left[k] if k < len(left) else [], columns - side - 1)
        beside = fitted([("", " "), *(right[k] if k < len(right) else [])], side)
        found.append([*row, ("frame", "│"), *beside])
    found.append([("frame", "─" * columns)])
    found += below
    found.append(time_bar(debugger, columns))
    found.append(_bottom(view.question, columns))
    return found


def source_rows(session: Session, view: View, room: int, height: int) -> list[Row]:
    """Return the lines around the one that is executed next, or was chosen."""
    debugger, process = session.debugger, session.process
    cause = current(debugger, process=process) or current(debugger, process=False)
    source = source_of(debugger, process=process)
    if cause is None or source is None:
        return [[("dim", "nothing was executed")]]
    count = len(source.line_starts)
    chosen = view.cursor or cause.span.line
    first = max(1, min(chosen - height // 2, count - height + 1))
    code = debugger.run.history.code
    points = {
        found.line: bool(point.log or point.condition or point.hits)
        for point in debugger.wishes.lines
        if point.source == source.name and (found := resolve(code, source.name, point.line))
    }
    motion = debugger.state.cause
    moving = motion.span.line if motion is not None and motion.span.source is source else None
    blamed = debugger.stop.cause
    blame = blamed.span.line if blamed is not None and blamed.span.source is source else None
    rows: list[Row] = []
    for line in range(first, min(first + height, count + 1)):
        mark = " " if line not in points else "◆" if points[line] else "●"
        here = "▶" if line == cause.span.line else " "
        here = here if here != " " else "!" if line == blame else "~" if line == moving else " "
        text = visible(source.line_text(line).replace("\t", "    "))
        style = "here" if line == cause.span.line else "chosen" if line == view.cursor else ""
        rows.append(
            [("point", mark), ("dim", f"{line:4d} "), (style, cut(f"{here} {text}", room - 6))]
        )
    return rows


def time_bar(debugger: Debugger, columns: int) -> Row:
    """Return the run as a bar, with marks where alarms were looked for and found."""
    run = debugger.run
    label = f" {debugger.at.time_s:8.3f} s of {run.horizon_s:.3f} s "
    length = max(columns - len(label) - 2, 2)
    cells = ["─"] * length
    for alarm in debugger.alarms.of(debugger.wishes.filters):
        cells[_column(alarm.instant.time_s, run.horizon_s, length)] = "!"
    at = _column(debugger.at.time_s, run.horizon_s, length)
    pieces: Row = [("frame", "["), ("bar", "".join(cells[:at])), ("here", "█")]
    return [*pieces, ("bar", "".join(cells[at + 1 :])), ("frame", "]"), ("", label)]


def time_at(column: int, horizon_s: float, columns: int, label: int = 0) -> float:
    """Return the time [s] that a column of the time bar stands for."""
    length = max(columns - label - 2, 2)
    return horizon_s * min(max(column - 1, 0), length - 1) / (length - 1)


def _column(time_s: float, horizon_s: float, length: int) -> int:
    return round(time_s / horizon_s * (length - 1)) if horizon_s > 0.0 else 0


def _title(session: Session, columns: int) -> list[Row]:
    cause = current(session.debugger, process=session.process)
    where = (
        "" if cause is None else f"{one_line(cause.program)} {cause.step}, line {cause.span.line}"
    )
    thread = "process control program " if session.process else ""
    stop = session.debugger.stop
    style = "alarm" if stop.why is Why.ALARM else "title"
    lines = wrapped([f" {thread}{where}  {_words(stop)}"], columns - 1)
    if len(lines) > MOST_TITLE:
        lines = [*lines[: MOST_TITLE - 1], cut(" ".join(lines[MOST_TITLE - 1 :]), columns - 1)]
    return [[(style, line + " " * (columns - width(line)))] for line in lines]


def _words(stop: Stop) -> str:
    text = f": {one_line(stop.text)}" if stop.text else ""
    blamed = f"; caused by line {stop.cause.span.line}" if stop.cause is not None else ""
    return f"{WORDS[stop.why]}{text}{blamed}"


def _below(debugger: Debugger, view: View) -> list[Row]:
    """Return hints of a question, what was said, or the last lines of the program's terminal."""
    columns = view.width
    question = view.question
    if question is not None and (question.hints or question.line.offered):
        offered = question.line.offered
        lines = [*question.hints, *([", ".join(offered)] if offered else [])]
        style, most = "said", view.most_said
    elif view.said:
        lines, style, most = view.said, "said", view.most_said
    else:
        lines = visible(debugger.state.output.replace("\r\n", "\n")).split("\n")[-TERMINAL_ROWS:]
        style, most = "", TERMINAL_ROWS
    shown = wrapped(lines, columns)
    shown = shown[-most:] if not style else shown[:most]
    rows = [fitted([(style, line)], columns) for line in shown]
    return [*rows, *([[]] * (TERMINAL_ROWS - len(rows)))]


def _bottom(question: Question | None, columns: int) -> Row:
    if question is None:
        return fitted([("help", SHORT_HELP)], columns)
    words = f"{question.words} " if len(question.words) > 1 else question.words
    line = question.line
    return [("prompt", words), *typed(line.text, line.at, columns - len(words) - 1)]


def _page(view: View, page: Page) -> list[Row]:
    room = view.page_rows
    lines, choices = page.drawn(view.width), page.choices
    if choices:
        first = next(row for row, (k, _) in enumerate(lines) if k == page.chosen)
        last = max(row for row, (k, _) in enumerate(lines) if k == page.chosen)
        first = 0 if page.chosen == choices[0] else first
        last = len(lines) - 1 if page.chosen == choices[-1] else last
        page.top = min(max(page.top, last - room + 1), max(first, last - room + 1))
    page.top = max(0, min(page.top, len(lines) - room))
    shown = lines[page.top : page.top + room]
    part = f"{page.top + 1} to {page.top + len(shown)} of {len(lines)}"
    part = part if len(lines) > room else ""
    title = cut(f" {visible(page.title)}", view.width - len(part) - 2)
    gap = " " * (view.width - width(title) - len(part) - 1)
    found: list[Row] = [[("title", f"{title}{gap}{part} ")]]
    for k, line in shown:
        style = "chosen" if choices and k == page.chosen else ""
        found.append(fitted([(style, line)], view.width))
    found += [[]] * (room - len(shown))
    words = LIST_HELP if choices else PAGE_HELP
    return [*found, fitted([("help", words)], view.width)]
