"""`vrts grade desk` in a process, and pages of it."""

import re
import signal
from pathlib import Path
from types import TracebackType

from playwright.sync_api import Browser

from tests.browser.support import FRAMES, PATIENCE, UNDRAWN, Opened
from tests.support_commands import Begun
from tests.support_live import alone


class DeskServer:
    """The desk of somebody, on a free port."""

    def __init__(self, out: Path, who: str, *, measured: bool = False) -> None:
        """Begin; one that is `measured` has an interpreter of its own."""
        words = ("grade", "desk", str(out), "--who", who, "--no-browser")
        self.process = alone(*words) if measured else Begun(*words)
        assert self.process.stderr is not None
        self.said: list[str] = []
        for line in self.process.stderr:
            self.said.append(line)
            if "Ctrl-C ends it" in line:
                break
        found = re.search(r"http://\S+\?token=\S+", "".join(self.said))
        assert found is not None, self.said
        self.address = found[0]
        self.page = self.address.split("?")[0]

    def __enter__(self) -> "DeskServer":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.end()

    def end(self) -> None:
        """End it as Ctrl-C does."""
        if self.process.poll() is not None:
            return
        self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)
        assert self.process.stderr is not None
        faults = self.process.stderr.read()
        self.process.stderr.close()
        assert "Traceback" not in faults, faults


def at_desk(browser: Browser, server: DeskServer, width: int = 1366, height: int = 768) -> Opened:
    """Open the desk in a context of its own; it has shown the first program when this returns."""
    context = browser.new_context(
        viewport={"width": width, "height": height}, reduced_motion="reduce"
    )
    context.add_init_script(FRAMES)
    context.add_init_script(UNDRAWN)
    context.set_default_timeout(PATIENCE * 1000)
    view = Opened(context.new_page())
    view.page.on("console", lambda m: view.messages.append(f"{m.type}: {m.text}"))
    view.page.on("pageerror", lambda e: view.messages.append(f"exception: {e}"))
    view.page.goto(server.address)
    view.page.wait_for_selector("#list [aria-selected=true]", state="attached")
    view.page.wait_for_selector("#code li", state="attached")
    return view
