"""The groups of a class as a section of its page: who, how strong, why, and where to compare."""

from collections import Counter
from collections.abc import Mapping

from vrts.marking.similarity.evidence import MOST
from vrts.marking.similarity.groups import Group
from vrts.marking.similarity.ranking import Ranking
from vrts.report.page.html import Child, Markup, element, joined, prose
from vrts.report.plain import one_line

MOST_REASONS = 3
MOST_PAGES = 12  # of a group, linked
ALIKE = {  # of evidence, what one of it is, and several
    "motion": ("place or motion", "places and motions"),
    "steps": ("step or row of steps", "steps and rows of steps"),
    "numbers": ("number or taught value", "numbers and taught values"),
    "manner": ("manner of motion", "manners of motion"),
    "offsets": ("exact distance of taught values", "exact distances of taught values"),
    "words": ("name, comment or habit of layout", "names, comments and habits of layout"),
    "text": ("row of words", "rows of words"),
    "lines": ("line with other numbers at most", "lines with other numbers at most"),
}
UNLIKE = {  # what is not alike, where there is no evidence of it
    "words": "other names and comments",
    "text": "another wording or order of steps",
}
MEANING = {
    "strong": "chance hardly explains it",
    "worth a look": "chance may explain it",
    "weak": "chance explains it well",
}


def groups_section(
    ranking: Ranking, labels: Mapping[str, Markup], names: Mapping[str, str]
) -> Markup:
    """Return the section.

    Args:
        ranking: What was found.
        labels: Of the programs of the class, by identifier.
        names: Of the students, by identifier, where they are known.
    """
    if not ranking.groups:
        nothing = "No programs hang together more than chance explains."
        return element("section", element("h2", "Groups"), element("p", nothing))
    heads = ("No.", "Programs", "Strength", "Why", "Compare")
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    rows = [_row(k, group, labels, names) for k, group in enumerate(ranking.groups, start=1)]
    table = element("table", element("thead", head), element("tbody", *rows), class_="groups")
    return element(
        "section",
        element("h2", "Groups", id="groups-head"),
        element("p", _counts(ranking), class_="where"),
        element(
            "div", table, class_="wide", role="region", tabindex="0", aria_labelledby="groups-head"
        ),
    )


def _counts(ranking: Ranking) -> str:
    counts = {word: sum(one.strength == word for one in ranking.groups) for word in MEANING}
    told = [f"{count} {word}" for word, count in counts.items() if count]
    return (
        f"Programs that seem to come from one source: {', '.join(told)}. In a class as large as"
        f" this, some weak groups are there by chance alone."
    )


def _row(
    number: int, group: Group, labels: Mapping[str, Markup], names: Mapping[str, str]
) -> Markup:
    members = [element("li", labels.get(one) or one_line(one)) for one in group.members]
    width = f"width:{100 * group.score:.0f}%"
    return element(
        "tr",
        element("td", str(number), class_="number"),
        element("td", element("ul", *members)),
        element(
            "td",
            element("b", group.strength),
            element("span", element("i", style=width), class_="share", aria_hidden="true"),
            element("small", MEANING[group.strength]),
            class_=f"strength {group.strength.split(' ', 1)[0]}",
        ),
        element("td", element("p", why(group), class_="why"), _reasons(group)),
        element("td", *_pages(group, names)),
    )


def why(group: Group) -> str:
    """Return in a sentence what the strongest two of a group have alike and rare, and what not."""
    counts = Counter(one.what for one in group.evidence)
    told = [
        f"{counts[kind]} {one if counts[kind] == 1 else several}"
        for kind, (one, several) in ALIKE.items()
        if counts[kind]
    ]
    if not told:
        return "They share many small things, none of which is rare."
    whole = len(group.evidence) < MOST  # else there may be more of a kind that is not told
    unlike = [words for kind, words in UNLIKE.items() if whole and not counts[kind]]
    but = f", but {' and '.join(unlike)}" if unlike else ""
    *most, last = told
    return f"Alike and rare: {' and '.join([*([', '.join(most)] if most else []), last])}{but}."


def _reasons(group: Group) -> Markup:
    seen: set[str] = set()
    told: list[Child] = []
    for kinds in (True, False):  # of each kind one first
        for one in group.evidence:
            new = one.words not in seen and not (kinds and one.what in seen)
            if new and len(told) < MOST_REASONS:
                seen |= {one.words, one.what}
                told.append(element("li", prose(one.words[:1].upper() + one.words[1:])))
    return element("ul", *told) if told else joined(["many small things"])


def _pages(group: Group, names: Mapping[str, str]) -> list[Child]:
    linked = [link for link in group.links if link.page]
    if len(linked) == 1:
        return [element("a", "side by side", href=linked[0].page)]
    found: list[Child] = []
    for link in linked[:MOST_PAGES]:
        both = " and ".join(names.get(one) or one for one in (link.first, link.second))
        found.append(element("p", element("a", one_line(both), href=link.page)))
    if len(linked) > MOST_PAGES:
        found.append(element("p", f"and {len(linked) - MOST_PAGES} more pairs in the folder"))
    return found
