"""Keys of the terminal debugger: what each does to where it stands, without any terminal."""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from vrts.debug.alarms import Filter
from vrts.debug.breakpoints import Breakpoint, is_hit_rule, resolve
from vrts.debug.events.asking import Answer as Table
from vrts.debug.scripted.breaking import Asked, read_breakpoint, written
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.names import bases, wrong_condition
from vrts.debug.scripted.places import current, source_of
from vrts.debug.scripted.recording import Recorder
from vrts.debug.scripted.session import Done, Session
from vrts.debug.scripted.table import COMMANDS, help_lines
from vrts.debug.terminal.key_table import KEYS, help_of_keys
from vrts.debug.terminal.line import MOST_KEPT, Line
from vrts.debug.terminal.view import Page, Question, View
from vrts.report.plain import visible

LEAP = 0.1  # [s]
PAGE = 10  # lines
_SCROLL = {"up": -1, "down": 1, "page up": -PAGE, "page down": PAGE, " ": PAGE}
_CLOSE = frozenset({"q", "?", "escape", "enter"})
_OF_LINES = frozenset({"b", "B", "g", "j", ":", "a", "w"})  # which keep the line chosen


class Outside(NamedTuple):
    """What keys ask for that is no matter of the debugger; each returns what to say about it."""

    page: Callable[[float], str]  # opens a time [s] in 3D in the browser
    rerun: Callable[[float], str]  # ... in the Rerun viewer
    news: Callable[[], str]  # tells what has changed on disk


