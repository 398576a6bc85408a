"""Debugging at a terminal: the whole screen, and the same keys forward and backward."""

import asyncio
from collections.abc import Callable
from contextlib import suppress

from prompt_toolkit.application import Application, get_app
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.keys import Keys
from prompt_toolkit.layout import FormattedTextControl, Layout, Window
from prompt_toolkit.mouse_events import MouseEvent, MouseEventType
from prompt_toolkit.styles import Style

from vrts.debug.scripted.recording import Recorder
from vrts.debug.scripted.session import Session
from vrts.debug.terminal.fitting import Row
from vrts.debug.terminal.interrupting import interruptible
from vrts.debug.terminal.keys import Keyboard, Outside
from vrts.debug.terminal.panel import panel, time_at, time_bar
from vrts.debug.terminal.view import View

LOOK = 1.0  # [s] between two looks at the files while no key is pressed
_STYLE = Style.from_dict(
    {
        "title": "reverse bold",
        "alarm": "reverse bold ansired",
        "here": "bold ansicyan",
        "chosen": "reverse",
        "point": "bold ansired",
        "dim": "ansibrightblack",
        "head": "ansiblue",
        "frame": "ansibrightblack",
        "bar": "ansigreen",
        "help": "ansibrightblack",
        "prompt": "bold",
        "cursor": "reverse",
        "said": "ansiyellow",
    }
)
_NAMES = {
    Keys.Up: "up",
    Keys.Down: "down",
    Keys.Left: "left",
    Keys.Right: "right",
    Keys.Home: "home",
    Keys.End: "end",
    Keys.PageUp: "page up",
    Keys.PageDown: "page down",
    Keys.ControlM: "enter",
    Keys.ControlJ: "enter",
    Keys.ControlH: "backspace",
    Keys.Delete: "delete",
    Keys.Escape: "escape",
    Keys.Tab: "tab",
    Keys.ControlA: "c-a",
    Keys.ControlE: "c-e",
    Keys.ControlK: "c-k",
    Keys.ControlU: "c-u",
    Keys.ControlW: "c-w",
}


def debug(session: Session, outside: Outside, recorder: Recorder) -> None:
    """Show the program and take keys until the user ends it.

    Args:
        session: Where it stands.
        outside: What keys ask for beside.
        recorder: Keeps the commands.
    """
    view = View()
    keyboard = Keyboard(session, view, outside, recorder)

    def text() -> StyleAndTextTuples:
        size = get_app().output.get_size()
        found: StyleAndTextTuples = []
        for row in _rows(session, view, keyboard, size.columns, size.rows):
            found += [(f"class:{style}" if style else "", words) for style, words in row]
            found.append(("", "\n"))
        return found[:-1]

    window = Window(_Control(text, session, keyboard), always_hide_cursor=True)
    app: Application[None] = Application(
        Layout(window),
        key_bindings=_bindings(keyboard),
        style=_STYLE,
        full_screen=True,
        mouse_support=True,
    )
    app.ttimeoutlen = 0.05

    async def look() -> None:
        while True:
            await asyncio.sleep(LOOK)
            if keyboard.look():
                app.invalidate()

    def begin() -> None:
        app.create_background_task(look())

    with suppress(EOFError):  # the terminal has gone
        app.run(pre_run=begin)


def _rows(session: Session, view: View, keyboard: Keyboard, columns: int, rows: int) -> list[Row]:
    try:
        return panel(session, view, columns, rows)
    except Exception as problem:
        keyboard.failed(problem)
        return [[("alarm", f"this cannot be shown: {problem}"[: max(columns, 1)])]]


class _Control(FormattedTextControl):
    """The screen; a click on the time bar goes there."""

    def __init__(
        self, text: Callable[[], StyleAndTextTuples], session: Session, keyboard: Keyboard
    ) -> None:
        super().__init__(text, focusable=True)
        self._debugger = session.debugger
        self._keyboard = keyboard

    def mouse_handler(self, mouse_event: MouseEvent) -> None:
        size = get_app().output.get_size()
        at = mouse_event.position
        if mouse_event.event_type is MouseEventType.MOUSE_UP and at.y == size.rows - 2:
            label = len(time_bar(self._debugger, size.columns)[-1][1])
            horizon_s = self._debugger.run.horizon_s
            time_s = time_at(at.x, horizon_s, size.columns, label)
            _survived(self._keyboard, lambda: self._keyboard.seek(time_s))


def _survived(keyboard: Keyboard, deed: Callable[[], object]) -> object:
    """Do what a key asks for: neither Ctrl-C meanwhile nor a fault of ours ends the session."""
    try:
        return interruptible(deed)
    except KeyboardInterrupt:
        return keyboard.interrupted()
    except Exception as problem:
        return keyboard.failed(problem)


def _bindings(keyboard: Keyboard) -> KeyBindings:
    bindings = KeyBindings()

    def take(event: KeyPressEvent) -> None:
        key = event.key_sequence[0].key
        name = _NAMES.get(key) if isinstance(key, Keys) else None
        if _survived(keyboard, lambda: keyboard.press(name or event.data)) is True:
            event.app.exit()

    def paste(event: KeyPressEvent) -> None:
        keyboard.paste(event.data)

    def stop(event: KeyPressEvent) -> None:
        keyboard.interrupted()

    def leave(event: KeyPressEvent) -> None:
        event.app.exit()

    for known in (Keys.Any, *_NAMES):
        bindings.add(known)(take)
    bindings.add(Keys.BracketedPaste)(paste)
    bindings.add(Keys.ControlC)(stop)
    bindings.add(Keys.ControlD)(leave)
    return bindings
