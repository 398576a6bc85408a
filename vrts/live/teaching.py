"""Teaching alone: the server with one room for one user, and a file of what is recorded."""

import contextlib
import tempfile
import webbrowser
from collections.abc import Callable
from pathlib import Path

from vrts.live.places import places_of
from vrts.live.points import PointsFile
from vrts.live.serving import Listening, serve
from vrts.live.settings import Settings

ROOM = "Teaching"


def teach(
    scene: str,
    output: Path,
    port: int,
    say: Callable[[str], None],
    warn: Callable[[str], None],
    *,
    lab: Path | None = None,
    opens: bool,
) -> int:
    """Serve one user on this machine until interrupted; return how many locations the file has.

    Nothing but the file of locations is left behind.

    Args:
        scene: Name or path of a scene, or of a task.
        output: The file of locations; replaced when the first one is recorded.
        port: 0: any that is free.
        say: Writes a line that is good to know.
        warn: Writes a line that has to be known.
        lab: File of a lab that is laid over the scene.
        opens: Whether a browser is opened.

    Raises:
        CannotRead: There is no such scene or lab, or the port cannot be had.
    """
    points = PointsFile(output)

    def recorded(row: str) -> None:
        try:
            points.add(row)
        except OSError as problem:
            warn(f"cannot write `{output}`: {problem.strerror or 'failed'}")

    def open_link(link: str) -> None:
        (say if opens else warn)(f"teaching in {scene}, on this machine only: {link}")
        say(f"what is recorded goes into {output}; Ctrl-C ends it")
        if opens and not webbrowser.open(link):
            warn(f"no browser was found here: open {link} in one")

    with tempfile.TemporaryDirectory(prefix="vrts-teach-") as folder:
        settings = Settings(
            Path(folder),
            places_of((scene,), lab),
            alone=True,
            students_reset=True,
            idle_s=0.0,
            recorded=recorded,
        )
        listening = Listening(port=port)
        with contextlib.suppress(KeyboardInterrupt):  # how it ends
            serve(settings, listening, (ROOM,), _say_nothing, with_code=False, open_link=open_link)
    return len(points)


def _say_nothing(line: str) -> None:
    """Leave the words of a shared server away."""
