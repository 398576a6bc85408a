"""One page about every future of a program: the answer, what goes wrong with replays, the tree."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.prove.environment.environment import Environment
from vrts.prove.explore.tree import MOST as MOST_KEPT
from vrts.prove.proof import Proof
from vrts.prove.telling.scenarios import scenario_of
from vrts.report.assessment import Assessment
from vrts.report.page.document import document_parts
from vrts.report.page.future_cards import MOST_FOUND, answer_mark, cards, spoken_of
from vrts.report.page.futures.drawing import tree, words_of
from vrts.report.page.futures.folding import Node, nodes, stories
from vrts.report.page.html import Markup, element, json_script, prose, raw
from vrts.report.page.listing import listing
from vrts.report.page.page import charts_section, modules, replay_data, replay_section
from vrts.report.plain import capital, one_line
from vrts.report.proof_words import counts, decision, headline, place
from vrts.report.quantities import seconds
from vrts.scene.writing.scenario_text import scenario_text
from vrts.web.assets import asset

MOST_WATCHED = 24  # futures that go right
MOST_CHARACTERS = 3_000_000  # of all their data


class Explored(NamedTuple):
    """What a page tells of."""

    title: str
    where: str  # task and scene, in words
    source: SourceFile | None
    proof: Proof
    environment: Environment
    tick_s: float  # how often the controller looks [s]
    replays: tuple[Assessment, ...] = ()  # of the first things that go wrong, in their order
    leaves: Mapping[int, Assessment] = MappingProxyType({})  # of futures that go right, by node


class Shown(NamedTuple):
    """A replay on the page."""

    key: str  # in its address: `2` is what goes wrong second, `n3` the third node
    replay: Assessment
    script: Markup  # its data
    title: str


def futures_page(explored: Explored) -> str:
    """Return the page: complete in itself, it opens without any network."""
    proof = explored.proof
    drawn = nodes(proof)
    shown = _shown(explored, drawn)
    body = [
        _top(explored),
        _navigation(explored, drawn, shown),
        _found(explored),
        _replay(shown[0]) if shown else None,
        _tree(explored, drawn, shown) if drawn else None,
        charts_section(shown[0].replay) if shown else None,
        element("section", element("h2", "What was looked at"), *spoken_of(proof), id="looked-at"),
        None if shown else _program(explored),
        element("footer", element("p", "Written by vrts")),
    ]
    scripts = [json_script("nodes", {"nodes": _told(explored, drawn, shown)})]
    scripts += [one.script for one in shown]
    scripts.append(raw("script", asset("report/futures.js")))
    if shown:
        scripts += modules()
    return "".join(document_parts(one_line(explored.title), "report/page.css", body, *scripts))


def _top(explored: Explored) -> Markup:
    proof = explored.proof
    words = element(
        "div",
        element("h1", one_line(explored.title)),
        element("p", one_line(explored.where), class_="where") if explored.where else None,
        element("h2", answer_mark(proof.answer), class_="verdict"),
        element("p", prose(headline(proof)), ".", class_="lead"),
        element("p", f"{counts(proof)}. Environment: {one_line(explored.environment.title)}."),
        class_="words",
    )
    return element("header", words, class_="first-screen futures top")


def _shown(explored: Explored, drawn: Sequence[Node]) -> list[Shown]:
    """Return the replays of what goes wrong, and those of other leaves for which there is room."""
    found: list[Shown] = []
    for number, a in enumerate(explored.replays, 1):
        wronged = explored.proof.found[number - 1]
        data = {**replay_data(a), "moment": seconds(wronged.time_s)}
        title = capital(one_line(wronged.headline))
        found.append(_shown_as(str(number), a, data, title, first=not found))
    left = MOST_CHARACTERS
    for number, a in explored.leaves.items():
        title = capital(words_of(drawn[number]))
        one = _shown_as(f"n{number + 1}", a, replay_data(a), title, first=not found)
        left -= len(one.script)
        if left < 0:
            break
        found.append(one)
    return found


def _shown_as(
    key: str, a: Assessment, data: Mapping[str, object], title: str, *, first: bool
) -> Shown:
    """Return a replay; the first of all is shown where the address names none."""
    return Shown(key, a, json_script("data" if first else f"data-{key}", data), title)


def _navigation(explored: Explored, drawn: Sequence[Node], shown: Sequence[Shown]) -> Markup:
    parts = [
        ("found", "What goes wrong", explored.proof.found),
        ("replay", "Replay", shown),
        ("tree", "Decisions", drawn),
        ("charts", "Charts", shown),
        ("looked-at", "What was looked at", True),
    ]
    links = [element("a", name, href=f"#{key}") for key, name, there in parts if there]
    return element("nav", *links, aria_label="On this page")


def _found(explored: Explored) -> Markup | None:
    found = explored.proof.found
    if not found:
        return None
    acts = [
        element(
            "p",
            element("a", "Watch it", href=f"#future={number}", class_="watch", data_future=number),
            class_="act",
        )
        for number, _ in enumerate(explored.replays, 1)
    ]
    return element(
        "section",
        element("h2", "What goes wrong"),
        *cards(found, acts),
        id="found",
        class_="futures",
    )


def _replay(first: Shown) -> Markup:
    return replay_section(first.replay, (), element("small", first.title, id="shown"))


def _program(explored: Explored) -> Markup | None:
    if explored.source is None:
        return None
    return element("section", element("h2", "Program"), listing(explored.source, ()), id="program")


# --- the tree -------------------------------------------------------------------------------------


def _tree(explored: Explored, drawn: Sequence[Node], shown: Sequence[Shown]) -> Markup:
    known = len(explored.proof.tree)
    kept = f" Only the first {known:,} are kept." if known >= MOST_KEPT else ""
    right = sum(bool(node.ends) and not node.marks for node in drawn)
    watched = sum(one.key.startswith("n") for one in shown)
    if watched < right:
        kept += f" Of {right:,} lines that end well you can watch {watched:,} here;"
        kept += " for the others there is the scenario."
    return element(
        "section",
        element("h2", "The tree of decisions"),
        element(
            "p",
            "Time runs to the right. Each line is a future; a fork is something that came from "
            f"outside. Futures that are alike are one line with a number.{kept}",
            class_="where",
        ),
        element("ul", *_keys(), class_="tree-keys"),
        element(
            "div",
            tree(drawn),
            class_="tree-view",
            role="region",
            aria_label="The tree of decisions",
            tabindex="0",
        ),
        element(
            "div",
            element("p", "Choose a line to see its story and its scenario here."),
            id="chosen",
            class_="chosen",
            aria_live="polite",
        ),
        id="tree",
        class_="futures",
    )


def _keys() -> list[Markup]:
    rows = (
        ("good", "comes to its end"),
        ("wrong", "goes wrong, with its number above"),
        ("merged", "goes on like another line"),
        ("open", "not looked at to its end"),
    )
    return [element("li", element("i", class_=key), words) for key, words in rows]


def _told(
    explored: Explored, drawn: Sequence[Node], shown: Sequence[Shown]
) -> list[dict[str, object]]:
    """Return what is shown of each node when it is chosen."""
    keys = {one.key for one in shown}
    told: list[dict[str, object]] = []
    for k, (node, story) in enumerate(zip(drawn, stories(drawn), strict=True), 1):
        scenario = scenario_of(explored.environment, story, explored.tick_s)
        title = words_of(node)
        told.append(
            {
                "title": capital(title),
                "many": node.many,
                "last": seconds(node.last_s),
                "ends": _end_of(node),
                "story": [[seconds(d.time_s), place(d), capital(decision(d))] for d in story],
                "scenario": scenario_text(title, scenario),
                "replay": f"n{k}" if f"n{k}" in keys else None,
                "wrong": [mark.number for mark in node.marks if mark.number <= min(MOST_FOUND, 99)],
            }
        )
    return told


def _end_of(node: Node) -> str:
    match node.ends:
        case "":
            return "it goes on only in the futures that branch off from it"
        case "merged":
            return f"at {node.end_s:.3f} s it is in a state that another future was in"
        case "open":
            return "it was not looked at to its end"
        case how:
            return f"at {node.end_s:.3f} s it ends: {how}"
