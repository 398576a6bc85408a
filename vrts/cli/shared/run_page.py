"""A run that is there already, as a page with a replay."""

import os
import webbrowser
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import WRONG, fail, write_file

if TYPE_CHECKING:
    from vrts.base.source import SourceFile
    from vrts.engine.run import Run
    from vrts.report.assessment import Assessment
    from vrts.report.voices.rows import Voice

AGAIN = "`--no-open` writes it for another machine"


def assessed(
    identifier: str, title: str, run: "Run", source: "SourceFile | None" = None
) -> "Assessment":
    """Return what is known of a run, checked again without its task.

    Args:
        identifier: Short name, for files.
        title: Above the page.
        run: What is to be seen.
        source: The program to be shown; None: the one that was executed first.
    """
    from vrts.check.judge import judge
    from vrts.pipeline.curve import with_curve
    from vrts.report.assessment import Assessment

    main = run.module.main
    if source is None and main is not None:
        source = run.module.programs[main].span.source
    found = Assessment(
        identifier,
        title,
        source,
        (),
        module=run.module,
        scene=run.scene,
        run=run,
        judgement=judge(run.scene, run, None),
    )
    return with_curve(found)


def write_page(
    found: "Assessment", path: Path, voices: "Sequence[Voice]" = (), *, more: int = 0
) -> None:
    """Write the page, with what people said meanwhile and how many checks are still to come."""
    from vrts.report.page.page import page
    from vrts.report.page.stills import page_stills

    write_file(path, page(found, page_stills(found), more=more, voices=voices).encode())


def open_page(path: Path, time_s: float | None = None) -> None:
    """Open a page in the browser, at a time [s] of its replay if one is given."""
    if not webbrowser.open(_address(path, time_s)):
        fail("no browser was found here", (AGAIN,), status=WRONG)


def opens_in_window(path: Path, time_s: float) -> bool:
    """Open a page in a browser at a time [s]; return whether there is one with a window.

    A browser that draws in the terminal is none: something else fills the terminal already.
    """
    try:
        browser = webbrowser.get()
    except webbrowser.Error:
        return False
    in_terminal = type(browser) is webbrowser.GenericBrowser and "BROWSER" not in os.environ
    return not in_terminal and browser.open(_address(path, time_s))


def _address(path: Path, time_s: float | None) -> str:
    from vrts.debug.marks.links import anchor

    return path.resolve().as_uri() + ("" if time_s is None else anchor(time_s))
