"""The pendant at a terminal: the whole screen, keys, and a clock that is given from outside."""

import asyncio
import errno

from prompt_toolkit.application import Application
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.keys import Keys
from prompt_toolkit.layout import FormattedTextControl, Layout, Window

from vrts.ir.commands import Panic
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.pace import BEAT, Clock, Pace
from vrts.monitor.pendant import Pendant, press, screen
from vrts.monitor.screens.hanging_up import hang_up
from vrts.report.plain import plain_text

_KEYS = {"\r": "enter", "\n": "enter", "\x1b": "escape", "\x7f": "backspace", "\x08": "backspace"}


def teach(dialogue: Dialogue, clock: Clock) -> Pendant:
    """Show the pendant and take keys until the session is over; return what it recorded."""
    return _PendantScreen(dialogue, clock).run()


class _PendantScreen:
    def __init__(self, dialogue: Dialogue, clock: Clock) -> None:
        self._dialogue = dialogue
        self._pace = Pace(dialogue, clock)
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
            with hang_up(self._end):
                await self._app.run_async()
        except (EOFError, OSError) as problem:
            if isinstance(problem, OSError) and problem.errno != errno.EIO:
                raise
            self._end()  # the terminal has gone
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

        def stop(event: KeyPressEvent) -> None:
            self._pendant = self._pendant._replace(naming=None)
            self._said = self._dialogue.issue(Panic()) or "stopped"

        def leave(event: KeyPressEvent) -> None:
            self._end()

        for keys in (Keys.Any, Keys.ControlM, Keys.ControlH, Keys.Escape):
            bindings.add(keys)(take)
        bindings.add(Keys.ControlC)(stop)
        bindings.add(Keys.ControlD)(leave)
        return bindings

    def _end(self) -> None:
        """End at Ctrl-D and when the terminal has gone: what was recorded is kept."""
        self._pendant = self._pendant._replace(done="write")
        if self._app.is_running and not self._app.is_done:
            self._app.exit()

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
