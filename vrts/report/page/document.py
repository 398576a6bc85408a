"""The frame of every HTML page: style, content policy, body.

A page opens from `file://` without any network: styles, modules and data stand in it, and the
content policy forbids everything else.
"""

from collections.abc import Sequence

from vrts.report.page.html import Child, Markup, element, joined, raw
from vrts.web.assets import asset

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' data:; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'"
)


def document(title: str, style: str, body: Sequence[Child], scripts: Sequence[Child]) -> str:
    """Return a whole HTML document with a style sheet of ours and the content policy."""
    return "".join(document_parts(title, style, body, joined(scripts)))


def document_parts(
    title: str, style: str, body: Sequence[Child], *scripts: Markup, policy: str = POLICY
) -> list[str]:
    """Return the same in parts: scripts are long, and stay as they are."""
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", http_equiv="Content-Security-Policy", content=policy),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("meta", name="color-scheme", content="light dark"),
        element("title", title),
        raw("style", asset("report/base.css") + asset(style)),
    )
    main = element("main", *body)
    begin = f'<!doctype html>\n<html lang="en">{head}<body>{main}'
    return [begin, *scripts, "</body></html>\n"]
