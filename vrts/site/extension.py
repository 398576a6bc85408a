"""What Sphinx has to know of VAL-II and of this manual."""

from typing import Any

from pygments.lexers.special import TextLexer
from sphinx.application import Sphinx

from vrts.editors.pygments_lexer import Val2Lexer

FAMILY = ("val2", "val2+", "val", "vplus", "as", "auto")
PLAIN = ("csv",)  # for which Pygments has no colours
BEFORE_FURO = 400  # priority of a listener; furo's is the usual one, 500


def setup(app: Sphinx) -> dict[str, Any]:
    """Register lexers and listeners; called by Sphinx."""
    for name in FAMILY:
        app.add_lexer(name, Val2Lexer)
    for name in PLAIN:
        app.add_lexer(name, TextLexer)
    app.connect("html-page-context", _near_pages_only, BEFORE_FURO)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _near_pages_only(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: object
) -> None:
    """Let the list beside each page unfold where the page is, and nowhere else.

    Furo unfolds all of it on every page: most of the time of a build, and half of its bytes.
    """
    whole = context.get("toctree")
    if whole is not None:

        def near(**options: object) -> object:
            return whole(**{**options, "collapse": True})

        context["toctree"] = near
