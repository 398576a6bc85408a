"""One self-contained HTML page about one program."""

from collections.abc import Mapping, Sequence

from vrts.base.diagnostic import Diagnostic
from vrts.report.assessment import Assessment
from vrts.report.document import document
from vrts.report.excerpt import excerpt
from vrts.report.first_screen import first_screen
from vrts.report.html import (
    Markup,
    MarkupPalette,
    element,
    joined,
    json_script,
    painted,
    prose,
    raw,
)
from vrts.report.listing import listing
from vrts.report.page_top import first_screen_section, watch_button
from vrts.report.plain import capital, one_line
from vrts.report.quantities import millimetres, seconds
from vrts.report.replay_data import contact_rows, run_data
from vrts.report.text import in_order, moment_text
from vrts.report.viewer_data import scene_data
from vrts.web.assets import asset, import_map, module_name

MOST_FINDINGS = 100

ENTRY = "report/page.js"
MOMENT = "moment"

NOT_MODELLED = """
Motion is computed from geometry alone: no masses, forces, friction or motor limits other than \
joint positions and speeds.
The arm follows its planned motion exactly; the small errors of the real servos are not there.
Contacts never push, bend or stop anything: after a contact the run goes on as planned, the real \
robot would not.
A released object sinks straight down and stands or topples; it does not bounce, slip or roll.
"""


def page(a: Assessment, stills: Mapping[str, bytes]) -> str:
    """Return the page.

    Args:
        a: What was found.
        stills: PNG pictures by name; "moment" is shown on the first screen (the cause's moment,
            else the end of the run). Others are not used.
    """
    screen = first_screen(a)
    findings = in_order(a.findings)
    replayable = a.run is not None and a.scene is not None
    body = [
        first_screen_section(a, screen, stills.get(MOMENT)),
        _navigation(a, findings, replayable=replayable),
        _replay(a, findings) if replayable else _program(a, findings),
        _findings(findings),
        _checks(a),
        _charts(a) if replayable else None,
        _not_modelled(a) if replayable else None,
        _footer(a),
    ]
    scripts = _scripts(a) if replayable else []
    return document(one_line(a.title), "report/page.css", body, scripts)


# --- replay and program -------------------------------------------------------------------------


def _navigation(a: Assessment, findings: Sequence[Diagnostic], *, replayable: bool) -> Markup:
    entries = [("replay", "Replay") if replayable else ("program", "Program")]
    entries += [("findings", f"Findings ({len(findings)})")] if findings else []
    entries += [("checks", "Checks")] if a.judgement and a.grade else []
    entries += [("charts", "Charts"), ("model", "What was not modelled")] if replayable else []
    links = [element("a", text, href=f"#{target}") for target, text in entries]
    return element("nav", *links, aria_label="On this page")


def _replay(a: Assessment, findings: Sequence[Diagnostic]) -> Markup:
    program = listing(a.source, findings[:MOST_FINDINGS]) if a.source else None
    return element(
        "section",
        element("h2", "Replay and program"),
        Markup(asset("report/replay.html")),
        element("div", program, class_="program"),
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


def _scripts(a: Assessment) -> list[Markup]:
    assert a.run is not None
    assert a.scene is not None
    report = a.judgement.collisions if a.judgement else None
    screen = first_screen(a)
    data: dict[str, object] = {
        "scene": scene_data(a.scene, a.task),
        "run": run_data(a.run, a.source),
        "contacts": contact_rows(report.contacts, a.source) if report else [],
        "grazes": contact_rows(report.grazes, a.source) if report else [],
        "moment": screen.moment.time_s if screen.moment else None,
        "clearance": [[seconds(t), millimetres(distance)] for t, distance in a.clearance],
    }
    entry = f'import "{module_name(ENTRY)}";'
    return [
        json_script("data", data),
        raw("script", import_map(ENTRY), type="importmap"),
        raw("script", entry, type="module"),
    ]


# --- below --------------------------------------------------------------------------------------


def _findings(findings: Sequence[Diagnostic]) -> Markup | None:
    if not findings:
        return None
    cards = [_finding(number, d) for number, d in enumerate(findings[:MOST_FINDINGS], start=1)]
    more = len(findings) - len(cards)
    rest = element("p", f"{more} more findings are not listed.") if more else None
    return element("section", element("h2", "Findings"), *cards, rest, id="findings")


def _finding(number: int, d: Diagnostic) -> Markup:
    rows = excerpt(d, MarkupPalette())
    text = (
        element("pre", painted("\n".join(rows)), class_="excerpt", tabindex="0") if rows else None
    )
    moment = (
        element(
            "p", watch_button(d.moment.time_s), " ", capital(moment_text(d.moment)), class_="when"
        )
        if d.moment
        else None
    )
    head = element(
        "h3",
        element("span", d.severity.value, class_="severity"),
        " ",
        element("code", f"{d.rule.code} {d.rule.slug}", class_="rule"),
        " ",
        prose(one_line(d.headline)),
    )
    notes = [element("p", element("b", "Note: "), prose(note), class_="lines") for note in d.notes]
    helps = [element("p", element("b", "Help: "), prose(text), class_="lines") for text in d.help]
    return element(
        "article",
        *(head, text if rows else None, moment, *notes, *helps),
        class_=f"finding {d.severity.value}",
        id=f"finding-{number}",
    )


def _checks(a: Assessment) -> Markup | None:
    if a.judgement is None or a.grade is None:
        return None
    rows = [
        element(
            "tr",
            element("td", one_line(v.check)),
            element("td", v.answer.value, class_=f"answer-{v.answer.value}"),
            element("td", prose(one_line(v.summary))),
        )
        for v in a.judgement.verdicts
    ]
    head = element("tr", *(element("th", t, scope="col") for t in ("Check", "Answer", "")))
    obstacles = [element("li", prose(one_line(o))) for o in a.grade.obstacles]
    why = (
        joined([element("h3", "Why it is not ready for the real robot"), element("ul", *obstacles)])
        if obstacles
        else None
    )
    table = element("table", element("thead", head), element("tbody", *rows), class_="checks")
    return element("section", element("h2", "Checks"), table, why, id="checks")


def _charts(a: Assessment) -> Markup:
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


def _footer(a: Assessment) -> Markup:
    digests = [("scene", a.scene.digest if a.scene else None)]
    digests += [("task", a.task.digest if a.task else None)]
    parts = [f"{name} {digest[:12]}" for name, digest in digests if digest]
    return element("footer", element("p", " · ".join(["Written by vrts", *parts])))
