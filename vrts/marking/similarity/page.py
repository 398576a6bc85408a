"""Programs that are alike as a page: groups first, then pairs with equal text side by side."""

from collections.abc import Mapping, Sequence
from textwrap import dedent

from vrts.base.source import SourceFile
from vrts.marking.overview.links import staff_report
from vrts.marking.similarity.groups import LOOK, STRONG
from vrts.marking.similarity.groups_section import groups_section
from vrts.marking.similarity.ranking import Pair, Ranking, SharedValue
from vrts.marking.similarity.regions import Region
from vrts.marking.similarity.symbols import readable
from vrts.report.page.document import document
from vrts.report.page.html import Markup, element, joined
from vrts.report.plain import one_line, shown

STYLE = "report/similarity.css"
MOST_SHOWN = 60  # pairs side by side
MOST_LINES = 80  # of a region
LONGEST_LINE = 1_000  # characters of a line


def similarity_page(
    ranking: Ranking,
    programs: Mapping[str, bytes],
    title: str,
    names: Mapping[str, str] | None = None,
    *,
    pages: bool = True,
) -> str:
    """Return the page.

    Args:
        ranking: What was found.
        programs: By identifier, as they were compared.
        title: Of the class.
        names: Of the students, by identifier, where they are known.
        pages: Whether there are pages about the submissions to link to.
    """
    wanted = {who for pair in ranking.pairs[:MOST_SHOWN] for who in (pair.first, pair.second)}
    sources: dict[str, SourceFile] = {}
    for who in sorted(wanted):
        file = readable(programs[who], who)
        if file is not None:
            sources[who] = file.source
    known = {who: one_line(name) for who, name in (names or {}).items()}
    labels = {who: _who(who, known.get(who, ""), pages=pages) for who in programs}
    body = [
        _head(ranking, title),
        groups_section(ranking, labels, known),
        _table(ranking, labels),
        *(
            _side_by_side(number, pair, sources, labels)
            for number, pair in enumerate(ranking.pairs[:MOST_SHOWN], start=1)
        ),
        _method(ranking),
        element("footer", element("p", "Written by vrts")),
    ]
    return document(f"Similarity: {one_line(title)}", STYLE, body, [])


def _head(ranking: Ranking, title: str) -> Markup:
    count = f"{ranking.compared} programs compared, each with all others"
    for corpus in ranking.corpus:
        count += f", and with {corpus.programs} of {one_line(corpus.name)}"
    return element(
        "header",
        element("h1", f"Similarity: {one_line(title)}"),
        element("p", count, class_="where"),
        element("p", element("b", "Not a verdict. "), f"This is {ranking.note}.", class_="notice"),
        element("p", element("a", "Overview of the class", href="index.html")),
        class_="first-screen",
    )


def _table(ranking: Ranking, labels: Mapping[str, Markup]) -> Markup:
    if not ranking.pairs:
        nothing = element("p", "No two programs share more than what is usual in this class.")
        return element("section", element("h2", "Pairs with equal text"), nothing)
    heads = ("Rank", "Program", "And", "Alike", "Code", "Taught values")
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    rows = [_row(number, pair, labels) for number, pair in enumerate(ranking.pairs, start=1)]
    table = element("table", element("thead", head), element("tbody", *rows), class_="ranking")
    return element(
        "section",
        element("h2", "Pairs with equal text", id="ranking-head"),
        element(
            "div",
            table,
            class_="wide",
            role="region",
            tabindex="0",
            aria_labelledby="ranking-head",
        ),
    )


def _row(number: int, pair: Pair, labels: Mapping[str, Markup]) -> Markup:
    rank = (
        element("a", str(number), href=f"#pair-{number}", aria_label=f"Pair {number}")
        if number <= MOST_SHOWN
        else str(number)
    )
    width = f"width:{100 * pair.score:.0f}%"
    bar = element("span", element("i", style=width), class_="share", aria_hidden="true")
    count = len(pair.values)
    values = f"{_percent(pair.taught)}, {count} shared" if count else "–"
    return element(
        "tr",
        element("td", rank, class_="number"),
        element("td", labels[pair.first]),
        element("td", labels[pair.second]),
        element("td", bar, element("b", _percent(pair.score)), class_="alike"),
        element("td", _percent(pair.code)),
        element("td", values),
    )


