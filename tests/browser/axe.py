"""axe-core's rules for pages, every one that there is, made three times as quick.

What axe-core finds is untouched. Two things of it cost most of its time: it was translated for old
browsers, so that each colour hides its numbers in maps with weak keys; and it parses the same few
colours again for every text. Here such a map keeps what it holds at the key itself, and a colour is
parsed once.
"""

from importlib.resources import files
from typing import Any

from tests.browser.support import Opened

PLAIN = files("axe_playwright_python").joinpath("axe.min.js").read_text(encoding="utf-8")
_MAPS = """
  class Weak {
    own = Symbol();
    get(key) { return key?.[this.own]; }
    has(key) { return this.own in Object(key); }
    delete(key) { return this.has(key) && delete key[this.own]; }
  }
  class WeakMap extends Weak {
    set(key, value) { key[this.own] = value; return this; }
  }
  class WeakSet extends Weak {
    add(key) { key[this.own] = true; return this; }
  }
"""
_COLOURS = """
  const colour = axe.commons.color.Color.prototype;
  const parse = colour.parseString;
  const known = new Map();
  colour.parseString = function (text) {
    if (!known.has(text)) {
      parse.call(this, text);
      known.set(text, [this.r, this.g, this.b, this.alpha]);
    }
    [this.r, this.g, this.b, this.alpha] = known.get(text);
    return this;
  };
"""
AXE = f"(() => {{ {_MAPS}\n{PLAIN}\n{_COLOURS} }})()"
ALL_RULES = """async () => {
  const rules = Object.fromEntries(axe.getRules().map(rule => [rule.ruleId, { enabled: true }]));
  const found = await axe.run(document, { rules, resultTypes: ["violations"] });
  const shown = nodes => nodes.slice(0, 5).map(node => node.html.slice(0, 140));
  return {
    passes: found.passes.length,
    violations: found.violations.map(one => [one.id, shown(one.nodes)]),
  };
}"""


def faults(view: Opened, width: int, *, dark: bool, least: int = 31) -> list[Any]:
    """Return what axe-core finds on a page of a width, light or dark, which has `AXE`.

    Args:
        view: The page.
        width: Of the window [px].
        dark: Whether it is dark.
        least: Rules that have to pass, so that it is known that they looked.
    """
    view.page.set_viewport_size({"width": width, "height": 900})
    view.page.emulate_media(color_scheme="dark" if dark else "light")
    found = view.page.evaluate(ALL_RULES)
    assert found["passes"] >= least
    assert view.page.evaluate("document.documentElement.scrollWidth") <= width
    return found["violations"]
