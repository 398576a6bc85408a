"""One self-contained HTML page about one program."""

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience, for_student, needs_review
from vrts.report.because import told_to
from vrts.report.first_screen import first_screen
from vrts.report.ordering import in_order
from vrts.report.page.buttons import watch_button
from vrts.report.page.checks import checks_section, facts_section, review_section
from vrts.report.page.contacts import contacts_section
from vrts.report.page.document import document_parts
from vrts.report.page.findings import MOST_FINDINGS, findings_section
from vrts.report.page.future_cards import futures_section
from vrts.report.page.html import Markup, element, json_text, raw, written_script
from vrts.report.page.listing import listing
from vrts.report.page.replay_data import contact_rows, near_rows, run_data
from vrts.report.page.stills import MOMENT
from vrts.report.page.top import first_screen_section
from vrts.report.page.viewer_data import scene_data, scene_text
from vrts.report.plain import one_line
from vrts.report.quantities import millimetres, seconds
from vrts.report.voices.rows import Voice, voice_rows
from vrts.web.assets import asset, packed

ENTRY = "report/page.js"

NOT_MODELLED = """
Motion is computed from geometry alone: no masses, forces, friction or motor limits other than \
joint positions and speeds.
The arm follows its planned motion exactly; the small errors of the real servos are not there.
Contacts never push, bend or stop anything: after a contact the run goes on as planned. The real \
robot would not.
A released object sinks straight down and stands or topples; it does not bounce, slip or roll.
"""


class Part(NamedTuple):
    """A section of the page, and how it is called in the list of all."""

    identifier: str  # of its element
    name: str
    section: Markup | None  # None: nothing to show


def page(
    a: Assessment,
    stills: Mapping[str, bytes],
    *,
    audience: Audience = Audience.STUDENT,
    more: int = 0,
    hidden: Collection[str] = (),
    scripts: Sequence[Markup] | None = None,
    voices: Sequence[Voice] = (),
) -> str:
    """Return the page; `page_parts` tells what it is made of."""
    return "".join(
        page_parts(
            *(a, stills),
            audience=audience,
            more=more,
            hidden=hidden,
            scripts=scripts,
            voices=voices,
        )
    )


def page_parts(
    a: Assessment,
    stills: Mapping[str, bytes],
    *,
    audience: Audience = Audience.STUDENT,
    more: int = 0,
    hidden: Collection[str] = (),
    scripts: Sequence[Markup] | None = None,
    voices: Sequence[Voice] = (),
) -> list[str]:
    """Return the page in parts that follow one another: the long ones are never put together.

    Args:
        a: What was found. For a student it has to come from public checks alone.
        stills: PNG pictures by name, as `page_stills` makes them; "moment" is shown on the first
            screen (the cause's moment, else the end of the run).
        audience: Who reads it: a student's page leaves out what `for_student` takes away.
        more: How many further checks there will be at marking.
        hidden: Names of the checks that students do not see, to be marked so.
        scripts: What `replay_scripts` makes of the assessment, if that is there already.
        voices: What people said and did meanwhile.
    """
    grader = audience is Audience.GRADER
    review = needs_review(a)
    if not grader:
        a = for_student(a)
    screen = first_screen(a)
    findings = in_order(a.findings)
    replayable = a.run is not None and a.scene is not None
    parts = [
        Part("replay", "Replay", replay_section(a, findings) if replayable else None),
        Part("program", "Program", None if replayable else _program(a, findings)),
        Part("review", "To be reviewed", review_section(a) if grader else None),
        Part("contacts", "Contacts", contacts_section(a, stills) if replayable else None),
        Part("findings", f"Findings ({len(findings)})", findings_section(findings)),
        Part("checks", "Checks", checks_section(a, hidden if grader else ())),
        Part("futures", "Every future", None if a.proof is None else futures_section(a.proof)),
        Part("charts", "Charts", charts_section(a) if replayable else None),
        Part("facts", "Facts", facts_section(a) if grader else None),
        Part("model", "What was not modelled", _not_modelled(a)),
    ]
    body = [
        first_screen_section(
            a, screen, stills.get(MOMENT), review=review, more=more, level=told_to(a, audience)
        ),
        _navigation(parts),
        *(part.section for part in parts),
        element("footer", element("p", "Written by vrts")),
    ]
    moving = replay_scripts(a, voices) if scripts is None else scripts
    return document_parts(one_line(a.title), "report/page.css", body, *moving)


