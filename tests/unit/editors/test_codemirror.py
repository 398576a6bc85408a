"""The words of the editor in the page are those of all highlighters, and its file is fresh."""

import json
import re

from vrts.editors.codemirror import module_text
from vrts.editors.patterns import patterns
from vrts.web.assets import asset


def test_the_editor_in_the_page_knows_the_words_of_the_vocabulary() -> None:
    assert asset("live/editor/val2.js") == module_text()
    rows = re.findall(r"^  (\[.*\]),$", module_text(), re.M)
    assert [tuple(json.loads(row)) for row in rows] == [
        (p.expression, list(p.parts)) for p in patterns()
    ]


def test_every_shape_has_a_look() -> None:
    looks = set(re.findall(r"^  (\w+): \{ color", asset("live/editor/language.js"), re.M))
    parts = {part.replace(" ", "_") for pattern in patterns() for part in pattern.parts}
    assert parts - {"blank"} == looks
