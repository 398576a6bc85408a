"""Keys of the terminal debugger: what each does to where it stands, without any terminal."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.debug.alarms import LABELS
from vrts.debug.breakpoints import Breakpoint, Watch, resolve
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger, Way
from vrts.debug.evaluating import CannotTell
from vrts.debug.terminal.panel import ALARM_KEYS, View, current, source_of
from vrts.ir.commands import GoTo
from vrts.report.plain import visible

LEAP = 0.1  # [s]
PAGE = 10  # lines
MOST_TYPED = 200  # characters


class Outside(NamedTuple):
    """What keys ask for that is no matter of the debugger; each returns what to say about it."""

    page: Callable[[float], str]  # opens a time [s] in 3D in the browser
    rerun: Callable[[float], str]  # ... in the Rerun viewer
    restart: Callable[[], str]  # begins again, with the files as they are now
    news: Callable[[], str]  # tells what has changed on disk


class Keyboard:
    """Takes keys one by one."""

    def __init__(self, debugger: Debugger, console: Console, view: View, outside: Outside) -> None:
        """Take what the keys act on."""
        self._debugger = debugger
        self._console = console
        self._view = view
        self._news = outside.news
        self._answer: Callable[[str], None] | None = None  # takes the line that is typed
        self._next_id = 1
        self._commands: dict[str, Callable[[], object]] = {
            "n": lambda: self._step(Way.OVER),
            "s": lambda: self._step(Way.INTO),
            "o": lambda: self._step(Way.OUT),
            "N": self._back,
            "S": self._back,
            "c": debugger.go_on,
            "C": debugger.reverse,
            "t": lambda: debugger.tick(1),
            "T": lambda: debugger.tick(-1),
            "right": lambda: debugger.seek(debugger.at.time_s + LEAP),
            "left": lambda: debugger.seek(debugger.at.time_s - LEAP),
            "home": lambda: debugger.seek(0.0),
            "end": lambda: debugger.seek(debugger.run.horizon_s),
            "r": lambda: self._say(outside.restart()),
            "b": self._breakpoint,
            "g": self._run_to,
            "j": self._jump,
            "p": self._other_program,
            "v": lambda: self._say(outside.page(debugger.at.time_s)),
            "V": lambda: self._say(outside.rerun(debugger.at.time_s)),
            "a": lambda: self._ask(f"alarms that stop ({_alarm_words()}): ", self._alarms),
            "w": lambda: self._ask("stop when this changes: ", self._watch),
            "y": lambda: self._say(*self._console.why().split("\n")),
            ":": lambda: self._ask(":", self._command),
        }

    def press(self, key: str) -> bool:
        """Take a key; return whether that was the end."""
        view = self._view
        if view.asked is not None:
            self._type(key)
            return False
        if key == "q":
            return True
        view.help = key == "?" and not view.help
        if key in ("up", "down", "page up", "page down"):
            self._choose(-1 if "up" in key else 1, PAGE if "page" in key else 1)
            return False
        deed = self._commands.get(key)
        if deed is not None:
            view.said = []
            if key not in ("b", "g", "j", ":", "a", "w"):
                view.cursor = None
            with self._debugger.whole():
                deed()
            self._tell()
        return False

    def interrupted(self) -> bool:
        """Give up what is under way, or the line that is typed; that is never the end."""
        view = self._view
        if view.asked is None:
            self._say("stopped: nothing is changed; q or Ctrl-D leaves")
        view.asked, view.typed, self._answer = None, "", None
        return False

    # --- deeds --------------------------------------------------------------------------------

    def _step(self, way: Way) -> None:
        self._debugger.step(way, process=self._view.process)

    def _back(self) -> None:
        self._debugger.step_back(process=self._view.process)

    def _choose(self, direction: int, lines: int) -> None:
        source = source_of(self._debugger, self._view)
        cause = current(self._debugger, process=self._view.process)
        if source is None or cause is None:
            return
        line = (self._view.cursor or cause.span.line) + direction * lines
        self._view.cursor = min(max(line, 1), len(source.line_starts))

    def _line(self) -> tuple[str, int] | None:
        source = source_of(self._debugger, self._view)
        cause = current(self._debugger, process=self._view.process)
        if source is None or cause is None:
            return None
        return source.name, self._view.cursor or cause.span.line

    def _breakpoint(self) -> None:
        place = self._line()
        found = place and resolve(self._debugger.run.history.code, *place)
        if place is None or not found:
            self._say("no step of a program follows here")
            return
        wishes = self._debugger.wishes
        there = [
            point for point in wishes.lines if (point.source, point.line) == (place[0], found.line)
        ]
        if there:
            wishes.lines = [point for point in wishes.lines if point not in there]
        else:
            wishes.lines = [*wishes.lines, Breakpoint(self._next_id, place[0], found.line)]
            self._next_id += 1

    def _run_to(self) -> None:
        place = self._line()
        if place is not None:
            self._debugger.run_to(*place)
            self._view.cursor = None

    def _jump(self) -> None:
        place = self._line()
        found = place and resolve(self._debugger.run.history.code, *place)
        if not found:
            return
        cause = self._debugger.run.history.code.causes[min(found.instructions)]
        now = current(self._debugger, process=self._view.process)
        if now is None or now.program != cause.program:
            self._say("only a step of the program that is being executed can come next")
            return
        refused = self._debugger.change([GoTo(cause.step, self._view.process)])
        self._say(*refused)
        self._view.cursor = None

    def _other_program(self) -> None:
        if self._debugger.passages(process=True).count:
            self._view.process = not self._view.process
        else:
            self._say("there is no process control program")

    def _alarms(self, text: str) -> None:
        self._debugger.wishes.filters = frozenset(kind for key, kind in ALARM_KEYS if key in text)

    def _watch(self, text: str) -> None:
        wishes, name = self._debugger.wishes, text.strip()
        others = [watch for watch in wishes.watches if watch.name != name]
        if name and len(others) == len(wishes.watches):
            others.append(Watch(self._next_id, name))
            self._next_id += 1
        wishes.watches = others
        self._say("stops at changes of: " + (", ".join(w.name for w in others) or "nothing"))

    def _command(self, text: str) -> None:
        try:
            shown = self._console.enter(text)
        except CannotTell as problem:
            shown = str(problem)
        self._say(*shown.rstrip("\n").split("\n"))

    # --- lines typed --------------------------------------------------------------------------

    def _ask(self, words: str, answer: Callable[[str], None]) -> None:
        self._view.asked, self._view.typed, self._answer = words, "", answer

    def _type(self, key: str) -> None:
        view = self._view
        if key in ("enter", "escape"):
            answer, text = self._answer, view.typed
            view.asked, view.typed, self._answer = None, "", None
            if key == "enter" and answer is not None:
                with self._debugger.whole():
                    answer(text)
        elif key == "backspace":
            view.typed = view.typed[:-1]
        elif key.isprintable() and len(key) == 1 and len(view.typed) < MOST_TYPED:
            view.typed += key

    def _say(self, *lines: str) -> None:
        self._view.said = [visible(line) for line in lines if line]

    def _tell(self) -> None:
        """Show what was logged on the way, and what has changed on disk."""
        log = self._debugger.log
        told = [f"{one.instant.time_s:.3f} s: {one.text}" for one in log]
        log.clear()
        news = self._news()
        if told or news:
            self._say(*told, news)


def _alarm_words() -> str:
    return ", ".join(f"{key} {LABELS[kind].lower()}" for key, kind in ALARM_KEYS)
