"""The top of a page, its replay and its charts, in a frame that stands in a notebook."""

from vrts.report.assessment import Assessment
from vrts.report.audience import Audience, for_student
from vrts.report.because import told_to
from vrts.report.first_screen import first_screen
from vrts.report.ordering import in_order
from vrts.report.page.document import document
from vrts.report.page.html import Markup, element, raw
from vrts.report.page.page import charts_section, replay_scripts, replay_section
from vrts.report.page.stills import MOMENT, page_stills
from vrts.report.page.top import first_screen_section
from vrts.report.plain import one_line
from vrts.web.assets import asset

HEIGHT_PX = 760  # of the frame: the top, and the beginning of the replay


def top_and_replay(a: Assessment) -> str:
    """Return a whole document with the first screen of an assessment, its replay and charts."""
    a = for_student(a)
    screen = first_screen(a)
    level = told_to(a, Audience.STUDENT)
    body = [first_screen_section(a, screen, page_stills(a).get(MOMENT), level=level)]
    if a.run is not None and a.scene is not None:
        body += [replay_section(a, in_order(a.findings)), charts_section(a)]
    scripts = [raw("script", asset("report/framed.js")), *replay_scripts(a)]
    return document(one_line(a.title), "report/page.css", body, scripts)


def framed(whole: str) -> Markup:
    """Return a document in a frame of its own: nothing in it reaches the notebook round it."""
    return element(
        "iframe",
        srcdoc=whole,
        sandbox="allow-scripts",
        title="What was found, and the replay",
        style=f"width:100%;height:{HEIGHT_PX}px;border:0",
    )
