"""The page of a class: marks, what goes wrong, what is to be looked at, and every submission."""

from vrts.marking.overview.causes import causes
from vrts.marking.overview.changes import changes
from vrts.marking.overview.reviews import reviews
from vrts.marking.overview.table import table
from vrts.marking.overview.top import top
from vrts.marking.overview.worst import checks, most_contacts, slowest
from vrts.marking.row import Class, unsafe_first
from vrts.report.page.document import document
from vrts.report.page.html import Markup, element, raw
from vrts.report.plain import one_line
from vrts.web.assets import asset


def overview_page(
    rows: Class, *, pages: bool = True, similarity: str | None = None, where: str = ""
) -> str:
    """Return the page, which stands in `staff`.

    Args:
        rows: Of the class, in the order of the table.
        pages: Whether there are pages about the submissions to link to.
        similarity: Address of the page of similar programs; None: there is none.
        where: Said below the title.
    """
    every = rows.rows
    parts = {
        "To be reviewed": ("review", reviews(every, pages=pages)),
        "Checks": ("checks", checks(every)),
        "Mistakes": ("causes", causes(every, pages=pages)),
        "Slowest": ("slowest", slowest(every, pages=pages)),
        "Contacts": ("contacts", most_contacts(every, pages=pages)),
        "Late and changed": ("changes", changes(every, pages=pages)),
        "All submissions": ("all", table(unsafe_first(every), pages=pages)),
    }
    links = [
        element("a", name, href=f"#{identifier}")
        for name, (identifier, section) in parts.items()
        if section is not None
    ]
    if similarity is not None:
        links.append(element("a", "Similarity", href=similarity))
    found = dict(parts.values())
    body = [
        top(every, rows.title, where),
        element("nav", *links, aria_label="On this page"),
        found["review"],
        found["checks"],
        found["causes"],
        _beside(found["slowest"], found["contacts"]),
        found["changes"],
        found["all"],
        element("footer", element("p", _made_by(rows))),
    ]
    script = raw("script", asset("report/overview.js"), type="module")
    return document(one_line(rows.title), "report/overview.css", body, [script])


def _beside(first: Markup | None, second: Markup | None) -> Markup | None:
    if first is None or second is None:
        return first or second
    return element("div", first, second, class_="beside")


def _made_by(rows: Class) -> str:
    versions = sorted({row.result.versions.vrts for row in rows.rows})
    return f"Written by vrts {', '.join(versions)}" if versions else "Written by vrts"
