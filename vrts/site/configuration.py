"""How Sphinx is set up: furo, MyST, nothing that a page would load from elsewhere."""

from pathlib import Path
from typing import Any

from vrts import __version__
from vrts.site.generated.command_pages import top_commands

STATIC = Path(__file__).parent / "static"


def configuration() -> dict[str, Any]:
    """Return the values that Sphinx reads from `conf.py` elsewhere."""
    return {
        "project": "vrts",
        "author": "the authors of vrts",
        "html_show_copyright": False,
        "html_show_sphinx": False,
        "version": __version__,
        "release": __version__,
        "language": "en",
        "extensions": ["myst_parser", "vrts.site.extension"],
        "myst_enable_extensions": ["colon_fence", "deflist"],
        "myst_heading_anchors": 4,
        "suppress_warnings": ["myst.header", "myst.topmatter"],
        "root_doc": "index",
        "exclude_patterns": [],
        "today_fmt": "",
        **_html(),
        "man_pages": _man_pages(),
        "man_show_urls": False,
    }


def _html() -> dict[str, Any]:
    return {
        "html_theme": "furo",
        "html_title": f"vrts {__version__}",
        "html_static_path": [str(STATIC)],
        "html_css_files": ["manual.css"],
        "html_js_files": ["manual.js"],
        "html_search_scorer": str(STATIC / "scorer.js"),
        "html_copy_source": False,
        "html_show_sourcelink": False,
        "html_show_search_summary": False,  # a page from a file may not read others
        "html_use_index": False,
        "html_last_updated_fmt": None,
        "html_permalinks_icon": "#",
        "html_theme_options": {
            "navigation_with_keys": False,
            "top_of_page_buttons": [],
        },
        "pygments_style": "a11y-high-contrast-light",
    }


def _man_pages() -> list[tuple[str, str, str, list[str], int]]:
    """Return the man pages: one of all commands, and one of each, as `man vrts-verify`."""
    whole = (
        "look-up/commands/index",
        "vrts",
        "compile, simulate, verify and mark VAL-II robot programs",
    )
    each = [
        (
            f"look-up/commands/{called.path[1]}",
            f"vrts-{called.path[1]}",
            called.command.get_short_help_str(200).rstrip(".").lower(),
        )
        for called in top_commands()
    ]
    return [(page, name, says, [], 1) for page, name, says in (whole, *each)]
