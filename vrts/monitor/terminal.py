"""The monitor at a terminal: real time, history, completion. The door to prompt_toolkit.

The clock is given from outside; simulated time follows it, and what programs write appears above
the line that is being typed.
"""

import asyncio
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

from prompt_toolkit import PromptSession
from prompt_toolkit.application import Application
from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document
from prompt_toolkit.history import FileHistory, History, InMemoryHistory
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.keys import Keys
from prompt_toolkit.layout import FormattedTextControl, Layout, Window
from prompt_toolkit.patch_stdout import patch_stdout

from vrts.monitor.completion import completions
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.pendant import Pendant, press, screen
from vrts.report.plain import plain_text

BEAT = 0.1  # [s] of real time between looks at the clock

Clock = Callable[[], float]
_KEYS = {"\r": "enter", "\n": "enter", "\x1b": "escape", "\x7f": "backspace", "\x08": "backspace"}


class _Pace:
    """Simulated time that follows a clock."""

    def __init__(self, dialogue: Dialogue, clock: Clock) -> None:
        self._dialogue = dialogue
        self._clock = clock
        self._ahead = dialogue.time_s - clock()

    def catch_up(self) -> str:
        """Let as much time pass as the clock says; return what the terminal shows meanwhile."""
        now = self._clock() + self._ahead
        return self._dialogue.advance(now) if now > self._dialogue.time_s else ""


class _Names(Completer):
    def __init__(self, dialogue: Dialogue) -> None:
        self._dialogue = dialogue

    def get_completions(
        self, document: Document, complete_event: CompleteEvent
    ) -> Iterable[Completion]:
        monitor = self._dialogue.monitor
        if not monitor.at_commands:
            return
        line = document.text_before_cursor
        for word in completions(line, monitor.desk, self._dialogue.state):
            yield Completion(word, start_position=-_common(line, word))


def _common(line: str, word: str) -> int:
    """Return how much of a word has been typed."""
    for length in range(min(len(word), len(line)), 0, -1):
        if line.lower().endswith(word[:length].lower()):
            return length
    return 0


def converse(dialogue: Dialogue, clock: Clock, history: Path | None) -> None:
    """Read lines until the end of input (Ctrl-D).

    Args:
        dialogue: What is driven.
        clock: Returns real time [s].
        history: A file for the lines typed; None keeps them for this time only.
    """
    kept: History = InMemoryHistory() if history is None else FileHistory(str(history))
    asyncio.run(_Conversation(dialogue, clock, kept).run())


class _Conversation:
    def __init__(self, dialogue: Dialogue, clock: Clock, history: History) -> None:
        self._dialogue = dialogue
        self._pace = _Pace(dialogue, clock)
        self._begun = ""  # a line that a program has begun to write
        self._session: PromptSession[str] = PromptSession(
            self._message,
            history=history,
            completer=_Names(dialogue),
            complete_while_typing=False,
        )

    def _message(self) -> str:
        return self._begun + self._dialogue.prompt

    async def run(self) -> None:
        with patch_stdout(raw=True):
            beat = asyncio.create_task(self._beat())
            try:
                while await self._line():
                    pass
            finally:
                beat.cancel()

    async def _line(self) -> bool:
        try:
            line = await self._session.prompt_async()
        except KeyboardInterrupt:
            self._begun = ""
            self._show(self._dialogue.interrupt())
            return True
        except EOFError:
            return False
        self._begun = ""
        self._show(self._pace.catch_up())
        self._show(self._dialogue.enter(line))
        return True

    async def _beat(self) -> None:
        shown = ""
        while True:
            await asyncio.sleep(BEAT)
            self._show(self._pace.catch_up())
            if self._message() != shown:
                shown = self._message()
                self._session.app.invalidate()

    def _show(self, text: str) -> None:
        """Write whole lines above the prompt; the rest stands before what is typed."""
        lines, _, self._begun = (self._begun + plain_text(text)).rpartition("\n")
        if lines or text.endswith("\n"):
            sys.stdout.write(f"{lines}\n")
            sys.stdout.flush()


def teach(dialogue: Dialogue, clock: Clock) -> Pendant:
    """Show the pendant and take keys until the session is over; return what it recorded."""
    return _PendantScreen(dialogue, clock).run()


class _PendantScreen:
    def __init__(self, dialogue: Dialogue, clock: Clock) -> None:
        self._dialogue = dialogue
        self._pace = _Pace(dialogue, clock)
        self._pendant = Pendant()
        self._said = ""
        window = Window(FormattedTextControl(self._text, focusable=True))
        self._app: Application[None] = Application(
            Layout(window), key_bindings=self._bindings(), full_screen=True
        )

    def run(self) -> Pendant:
        asyncio.run(self._run())
        return self._pendant

    async def _run(self) -> None:
        beat = asyncio.create_task(self._beat())
        try:
            await self._app.run_async()
        finally:
            beat.cancel()

    async def _beat(self) -> None:
        shown = ""
        while True:
            await asyncio.sleep(BEAT)
            self._said += self._pace.catch_up()
            if self._text() != shown:
                shown = self._text()
                self._app.invalidate()

    def _text(self) -> str:
        arm = self._dialogue.controller.run.scene.robot.arm
        return plain_text(screen(self._pendant, self._dialogue.state, arm, self._said))

    def _bindings(self) -> KeyBindings:
        bindings = KeyBindings()

        def take(event: KeyPressEvent) -> None:
            self.press(_KEYS.get(event.data, "space" if event.data == " " else event.data))

        def leave(event: KeyPressEvent) -> None:
            self._pendant = self._pendant._replace(done="quit")
            self._app.exit()

        for keys in (Keys.Any, Keys.ControlM, Keys.ControlH, Keys.Escape):
            bindings.add(keys)(take)
        bindings.add(Keys.ControlC)(leave)
        return bindings

    def press(self, key: str) -> None:
        """Take a key; a motion waits for no other: keys while the arm moves are passed over."""
        found = press(self._pendant, key, self._dialogue.state)
        if found.instruction and self._dialogue.busy:
            return
        self._pendant = found.pendant
        self._said = ""
        if found.value is not None:
            self._dialogue.issue(found.value)
        if found.instruction:
            self._said = self._dialogue.enter(f"DO {found.instruction}")
        if found.pendant.done:
            self._app.exit()
