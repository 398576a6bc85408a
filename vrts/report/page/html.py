"""HTML built so that nothing foreign gets through: a plain `str` is always escaped.

Only what the functions here return is `Markup` and goes in as it is.
"""

import json
from collections.abc import Iterable, Mapping
from html import escape
from typing import TypeAlias

from vrts.report.plain import visible
from vrts.report.screen.palette import Palette, Style

VOID = frozenset({"img", "meta", "br", "input", "link"})

OPEN, MIDDLE, CLOSE = "\ue000", "\ue001", "\ue002"  # `visible` lets no private character through


class Markup(str):
    """Text that is HTML already."""

    __slots__ = ()


Child: TypeAlias = str | Markup | None
Attribute: TypeAlias = str | int | float | bool | None


def element(name: str, /, *children: Child, **attributes: Attribute) -> Markup:
    """Return an element. `class_` and `data_t` are written `class` and `data-t`.

    Attributes that are None or False are left out; True gives an attribute without value.
    """
    written = "".join(_attribute(key, value) for key, value in attributes.items())
    start = f"<{name}{written}>"
    return Markup(start) if name in VOID else Markup(f"{start}{joined(children)}</{name}>")


def joined(children: Iterable[Child]) -> Markup:
    """Return children one after another, text escaped."""
    return Markup("".join(_child(child) for child in children))


def prose(text: str) -> Markup:
    """Return a sentence of ours: what stands between backticks becomes code."""
    parts = visible(text).split("`")
    if len(parts) % 2 == 0:  # a backtick without its partner
        return joined([text])
    return joined(element("code", p) if k % 2 else p for k, p in enumerate(parts))


def raw(name: str, content: str, /, **attributes: Attribute) -> Markup:
    """Return a `style` or `script` element with content of our own.

    Raises:
        ValueError: The content would end the element.
    """
    tags = "<" in content  # neither data nor modules, which are long, have any
    if tags and ("</" + name in content.lower() or "<!--" in content):
        raise ValueError(f"content ends its own {name} element")
    written = "".join(_attribute(key, value) for key, value in attributes.items())
    return Markup(f"<{name}{written}>{content}</{name}>")


def json_script(identifier: str, data: Mapping[str, object]) -> Markup:
    """Return data for scripts to read: JSON in which no character can end the element."""
    return written_script(identifier, {key: json_text(value) for key, value in data.items()})


def written_script(identifier: str, data: Mapping[str, str]) -> Markup:
    """Return the same where `json_text` has written each value already."""
    members = ",".join(f"{json_text(key)}:{text}" for key, text in data.items())
    return raw("script", f"{{{members}}}", type="application/json", id=identifier)


def json_text(data: object) -> str:
    """Return JSON in which no character can end an element."""
    text = json.dumps(data, ensure_ascii=True, separators=(",", ":"), allow_nan=False)
    for character in "<>&":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text


class MarkupPalette(Palette):
    """Paints with `span` elements; `painted` turns the whole text into markup."""

    def __init__(self) -> None:
        """Nothing to choose."""
        super().__init__(color=True)

    def paint(self, style: Style, text: str) -> str:
        """Return the text between marks that survive escaping."""
        return f"{OPEN}{style.name.lower()}{MIDDLE}{text}{CLOSE}"


def painted(text: str) -> Markup:
    """Return a text painted by `MarkupPalette`, escaped, its marks turned into elements."""
    safe = escape(text, quote=True)
    safe = safe.replace(OPEN, '<span class="').replace(MIDDLE, '">').replace(CLOSE, "</span>")
    return Markup(safe)


def _child(child: Child) -> str:
    if child is None:
        return ""
    return str(child) if isinstance(child, Markup) else escape(visible(child), quote=True)


def _attribute(key: str, value: Attribute) -> str:
    name = key.rstrip("_").replace("_", "-")
    if value is None or value is False:
        return ""
    return f" {name}" if value is True else f' {name}="{escape(visible(str(value)), quote=True)}"'
