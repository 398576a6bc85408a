"""A real terminal: what tmux shows of a program, and keys typed."""

import subprocess
import sys
import time
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path

PATIENCE = 60.0  # [s] on a busy machine
TURN = 0.1  # [s]


class Terminal:
    """A command of vrts that fills a terminal; each has a server of its own, which ends with it."""

    def __init__(
        self,
        arguments: Sequence[str],
        folder: Path,
        size: tuple[int, int],
        environment: Mapping[str, str] | None = None,
    ) -> None:
        self._name = f"vrts-{uuid.uuid4().hex[:8]}"
        self._said = folder / "stderr.txt"
        command = [sys.executable, "-m", "vrts.cli.main", *arguments]
        words = " ".join(f"'{word}'" for word in command)
        told = [f"{name}={value}" for name, value in (environment or {}).items()]
        self._tmux(
            "new-session",
            "-d",
            "-s",
            self._name,
            "-x",
            str(size[0]),
            "-y",
            str(size[1]),
            *(word for one in told for word in ("-e", one)),
            f"{words} 2>'{self._said}'",
        )

    def __enter__(self) -> "Terminal":
        return self

    def __exit__(self, *_: object) -> None:
        self._tmux("kill-server", check=False)

    def send(self, *keys: str) -> None:
        """Type keys, by the names that tmux has for them."""
        self._tmux("send-keys", "-t", self._name, *keys)

    def resize(self, columns: int, rows: int) -> None:
        """Give the terminal another size."""
        self._tmux("resize-window", "-t", self._name, "-x", str(columns), "-y", str(rows))

    def screen(self) -> str:
        """Return what is shown."""
        return self._tmux("capture-pane", "-p", "-t", self._name)

    def expect(self, *texts: str) -> str:
        """Wait until all texts are shown at once; return the screen."""
        until = time.monotonic() + PATIENCE
        shown = self.screen()
        while not all(text in shown for text in texts):
            assert time.monotonic() < until, f"no {texts} in\n{shown}"
            time.sleep(TURN)
            shown = self.screen()
        return shown

    def said(self) -> str:
        """Wait for the end; return what the command wrote to stderr."""
        until = time.monotonic() + PATIENCE
        while self._name in self._tmux("list-sessions", "-F", "#{session_name}", check=False):
            assert time.monotonic() < until, self.screen()
            time.sleep(TURN)
        return self._said.read_text()

    def _tmux(self, *words: str, check: bool = True) -> str:
        found = subprocess.run(
            ["tmux", "-L", self._name, *words], capture_output=True, text=True, check=False
        )
        assert found.returncode == 0 or not check, found.stderr
        return found.stdout