class Keyboard:
    """Takes keys one by one; all that moves or changes is a command, and can be recorded."""

    def __init__(
        self, session: Session, view: View, outside: Outside, recorder: Recorder | None = None
    ) -> None:
        """Take what the keys act on, and what keeps the commands."""
        self._session = session
        self._debugger = session.debugger
        self._view = view
        self._news = outside.news
        self._recorder = recorder or Recorder(None)
        self._typed: dict[str, list[str]] = {}  # lines by the words that asked for them
        self._commands: dict[str, Callable[[], object]] = {
            "right": lambda: self._do(f"at {self._debugger.at.time_s + LEAP!r}"),
            "left": lambda: self._do(f"at {max(self._debugger.at.time_s - LEAP, 0.0)!r}"),
            "b": self._breakpoint,
            "B": self._form,
            "g": lambda: self._of_line("to"),
            "j": lambda: self._of_line("jump"),
            "v": lambda: self._say("", [outside.page(self._debugger.at.time_s)]),
            "V": lambda: self._say("", [outside.rerun(self._debugger.at.time_s)]),
            "a": self._alarms,
            "w": self._watch,
            ":": self._line,
            "?": self._help,
        }
        for key in KEYS:
            for name in key.names:
                if key.command and name not in self._commands:
                    self._commands[name] = lambda command=key.command: self._do(command)

    def press(self, key: str) -> bool:
        """Take a key; return whether that was the end."""
        view = self._view
        if view.question is not None:
            self._type(view.question, key)
            return False
        if view.page is not None:
            if key in _SCROLL:
                view.scroll(_SCROLL[key])
                return False
            page, view.page = view.page, None
            if key == "enter" and page.choices:
                self._do(f"go {page.goes[page.chosen]}")
                return False
            if key in _CLOSE:
                return False
        if key == "q":
            return True
        if key in _SCROLL and key != " ":
            self._choose(_SCROLL[key])
            self.look()
            return False
        deed = self._commands.get(key)
        if deed is not None:
            view.said = []
            if key not in _OF_LINES:
                view.cursor = None
            deed()
            self.look()
        return False

    def paste(self, text: str) -> None:
        """Take pasted text where a line is typed."""
        if self._view.question is not None:
            self._view.question.line.insert(text)

    def seek(self, time_s: float) -> None:
        """Go to a time [s] that was pointed at."""
        if self._view.question is None and self._view.page is None:
            self._do(f"at {time_s!r}")

    def look(self) -> bool:
        """Show what has changed on disk, and return whether that is new.

        It waits while a line is typed or a page is read; nothing is read again by itself.
        """
        if self._view.question is not None or self._view.page is not None:
            return False
        news = self._news()
        if news:
            self._say("", [*self._view.said, news])
        return bool(news)

    def interrupted(self) -> bool:
        """Give up what is under way, or the line that is typed; that is never the end."""
        view = self._view
        if view.question is None:
            self._say("", ["stopped: nothing is changed; q or Ctrl-D leaves"])
        view.question, view.page = None, None
        return False

    def failed(self, problem: Exception) -> None:
        """Say that something went wrong that never should: the session goes on."""
        view = self._view
        view.question, view.page = None, None
        kind = type(problem).__name__
        words = f"that failed, and nothing is changed: {kind}: {problem}"
        self._say("", [words[:1000], "this is a fault of vrts: please report it"])

    # --- deeds --------------------------------------------------------------------------------

    def _do(self, line: str) -> None:
        done = carry_out(self._session, line)
        lost = self._recorder.add(done)
        rows = [f"{row.time_s:.3f} s: {row.text}" for row in done.log]
        if done.table is not None and done.table.rows:
            self._list(line, done.table)
            return
        self._say(line, [*rows, *done.said, *([lost] if lost else [])])
        if any(done.goes):
            self._choices(line, done)
        if done.moved and done.ok:
            self._view.cursor = None

    def _list(self, line: str, table: Table) -> None:
        """Show rows to choose from, the last one up to here chosen."""
        here = [k for k, row in enumerate(table.rows) if row.go.instant <= self._debugger.at]
        lines = [*(row.text for row in table.rows), *table.says]
        goes = [k if k <= len(table.rows) else None for k in range(1, len(lines) + 1)]
        page = Page(line, [visible(each) for each in lines], goes=goes, table=True)
        page.chosen = here[-1] if here else 0
        self._view.page = page

    def _choices(self, line: str, done: Done) -> None:
        """Show an answer whose lines lead somewhere, the first of them chosen."""
        page = Page(line, [visible(each) for each in done.said], goes=done.goes)
        page.chosen = page.choices[0]
        self._view.page = page

    def _choose(self, lines: int) -> None:
        source = source_of(self._debugger, process=self._session.process)
        cause = current(self._debugger, process=self._session.process)
        if source is not None and cause is not None:
            line = (self._view.cursor or cause.span.line) + lines
            self._view.cursor = min(max(line, 1), len(source.line_starts))

    def _chosen(self) -> int | None:
        cause = current(self._debugger, process=self._session.process)
        return self._view.cursor or (cause.span.line if cause is not None else None)

    def _of_line(self, command: str) -> None:
        line = self._chosen()
        if line is not None:
            self._do(f"{command} {line}")

    def _point(self) -> tuple[int, Breakpoint | None] | None:
        """Return the line at which a breakpoint may stand, and the one that is there."""
        line = self._chosen()
        source = source_of(self._debugger, process=self._session.process)
        code = self._debugger.run.history.code
        found = None if line is None or source is None else resolve(code, source.name, line)
        if found is None or source is None:
            self._say("", ["no step of a program follows here"])
            return None
        wishes = self._debugger.wishes
        there = (p for p in wishes.lines if (p.source, p.line) == (source.name, found.line))
        return found.line, next(there, None)

    def _breakpoint(self) -> None:
        found = self._point()
        if found is not None:
            self._do(f"unbreak {found[0]}" if found[1] else f"break {found[0]}")

    def _form(self) -> None:
        found = self._point()
        if found is None:
            return
        line, there = found
        known = (there.condition, there.hits, there.log) if there else ("", "", "")
        texts: list[str] = []

        def ask() -> None:
            words, hint, _ = _FORM[len(texts)]
            self._ask(words, take, [f"breakpoint at line {line}: {hint}"], known[len(texts)])

        def take(text: str) -> None:
            words, hint, wrong = _FORM[len(texts)]
            problem = wrong(self._session, text)
            if problem:
                self._ask(words, take, [problem, hint], text)
                return
            texts.append(text.strip())
            if len(texts) < len(_FORM):
                ask()
                return
            command = written(line, *texts)
            if read_breakpoint(command) == Asked("", line, *texts):
                self._do(f"break {command}")
            else:
                self._say("", ["a breakpoint reads `hits` and `log` as its own words: rename them"])

        ask()

    def _alarms(self) -> None:
        filters = self._debugger.wishes.filters
        on = " ".join(kind.value for kind in Filter if kind in filters)
        words = [*(kind.value for kind in Filter), "all", "none"]
        hints = ["which alarms stop? " + ", ".join(words)]
        self._ask("alarms:", self._take_alarms, hints, f"{on} " if on else "", lambda: words)

    def _take_alarms(self, text: str) -> None:
        self._do(f"alarms {text.strip() or 'none'}")

    def _watch(self) -> None:
        names = [watch.name for watch in self._debugger.wishes.watches]
        hints = ["stop when what changes? A variable, a location, or a signal: `SIG(1001)`"]
        if names:
            hints.append(f"watched: {', '.join(names)}; one of them again ends that")
        self._ask("watch:", self._take_watch, hints, complete=lambda: bases(self._debugger))

    def _take_watch(self, text: str) -> None:
        name = text.strip()
        if name:
            known = [watch.name for watch in self._debugger.wishes.watches]
            self._do(f"unwatch {name}" if name in known else f"watch {name}")

    def _line(self) -> None:
        if self._session.console.reads_on:
            self._ask("more:", self._do, ["the command before asks for more"])
        elif self._debugger.asks:
            hints = ["the program waits for a line of the terminal"]
            self._ask("answer:", lambda text: self._do(f"answer {text}"), hints)
        else:
            hints = ["`help` lists the commands; Tab completes words"]
            self._ask(":", self._take_command, hints, complete=self._words)

    def _take_command(self, text: str) -> None:
        if text.strip():
            self._do(text.strip())

    def _words(self) -> Iterable[str]:
        return {*(entry.word for entry in COMMANDS), *bases(self._debugger)}

    def _help(self) -> None:
        commands = [f"  {line}" for line in help_lines()]
        lines = [*help_of_keys(), "", "Commands, typed after `:`", *commands]
        self._view.page = Page("All keys and commands", lines)

    # --- lines typed --------------------------------------------------------------------------

    def _ask(
        self,
        words: str,
        answer: Callable[[str], None],
        hints: list[str] | None = None,
        text: str = "",
        complete: Callable[[], Iterable[str]] = tuple,
    ) -> None:
        before = self._typed.setdefault(words, [])
        self._view.question = Question(words, Line(text, before, complete), answer, hints or [])

    def _type(self, question: Question, key: str) -> None:
        if key not in ("enter", "escape"):
            question.line.press(key)
            return
        self._view.question = None
        if key == "escape":
            return
        text = question.line.text
        before = self._typed[question.words]
        if text.strip() and before[-1:] != [text]:
            before.append(text)
            del before[:-MOST_KEPT]
        self._view.said = []
        question.answer(text)
        self.look()

    def _say(self, title: str, lines: Iterable[str]) -> None:
        self._view.say(title, [visible(line) for line in lines if line])


def _no_hits(session: Session, text: str) -> str:
    return "" if is_hit_rule(text) else f"`{text}` says not which hits count"


_FORM: tuple[tuple[str, str, Callable[[Session, str], str]], ...] = (
    (
        "condition:",
        "stop only where this is not zero, such as `i > 3`; empty: always",
        lambda session, text: wrong_condition(session.debugger, text),
    ),
    ("hits:", "which hits count: `5`, `>= 5`, `% 3`; empty: every one", _no_hits),
    ("log:", "write this and do not stop, such as `i is {i}`; empty: stop", lambda _, __: ""),
)
