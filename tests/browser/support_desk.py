"""Pages of `vrts grade desk`."""

from playwright.sync_api import Browser

from tests.browser.support import FRAMES, PATIENCE, UNDRAWN, Opened
from tests.support_desk_server import DeskProcess


def at_desk(browser: Browser, server: DeskProcess, width: int = 1366, height: int = 768) -> Opened:
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