def _side_by_side(
    number: int, pair: Pair, sources: Mapping[str, SourceFile], labels: Mapping[str, Markup]
) -> Markup:
    first, second = sources[pair.first], sources[pair.second]
    head = element(
        "div",
        element("div", element("h3", labels[pair.first])),
        element("div", element("h3", labels[pair.second])),
        class_="sides heads",
    )
    regions = sorted(pair.regions, key=lambda region: (region.first_start, region.second_start))
    blocks = [_block(region, first, second) for region in regions]
    what = [
        f"{_percent(pair.code)} of the code",
        f"{_percent(pair.taught)} of the taught values",
    ]
    return element(
        "section",
        element("h2", f"{number}: {_percent(pair.score)} alike", id=f"pair-{number}"),
        element("p", ", ".join(what), "; what is rare in the class counts more.", class_="where"),
        head,
        *blocks,
        _values(pair.values),
        class_="pair",
    )


def _block(region: Region, first: SourceFile, second: SourceFile) -> Markup:
    return element(
        "div",
        _lines(first, region.first_start, region.first_end),
        _lines(second, region.second_start, region.second_end),
        class_="sides",
    )


def _lines(source: SourceFile, start: int, end: int) -> Markup:
    last = min(end, start + MOST_LINES - 1)
    cut = (source.line_text(k)[:LONGEST_LINE] for k in range(start, last + 1))
    texts = dedent("\n".join(shown(line).text for line in cut))
    rows = [
        element(
            "tr",
            element("td", str(line), class_="line"),
            element("td", element("code", text)),
        )
        for line, text in enumerate(texts.split("\n"), start)
    ]
    more = [] if last == end else [element("p", f"and {end - last} more lines", class_="where")]
    return element("div", element("table", element("tbody", *rows), class_="code"), *more)


def _values(values: Sequence[SharedValue]) -> Markup | None:
    if not values:
        return None
    heads = ("Taught value", "Name and line", "Name and line", "Others with it")
    rows = [
        element(
            "tr",
            element("td", element("code", "  ".join(f"{n:.2f}" for n in value.numbers))),
            element("td", element("code", one_line(value.first)), f", line {value.first_line}"),
            element("td", element("code", one_line(value.second)), f", line {value.second_line}"),
            element("td", str(value.others)),
        )
        for value in values
    ]
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    caption = element("caption", "Identical taught values, the rarest first")
    return element(
        "table", caption, element("thead", head), element("tbody", *rows), class_="values"
    )


def _method(ranking: Ranking) -> Markup:
    what = (
        f"For pairs with equal text, programs are compared as sequences of words of the language,"
        f" without names, numbers, comments and layout: {ranking.symbols} in a row that are the"
        f" same count as shared. The order of subroutines does not matter."
    )
    left_out = (
        "What comes with the task is left out, and so is what many in the class have: what few"
        " share counts most. Taught values count when two programs have the same numbers to 0.01,"
        " under whatever name."
    )
    meaning = (
        "Those who handed in together are not compared. A high place says that it is worth reading"
        " both programs, and nothing else."
    )
    groups = (
        "Groups rest on seven kinds of evidence: what the runs did, in space and from the things of"
        " each one's own scene; the steps as they are executed, calls put in place, loops of every"
        " kind alike, filler left out; numbers and taught values within a tolerance; comments,"
        " names and layout; the text; how far apart taught values lie along an axis, to the last"
        " digit; and the manner of motion: speeds, and how the hand comes and goes. What a feature"
        " counts depends on how few have it, here and in the folders compared with. What comes with"
        " the task, and places that the scene names, count nothing."
    )
    strength = (
        "Nearly all pairs of a class are innocent, and show what chance can do. A group is strong"
        f" where at most {STRONG:g} pairs as much alike are expected by chance among all that were"
        f" compared, worth a look up to {LOOK:g}, and weak beyond. Pairs with other folders count"
        " too, and fewer than 500 pairs count as 500. The bar beside it is half full where one"
        " such pair is expected by chance. A group holds only those who hang together with all"
        " others in it."
    )
    words = (groups, strength, what, left_out, meaning)
    return element(
        "section", element("h2", "How it is measured"), *(element("p", w) for w in words)
    )


def _who(identifier: str, name: str, *, pages: bool) -> Markup:
    link = staff_report(identifier) if pages else None
    text = name or identifier
    label = element("a", text, href=link) if link else text
    small = element("small", f" {identifier}") if text != identifier else None
    return joined([label, small])


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"
