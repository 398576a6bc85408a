"""What the debugger at the terminal has others do: pictures in 3D, and reading files anew."""

import signal
import sys
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import sentence_of
from vrts.cli.shared.rerun_window import RerunWindow
from vrts.cli.shared.run_page import assessed, opens_in_window, write_page

if TYPE_CHECKING:
    from vrts.debug.opening import Asked, Opened
    from vrts.debug.scripted.recording import Recorder
    from vrts.debug.terminal.keys import Outside
    from vrts.engine.run import Run
    from vrts.report.assessment import Assessment

NO_WINDOWS = "no browser with a window was found here"


class DebugOutside:
    """Pictures go into one folder, which stays for the browser; the Rerun viewer ends with this."""

    def __init__(self, asked: "Asked", opened: "Opened") -> None:
        """Take what was asked for, and what was opened for it."""
        self._asked = asked
        self._opened = opened
        self._files = opened.files
        self._window = RerunWindow()
        self._recorded: Run | None = None  # what the viewer shows
        self._folder: Path | None = None

    def __enter__(self) -> "DebugOutside":
        """Start nothing yet; a terminal that is closed shall end the viewer as well."""
        for name in ("SIGHUP", "SIGTERM"):
            if hasattr(signal, name):
                signal.signal(getattr(signal, name), _leave)
        return self

    def __exit__(self, *_: object) -> None:
        """End the viewer."""
        self._window.close()

    def keys(self) -> "Outside":
        """Return what the keys call."""
        from vrts.debug.terminal.keys import Outside

        return Outside(self._page, self._rerun, lambda: self._files.news())

    def _page(self, time_s: float) -> str:
        """Write the replay of the run as it goes now, and open it at a time [s]."""
        found = self._assessed()
        try:
            path = self._path(f"{found.identifier}.html")
            write_page(found, path)
            opens = opens_in_window(path, time_s)
        except OSError as problem:
            return f"cannot show it: {sentence_of(problem)}"
        where = f"{path} at {time_s:.3f} s"
        return where if opens else f"{NO_WINDOWS}: it is in {where}"

    def _rerun(self, time_s: float) -> str:
        """Let the Rerun viewer show the run as it goes now, at a time [s]."""
        try:
            from vrts.report.recording import write_recording
        except ImportError:
            return "the Rerun viewer is not installed here"
        assert self._opened.debugger is not None
        run = self._opened.debugger.run
        try:
            if run is self._recorded and self._window.is_open and self._window.stand_at(time_s):
                return f"the Rerun viewer stands at {time_s:.3f} s"
            found = self._assessed()
            path = self._path(f"{found.identifier}.rrd")
            write_recording(found, path)
            if not self._window.show(path, time_s):
                return f"the Rerun viewer could not show {path}; it needs a display"
        except OSError as problem:
            return f"cannot show it: {sentence_of(problem)}"
        self._recorded = run
        return f"{path} at {time_s:.3f} s"

    def restart(self) -> str:
        """Begin again, with the files as they are now if they have changed."""
        from vrts.debug.opening import opened, why_not
        from vrts.debug.opening_saved import opened_run
        from vrts.engine.storage.recognise import is_saved_run
        from vrts.pipeline.files import CannotRead, read_bytes
        from vrts.pipeline.refused import Refused

        debugger, console = self._opened.debugger, self._opened.console
        assert debugger is not None
        assert console is not None
        if not self._files.stale:
            debugger.restart()
            return ""
        try:
            if is_saved_run(read_bytes(self._asked.program)):
                again = opened_run(self._asked.program)
            else:
                again = opened(self._asked)
        except CannotRead as problem:
            return f"still as it was: {problem}"
        except Refused as refused:
            return f"still as it was: {why_not(refused.diagnostics)}"
        except OSError as problem:
            return f"still as it was: {sentence_of(problem)}"
        if again.debugger is None or again.console is None:
            return f"still as it was: {why_not(again.diagnostics)}"
        debugger.take_over(again.debugger)
        console.take_over(again.console)
        self._files = again.files
        return "begun again with the files as they are now"

    def _assessed(self) -> "Assessment":
        assert self._opened.debugger is not None
        name = Path(self._opened.sources[0].name)
        return assessed(name.stem, name.name, self._opened.debugger.run)

    def _path(self, name: str) -> Path:
        if self._folder is None or not self._folder.is_dir():
            self._folder = Path(tempfile.mkdtemp(prefix="vrts-"))
        return self._folder / name


def _leave(number: int, _: object) -> None:
    sys.exit(128 + number)


@contextmanager
def recorder(file: Path | None) -> "Generator[Recorder]":
    """Give what keeps the commands of a session in a file, as they come; None: nothing does."""
    from vrts.debug.scripted.recording import Recorder

    if file is None:
        yield Recorder(None)
        return
    with file.open("w", encoding="utf-8", buffering=1) as opened:
        opened.write("# a session of vrts debug; `vrts debug PROGRAM --commands FILE` repeats it\n")

        def write(line: str) -> None:
            opened.write(f"{line}\n")
            opened.flush()

        yield Recorder(write, str(file))
