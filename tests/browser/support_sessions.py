"""Pages of a live server: an operator's and viewers', each a browser context of its own."""

import json
import time
from dataclasses import dataclass, field
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Error, Page

from tests.browser.support import DOTS, FRAMES, PATIENCE, UNDRAWN
from tests.support_live import LiveServer

# before anybody has entered, GET /me says so
EXPECTED = "the server responded with a status of 401"

SHOWN_AFTER_S = 0.3  # of session time: more than a state waits before it is told


@dataclass
class Desk:
    """Somebody's page."""

    page: Page
    context: BrowserContext
    messages: list[str] = field(default_factory=list[str])
    requests: list[str] = field(default_factory=list[str])

    def complaints(self) -> list[str]:
        """Return what the browser found fault with."""
        ignored = (EXPECTED, "GPU stall due to ReadPixels", "ERR_INTERNET_DISCONNECTED")
        return [m for m in self.messages if not any(words in m for words in ignored)]

    def until(self, condition: str, patience: float = PATIENCE) -> None:
        """Wait for a condition; Playwright's own waiting needs `eval`, which the page forbids."""
        until = time.monotonic() + patience
        while time.monotonic() < until:
            if self._holds(condition):
                return
            self.page.wait_for_timeout(50)
        shown = self.page.evaluate("document.getElementById('toasts').textContent")
        raise AssertionError(f"never true: {condition}; notices: {shown}; {self.messages[-3:]}")

    def _holds(self, condition: str) -> bool:
        try:
            return bool(self.page.evaluate(condition))
        except Error as fault:
            if "Execution context was destroyed" not in str(fault):
                raise
            return False  # another page is on its way

    def type(self, line: str) -> None:
        """Enter a line at the monitor."""
        self.page.fill("#terminal-line", line)
        self.page.press("#terminal-line", "Enter")

    def ask(self, line: str) -> None:
        """Enter a line at the monitor, and wait until it has been carried out.

        What it sets going shows a little after it: the session is ready again when it still says so
        then, by its own time.
        """
        self.until(READY)
        shown = self.value("vrts.store.now.output.length")
        self.type(line)
        self.until(f"vrts.store.now.output.slice({shown}).includes({json.dumps(line)})")
        told = float(self.value("vrts.world.state.t"))
        self.until(f"vrts.world.state.t > {told + SHOWN_AFTER_S} && {READY}")

    def press_twice(self, key: str) -> None:
        """Press a key twice, a tenth of a second apart however long the machine takes."""
        keyboard, now = self.context.new_cdp_session(self.page), time.time()
        for pressed in (now, now + 0.1):
            what = {"key": key, "code": key, "timestamp": pressed}
            for kind in ("rawKeyDown", "keyUp"):
                keyboard.send("Input.dispatchKeyEvent", {"type": kind, **what})  # pyright: ignore[reportUnknownMemberType]
        keyboard.detach()

    def joint(self, number: int) -> float:
        """Return a joint as it is shown [degrees]."""
        text: str = self.page.inner_text(f".f-j{number} dd")
        return float(text.replace("−", "-"))

    def rests(self) -> bool:
        """Return whether the arm stands still for a while of session time."""
        state = "[vrts.world.state.t, ...vrts.world.state.q]"
        told = float(self.value("vrts.store.now.status.time_s"))
        self.until(f"vrts.world.state.t > {told}")  # what is shown is a little behind
        before: list[float] = self.value(state)
        self.until(f"vrts.world.state.t > {before[0] + 0.4}")
        after: list[float] = self.value(state)
        return after[1:] == before[1:]

    def value(self, expression: str) -> Any:
        """Evaluate an expression of the page."""
        return self.page.evaluate(expression)


def desk(
    browser: Browser,
    server: LiveServer,
    path: str = "/",
    *,
    width: int = 1000,
    dark: bool = False,
    drawn: bool = False,
) -> Desk:
    """Open the page in a context of its own; `drawn` for a picture that can be looked at."""
    context = browser.new_context(
        viewport={"width": width, "height": 844 if width < 500 else 640},
        color_scheme="dark" if dark else "light",
        reduced_motion="reduce",
        device_scale_factor=DOTS,
    )
    context.add_init_script(FRAMES)
    if not drawn:
        context.add_init_script(UNDRAWN)
    context.set_default_timeout(PATIENCE * 1000)
    opened = Desk(context.new_page(), context)
    opened.page.on("console", lambda m: opened.messages.append(f"{m.type}: {m.text}"))
    opened.page.on("pageerror", lambda e: opened.messages.append(f"exception: {e}"))
    opened.page.on("request", lambda r: opened.requests.append(r.url))
    opened.page.goto(f"http://{server.host}{path}")
    return opened


def supervisor(browser: Browser, server: LiveServer, **look: Any) -> Desk:
    """Enter by the supervisor's link."""
    opened = desk(browser, server, f"/#enter={server.supervisor_token}", **look)
    opened.until(SHOWN)
    return opened


def student(browser: Browser, server: LiveServer, name: str, **look: Any) -> Desk:
    """Enter by the class code, as students do."""
    opened = desk(browser, server, **look)
    opened.page.fill("#enter-code", server.code)
    opened.page.fill("#enter-name", name)
    opened.page.click("#enter-form button")
    opened.until(SHOWN)
    return opened


SHOWN = "Boolean(window.vrts?.world?.state)"
IDLE = "vrts.store.now.status.mode === 'idle'"
READY = "vrts.store.now.status.prompt === '.' && vrts.store.now.status.mode === 'idle'"
