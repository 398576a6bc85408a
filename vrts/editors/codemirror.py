"""VAL-II for CodeMirror: the shapes as a module of the editor in the page.

`python -m vrts.editors.codemirror` prints it; it is kept in `web/live/editor/val2.js`.
"""

import json
import sys

from vrts.editors.patterns import patterns

_HEAD = """\
// The shapes of VAL-II in order, the first that matches wins.
// Written by `python -m vrts.editors.codemirror`.

/** @type {[string, string[]][]} expression, and what its groups are, or the whole */
export const PATTERNS = [
"""


def module_text() -> str:
    """Return the module."""
    rows = [json.dumps([p.expression, list(p.parts)], ensure_ascii=True) for p in patterns()]
    return _HEAD + "".join(f"  {row},\n" for row in rows) + "];\n"


if __name__ == "__main__":
    sys.stdout.write(module_text())
