"""Pages of a live server: an operator's and viewers', each a browser context of its own."""

from dataclasses import dataclass, field
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Page

from tests.support_live import LiveServer

PATIENCE = 20.0  # [s]
# before anybody has entered, GET /me says so
EXPECTED = "the server responded with a status of 401"


@dataclass
class Desk:
    """Somebody's page."""

    page: Page
    context: BrowserContext
    messages: list[str] = field(default_factory=list[str])
    requests: list[str] = field(default_factory=list[str])

    def complaints(self) -> list[str]:
        """Return what the browser found fault with."""
        ignored = (EXPECTED, "GPU stall due to ReadPixels")
        return [m for m in self.messages if not any(words in m for words in ignored)]

    def until(self, condition: str, patience: float = PATIENCE) -> None:
        """Wait for a condition; Playwright's own waiting needs `eval`, which the page forbids."""
        for _ in range(int(patience / 0.05)):
            if self.page.evaluate(condition):
                return
            self.page.wait_for_timeout(50)
        shown = self.page.evaluate("document.getElementById('toasts').textContent")
        raise AssertionError(f"never true: {condition}; notices: {shown}; {self.messages[-3:]}")

    def type(self, line: str) -> None:
        """Enter a line at the monitor."""
        self.page.fill("#terminal-line", line)
        self.page.press("#terminal-line", "Enter")

    def joint(self, number: int) -> float:
        """Return a joint as it is shown [degrees]."""
        text: str = self.page.inner_text(f".f-j{number} dd")
        return float(text.replace("−", "-"))

    def value(self, expression: str) -> Any:
        """Evaluate an expression of the page."""
        return self.page.evaluate(expression)


def desk(
    browser: Browser, server: LiveServer, path: str = "/", *, width: int = 1000, dark: bool = False
) -> Desk:
    """Open the page in a context of its own."""
    context = browser.new_context(
        viewport={"width": width, "height": 844 if width < 500 else 640},
        color_scheme="dark" if dark else "light",
        reduced_motion="reduce",
    )
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
