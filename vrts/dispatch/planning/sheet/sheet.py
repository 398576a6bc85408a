"""The operator's sheet: one printed page to stand beside the robot with.

It says what has to be so before anything moves, what was proven and what only tried, and in which
order to begin. Everything on it stands in the bundle, too.
"""

from collections.abc import Iterator, Sequence
from importlib.resources import files
from typing import NamedTuple

from vrts.base.oat import components
from vrts.base.units import deg, mm
from vrts.dispatch.bundle import Bundle
from vrts.dispatch.manifest import Margin
from vrts.dispatch.planning.beside.dry_run import DryRun
from vrts.dispatch.planning.beside.margins import NOT_ASKED
from vrts.dispatch.planning.beside.stops import typed_after
from vrts.dispatch.planning.beside.trials import FIRST_SPEED
from vrts.dispatch.planning.reasons.nearness import SHOWN, Passage
from vrts.dispatch.planning.reasons.rounding import Difference
from vrts.dispatch.planning.sheet.floor_plan import floor_plan
from vrts.dispatch.planning.sheet.found import found_robot
from vrts.dispatch.planning.sheet.order import order
from vrts.dispatch.planning.sheet.places import Place, places
from vrts.dispatch.planning.sheet.story import changed, story
from vrts.dispatch.profile import Profile
from vrts.engine.run import Run
from vrts.report.page.html import Markup, element, joined, prose, raw
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scene

SHORT = 12  # characters of a hash
MOST_STEPS = 14  # lines about what it does
MOST_PASSAGES = 5
DENSE = 16  # bodies and lines of what it does: with more, the print is smaller
SIGNS = {"holds": ("✓", "ok"), "violated": ("✗", "bad"), "undetermined": ("?", "bad")}
SIGNED_ELSEWHERE = "Signature: vrts dispatch verify tells who has signed the bundle"
SKIN = "default-src 'none'; style-src 'unsafe-inline'"


class Sheet(NamedTuple):
    """What a sheet is made of."""

    bundle: Bundle
    content: str  # sha256 of what is sent
    profile: Profile
    scene: Scene
    run: Run  # of the first scenario
    raised: DryRun
    passages: tuple[Passage, ...]
    rounding: Difference


def sheet(facts: Sheet) -> str:
    """Return the page: HTML that needs nothing else."""
    manifest = facts.bundle.manifest
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", http_equiv="Content-Security-Policy", content=SKIN),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("title", f"{manifest.title}: operator's sheet"),
        raw(
            "style", files("vrts.dispatch.planning.sheet").joinpath("sheet.css").read_text("utf-8")
        ),
    )
    left = joined([*_story(facts), *_start(facts), *_futures(facts)])
    right = joined([*_verified(facts), *_margins(facts), *_passages(facts)])
    body = element(
        "body",
        _header(facts),
        _waivers(facts),
        element("div", element("div", left), element("div", right), class_="columns"),
        *found_robot(facts.scene.robot.arm),
        *_scene(facts),
        *_procedure(facts),
        element(
            "p",
            f"Nobody within reach of the arm. A hand on the stop until it has run through "
            f"once at SPEED {FIRST_SPEED:g}.",
            class_="stop",
        ),
        _signatures(),
        _footer(facts),
        class_="dense" if len(facts.scene.bodies) + len(story(facts.run)) > DENSE else None,
    )
    return f"<!doctype html>\n{element('html', head, body, lang='en')}\n"


# --- top ------------------------------------------------------------------------------------------


def _header(facts: Sheet) -> Markup:
    manifest = facts.bundle.manifest
    tried = "" if facts.profile.tried else ", a profile not tried on hardware"
    count = len(manifest.scenarios)
    proven = f"in {count} scenario{'' if count == 1 else 's'}"
    if manifest.futures and all(one.answer == "holds" for one in manifest.futures):
        proven = "in every future"
    waived = bool(manifest.waivers)
    badge = element(
        "p",
        "NOT ALL PROVEN" if waived else "VERIFIED",
        element("small", "see the waivers" if waived else proven),
        class_="badge waived" if waived else "badge",
    )
    task = f" · {manifest.task.title}" if manifest.task is not None else ""
    title = element(
        "div",
        element("p", "Operator's sheet", class_="kicker"),
        element("h1", f"{manifest.title}{task}"),
        element(
            "p",
            f"{manifest.robot.title} · {facts.profile.title}{tried} · sent ",
            element("code", facts.content[:SHORT]),
            class_="for",
        ),
        element("p", SIGNED_ELSEWHERE, class_="for"),
    )
    return element("header", title, badge)


