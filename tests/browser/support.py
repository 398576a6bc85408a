"""Chromium for tests: pages that note what they say and ask for."""

import time
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

CHROMIUM = "/usr/bin/chromium"
PATIENCE = 60.0  # [s]; the machine may be busy
FLAGS = [
    "--headless=new",
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
]
# a GPU in software puts a page together ten times as slowly as the processor; canvases draw by it
NO_GPU = "--disable-gpu-compositing"
# pixels of a picture cost much where no GPU helps
DOTS = 0.25  # pixels to a dot of the page, each way
# and so do frames of an animation: ten in a second are enough
FRAMES = "window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 100);"
# who does not look at the picture needs none: everything is made ready, and nothing drawn
UNDRAWN = """for (const name of ["drawArrays", "drawElements"]) {
  WebGL2RenderingContext.prototype[name] = () => {};
}"""
PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010806000000"
    "1f15c4890000000d49444154789c63606060f80f0001040100"
    "5fe5c34b0000000049454e44ae426082"
)


@contextmanager
def chromium(*, measured: bool = False) -> Generator[Browser]:
    """Give a Chromium; skip what needs it where it is not installed.

    One that is `measured` puts its pages together by the GPU, as those of users do.
    """
    if not Path(CHROMIUM).exists():
        pytest.skip("needs Chromium")
    with sync_playwright() as playwright:
        flags = FLAGS if measured else [*FLAGS, NO_GPU]
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=flags)
        yield opened
        opened.close()


@dataclass
class Opened:
    """A page and what it said and asked for."""

    page: Page
    messages: list[str] = field(default_factory=list[str])
    requests: list[str] = field(default_factory=list[str])
    first_clock: float = -1.0  # what it showed when it opened [s]

    def complaints(self) -> list[str]:
        """Return what the page said, but for the remarks of software rendering."""
        return [m for m in self.messages if "GPU stall due to ReadPixels" not in m]


def opened(
    browser: Browser,
    path: Path,
    width: int = 1280,
    *,
    dark: bool = False,
    still: bool = False,
    drawn: bool = False,
    before: str = "",
) -> Opened:
    """Open a file; `still` asks for reduced motion, `drawn` for a picture that can be looked at.

    What stands in `before` is executed before the page's own scripts.
    """
    view = Opened(
        browser.new_page(
            viewport={"width": width, "height": 900},
            color_scheme="dark" if dark else "light",
            reduced_motion="reduce" if still else "no-preference",
            device_scale_factor=DOTS,
        )
    )
    view.page.on("console", lambda m: view.messages.append(f"{m.type}: {m.text}"))
    view.page.on("pageerror", lambda e: view.messages.append(f"exception: {e}"))
    view.page.on("request", lambda r: view.requests.append(r.url[:200]))
    view.page.add_init_script(FRAMES)
    if not drawn:
        view.page.add_init_script(UNDRAWN)
    view.page.add_init_script(before)
    view.page.goto(path.as_uri())
    return view


def until(view: Opened, condition: str) -> None:
    """Wait for a condition; Playwright's own waiting needs `eval`, which the page forbids."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if view.page.evaluate(condition):
            return
        view.page.wait_for_timeout(50)
    pytest.fail(f"never true: {condition}")


def clock(view: Opened) -> float:
    """Return the time that the replay shows [s]."""
    return float(view.page.inner_text("#clock").split("/")[0])
