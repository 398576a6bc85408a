"""The frame of every HTML page: style, content policy, body.

A page opens from `file://` without any network: styles, modules and data stand in it, and the
content policy forbids everything else.
"""

from collections.abc import Sequence

from vrts.report.html import Child, element, raw
from vrts.web.assets import asset

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' data:; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'"
)


def document(title: str, style: str, body: Sequence[Child], scripts: Sequence[Child]) -> str:
    """Return a whole HTML document with a style sheet of ours and the content policy."""
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", http_equiv="Content-Security-Policy", content=POLICY),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("meta", name="color-scheme", content="light dark"),
        element("title", title),
        raw("style", asset("report/base.css") + asset(style)),
    )
    content = element("body", element("main", *body), *scripts)
    return "<!doctype html>\n" + element("html", head, content, lang="en") + "\n"