# --- replay and program -------------------------------------------------------------------------


def _navigation(parts: Sequence[Part]) -> Markup:
    links = [element("a", part.name, href=f"#{part.identifier}") for part in parts if part.section]
    return element("nav", *links, aria_label="On this page")


def replay_section(
    a: Assessment, findings: Sequence[Diagnostic], which: Markup | None = None
) -> Markup:
    """Return the replay beside the program; `which` says what is shown, where that may change."""
    program = listing(a.source, findings[:MOST_FINDINGS]) if a.source else None
    return element(
        "section",
        element("h2", "Replay and program", which),
        Markup(asset("report/replay.html")),
        element("div", program, class_="program"),
        Markup(asset("report/events.html")),
        id="replay",
        class_="replay",
    )


def _program(a: Assessment, findings: Sequence[Diagnostic]) -> Markup | None:
    if a.source is None:
        return None
    return element(
        "section",
        element("h2", "Program"),
        listing(a.source, findings[:MOST_FINDINGS]),
        id="program",
    )


def replay_scripts(a: Assessment, voices: Sequence[Voice] = ()) -> list[Markup]:
    """Return the data of the replay and the modules that show it, the same for all readers."""
    if a.run is None or a.scene is None:
        return []
    screen = first_screen(a)
    data = _of_run(a, screen.moment.time_s if screen.moment else None)
    if voices:
        data["voices"] = voice_rows(voices)
    written = {key: json_text(value) for key, value in data.items()}
    return [
        written_script("data", {"scene": scene_text(a.scene, a.task), **written}),
        *modules(),
    ]


def replay_data(a: Assessment) -> dict[str, object]:
    """Return the data of the replay of an assessment in which something ran."""
    screen = first_screen(a)
    return recording(a, screen.moment.time_s if screen.moment else None)


def recording(a: Assessment, moment_s: float | None) -> dict[str, object]:
    """Return the same, with the time [s] at which a reader begins; None: at the beginning."""
    assert a.scene is not None
    return {"scene": scene_data(a.scene, a.task), **_of_run(a, moment_s)}


def _of_run(a: Assessment, moment_s: float | None) -> dict[str, object]:
    """Return the same without the scene."""
    assert a.run is not None
    report = a.judgement.collisions if a.judgement else None
    return {
        "run": run_data(a.run, a.source),
        "contacts": contact_rows(report.contacts, a.source) if report else [],
        "grazes": contact_rows(report.grazes, a.source) if report else [],
        "doubtful": contact_rows(report.undetermined, a.source) if report else [],
        "near": near_rows(report.near_misses, a.source) if report else [],
        "moment": moment_s,
        "clearance": [[seconds(t), millimetres(distance)] for t, distance in a.clearance],
    }


@cache
def modules() -> tuple[Markup, ...]:
    """Return the modules that show a replay, and what unpacks them."""
    return (
        raw("script", packed(ENTRY), type="application/octet-stream", id="modules"),
        raw("script", asset("report/unpack.js")),
    )


# --- below --------------------------------------------------------------------------------------


def charts_section(a: Assessment) -> Markup:
    """Return the place for the charts, and the smallest clearance, if it is known."""
    return element(
        "section",
        element("h2", "Charts"),
        _clearance(a),
        element("div", id="chart-list"),
        element("noscript", element("p", "The charts need JavaScript.")),
        id="charts",
    )


def _clearance(a: Assessment) -> Markup | None:
    report = a.judgement.collisions if a.judgement else None
    if report is None or report.clearance is None:
        return None
    nearest = report.clearance
    first, second = (one_line(body) for body in nearest.bodies)
    return element(
        "p",
        "Smallest clearance: ",
        element("b", f"{millimetres(nearest.distance_m):.1f} mm"),
        f" between {first} and {second} ",
        watch_button(nearest.time_s),
    )


def _not_modelled(a: Assessment) -> Markup:
    items = [element("li", text) for text in NOT_MODELLED.strip().split("\n")]
    return element(
        "section",
        element("h2", "What was not modelled"),
        element("ul", *items),
        _method(a),
        id="model",
        class_="box",
    )


def _method(a: Assessment) -> Markup | None:
    report = a.judgement.collisions if a.judgement else None
    if report is None:
        return element("p", "Collisions were not checked.")
    if report.certified:
        return element(
            "p", "The collision check covers every instant of the run, not only sampled ones."
        )
    return element("p", "Some instants of the collision check stayed undetermined; see the checks.")