def _waivers(facts: Sheet) -> Markup | None:
    found = facts.bundle.manifest.waivers
    if not found:
        return None
    lines = [
        element(
            "p",
            element("strong", f"{w.code}-{w.finding} waived by {w.who}: "),
            w.reason,
            element("br"),
            prose("; ".join(w.refused[:4]) + (" ..." if len(w.refused) > 4 else "")),
        )
        for w in found
    ]
    return element("section", element("h2", "Waived: not proven"), *lines, class_="waivers")


# --- left -----------------------------------------------------------------------------------------


def _story(facts: Sheet) -> Iterator[Markup]:
    told = story(facts.run)
    shown = told if len(told) <= MOST_STEPS else [*told[: MOST_STEPS - 1], "..."]
    yield element("h2", f"What it does (EXECUTE {facts.bundle.manifest.entry})")
    yield element("ol", *(element("li", prose(line)) for line in shown), class_="story")


def _start(facts: Sheet) -> Iterator[Markup]:
    run, arm = facts.run, facts.scene.robot.arm
    state = run.at(0.0)
    joints = "  ".join(f"{deg(q) + 0.0:.1f}" for q in state.configuration[:6])
    x, y, z, o, a, t = components(forward(arm, state.configuration) @ facts.scene.X_FT)
    ready = "READY" if state.configuration == arm.ready else "as the scenario has it"
    yield element("h2", "Start position")
    yield element(
        "dl",
        element("dt", ready),
        element("dd", element("code", f"JT {joints}")),
        element("dt", "WHERE"),
        element("dd", element("code", f"{x:.1f} {y:.1f} {z:.1f}  {o:.1f} {a:.1f} {t:.1f}")),
        element("dt", "hand"),
        element(
            "dd", "closed" if state.hand_opening <= 0.0 else f"{mm(state.hand_opening):.0f} mm"
        ),
    )
    yield floor_plan(facts.scene, run)


# --- right ----------------------------------------------------------------------------------------


def _futures(facts: Sheet) -> Iterator[Markup]:
    """Over what the proof speaks: what comes from outside has to keep to it."""
    for one in dict.fromkeys(facts.bundle.manifest.futures):
        yield element("h2", f"Every future: {one.answer}, {one.summary}")
        listed = (
            ("for every", one.quantified),
            ("within", one.bounded),
            ("tried only", one.sampled),
            ("granted", one.assumed),
        )
        parts = [(title, "; ".join(words)) for title, words in listed if words]
        yield element(
            "p",
            *(element("span", element("b", f"{title} "), f"{words}. ") for title, words in parts),
            class_="futures",
        )


def _verified(facts: Sheet) -> Iterator[Markup]:
    manifest = facts.bundle.manifest
    yield element("h2", "What was verified")
    rows_: list[Markup] = []
    for one in manifest.scenarios:
        took = one.duration_s or 0.0
        slow = took * 100.0 / FIRST_SPEED
        mark = "" if one.mark is None else f", mark {one.mark:g}"
        rows_.append(element("dt", "scenario"))
        rows_.append(element("dd", f"{one.scenario}: {one.ending}{mark}"))
        rows_.append(element("dt", "duration"))
        rows_.append(element("dd", f"{took:.1f} s at SPEED 100, {_long(slow)} at SPEED 10"))
        rows_.append(element("dt", "clearance"))
        rows_.append(element("dd", _clearance(facts, one.clearance_mm)))
        if one.proof is not None:
            rows_.append(element("dt", "proof"))
            rows_.append(element("dd", f"for every instant: {one.proof.summary}"))
    steps = sum(e.steps for e in manifest.executed)
    done = sum(e.executed for e in manifest.executed)
    moving = sum(e.motions for e in manifest.executed)
    moved = sum(e.motions_executed for e in manifest.executed)
    rows_ += [
        element("dt", "steps"),
        element("dd", f"{done} of {steps} executed, {moved} of {moving} that move"),
        element("dt", "reads"),
        element("dd", prose(_reads(facts))),
        element("dt", "rounding"),
        element(
            "dd",
            f"up to {facts.rounding.position_mm:.3f} mm, {facts.rounding.orientation_deg:.3f} deg "
            "as printed: verified so",
        ),
    ]
    yield element("dl", *rows_)


def _clearance(facts: Sheet, clearance_mm: float | None) -> str:
    """Return how near it comes: beside what it takes, and elsewhere."""
    if clearance_mm is None:
        return "nothing is near"
    asked = facts.bundle.manifest.clearance_asked_mm
    elsewhere = [mm(p.miss.distance_m) for p in facts.passages if not p.to_grasp]
    rest = f"{min(elsewhere):.1f} mm" if elsewhere else f"over {SHOWN * asked:g} mm"
    takes = any(p.to_grasp for p in facts.passages)
    taking = f", {clearance_mm:.1f} mm beside what it takes" if takes else ""
    return f"{rest}{taking} ({asked:g} mm asked)"


