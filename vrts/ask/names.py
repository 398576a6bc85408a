"""Pages by their names: what somebody types who knows where to go."""

from collections.abc import Sequence
from difflib import get_close_matches

from vrts.ask.page import Kind, Page

_ORDER = (Kind.WORD, Kind.MESSAGE, Kind.RECIPE, Kind.RULE, Kind.BACKGROUND, Kind.COMMAND)


def named(asked: str, pages: Sequence[Page]) -> Page | None:
    """Return the page of a name; None: it is no name.

    A name may be written in small letters, without its folder, without `vrts` before a command,
    a word of the language without its sign. A sentence is never a name.
    """
    key = " ".join(asked.lower().removesuffix(".md").split())
    for whole in (True, False):
        for kind in _ORDER:
            for page in pages:
                if page.kind is kind and key in _keys(page, whole=whole):
                    return page
    return None


def near_names(asked: str, pages: Sequence[Page]) -> tuple[str, ...]:
    """Return names that look like what was asked, the nearest first."""
    names = {key: page.name for page in pages for key in _keys(page, whole=False) if key}
    near = get_close_matches(asked.lower(), names, 3, 0.7)
    return tuple(dict.fromkeys(names[key] for key in near))


def _keys(page: Page, *, whole: bool) -> tuple[str, ...]:
    name = page.name.lower()
    if whole:
        return (name,)
    match page.kind:
        case Kind.COMMAND:
            return (name.removeprefix("vrts "),)
        case Kind.MESSAGE:
            return (page.title.partition(" ")[2],)  # its slug: `out-of-reach`
        case Kind.WORD:
            return (name.lstrip("$#"),)
        case _:
            last = name.rpartition("/")[2]
            return (last, page.title.lower()) if not page.section else (last,)