def _reads(facts: Sheet) -> str:
    reads = facts.bundle.manifest.reads
    return (
        ", ".join((*reads.inputs, *reads.timers, *reads.unset)) or "no input, timer or unset value"
    )


def _margins(facts: Sheet) -> Iterator[Markup]:
    manifest = facts.bundle.manifest
    yield element("h2", "Margins (level; heights have none)")
    yield element("table", *(_margin(m) for m in manifest.margins if not typed_after(m)))
    if manifest.first_to_fail != NOT_ASKED:
        yield element(
            "p", element("strong", "Fails first: "), prose(manifest.first_to_fail), class_="for"
        )


def _margin(margin: Margin) -> Markup:
    shown, kind = SIGNS[margin.answer]
    sign = element("span", shown, class_=kind)
    return element(
        "tr",
        element("td", sign),
        element("td", margin.name, class_="keep"),
        element("td", f"{margin.method}: ", prose(margin.sentence)),
    )


def _passages(facts: Sheet) -> Iterator[Markup]:
    near = sorted(facts.passages, key=lambda p: (p.to_grasp, p.miss.distance_m))
    if not near:
        return
    yield element("h2", "Look here: where it comes near")
    lines = [
        element(
            "tr",
            element("td", f"{p.miss.nearest_s:.1f} s", class_="n"),
            element("td", f"{mm(p.miss.distance_m):.1f} mm", class_="n"),
            element("td", _words(p)),
        )
        for p in near[:MOST_PASSAGES]
    ]
    yield element("table", *lines)


def _words(passage: Passage) -> str:
    miss = passage.miss
    first, second = miss.parts
    where = "" if miss.cause is None else f", step {miss.cause.step} of {miss.cause.program}"
    return f"{first} beside {second}{' to take it' if passage.to_grasp else ''}{where}"


# --- below ----------------------------------------------------------------------------------------


def _scene(facts: Sheet) -> Iterator[Markup]:
    yield element("h2", "Scene: measure each from the robot's axes, mm and degrees, and tick it")
    head = ("", "middle X", "Y", "top Z", "bottom Z", "O", "A", "T", "measured X  Y  Z")
    titles = [element("th", title, class_="n" if 0 < k < 8 else "") for k, title in enumerate(head)]
    yield element(
        "table",
        element("thead", element("tr", *titles)),
        element("tbody", *(_place(place) for place in places(facts.scene))),
        class_="check",
    )
    yield element(
        "p",
        "O A T: hand pointing straight down at it, fingers closing along its Y. Heights have no ",
        "margin: within 1 mm. What is taken stands free, so that closing fingers can push it.",
        class_="for",
    )


def _place(place: Place) -> Markup:
    numbers = (place.x, place.y, place.high, place.low, *place.oat)
    cells = [element("td", f"{number:.1f}", class_="n") for number in numbers]
    name = element(
        "td",
        element("span", class_="box"),
        element("strong", place.name) if place.carried else place.name,
    )
    return element("tr", name, *cells, element("td", class_="blank"))


def _procedure(facts: Sheet) -> Iterator[Markup]:
    again = changed(facts.bundle, facts.run)
    steps = order(facts.bundle, facts.raised, facts.scene.X_FT, again)
    yield element("h2", "Order")
    marked = [element("li", element("span", class_="box"), prose(step)) for step in steps]
    yield element("ol", *marked, class_="do")


def _signatures() -> Markup:
    titles: Sequence[str] = ("operator", "second person", "date and time", "result")
    return element("div", *(element("span", title) for title in titles), class_="sign")


def _footer(facts: Sheet) -> Markup:
    manifest = facts.bundle.manifest
    things = [
        ("sent", facts.content),
        ("program", manifest.program.sha256),
        ("scene", manifest.scene.sha256),
        ("robot", manifest.robot.sha256),
        ("profile", manifest.profile_sha256),
    ]
    if manifest.task is not None:
        things.append(("task", manifest.task.sha256))
    hashes = " · ".join(f"{name} {sha256[:SHORT]}" for name, sha256 in things)
    modelled = (
        "Not modelled: masses, forces, friction, the errors of real servos; a contact stops "
        "nothing in the simulation. Joint speeds of the robot are assumed."
    )
    return element("footer", f"vrts {manifest.vrts} · {hashes}", element("br"), modelled)


def _long(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{rest} s" if minutes == 0 else f"{minutes} min {rest:02d} s"
