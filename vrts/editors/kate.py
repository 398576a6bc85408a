"""VAL-II for Kate and KWrite: colours as a definition of KDE's syntax highlighting.

`python -m vrts.editors.kate` prints the definition; `vrts editor kate` writes it to `val2.xml`.
"""

import sys
from xml.sax.saxutils import quoteattr

from vrts.editors.patterns import LABEL, Pattern, patterns

_STYLES = {
    "comment": "Comment",
    "section": "Import",
    "string": "String",
    "character": "Char",
    "label": "Annotation",
    "structure": "ControlFlow",
    "instruction": "Keyword",
    "qualifier": "Attribute",
    "number": "DecVal",
    "format": "SpecialString",
    "function": "BuiltIn",
    "constant": "Constant",
    "word operator": "Operator",
    "string variable": "Variable",
    "precision point": "Variable",
    "name": "Variable",
    "operator": "Operator",
    "punctuation": "Normal",
}
_CONTEXT = '      <context attribute="blank" name='
_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE language SYSTEM "language.dtd">
<!-- VAL-II, the language of Unimation's PUMA robots. Written by `python -m vrts.editors.kate`. -->
<language name="VAL-II" section="Sources" extensions="*.v2;*.pg;*.lc" version="1" \
kateversion="5.0" casesensitive="0" author="vrts" license="BSD-3-Clause">
  <highlighting>
    <contexts>
"""
_TAIL = """\
    </itemDatas>
  </highlighting>
  <general>
    <comments><comment name="singleLine" start=";" position="afterwhitespace"/></comments>
    <keywords casesensitive="0"/>
  </general>
</language>
"""


def definition() -> str:
    """Return the definition.

    Kate gives what a rule matches one colour. So the begin of a line, with its label and first
    word, is a context of its own; the rest of the line is another one.
    """
    first = [pattern for pattern in patterns() if pattern.expression.startswith("^")]
    rest = [p for p in patterns() if p not in first and p.parts != ("blank",)]
    lines = [
        f'{_CONTEXT}"step" lineEndContext="#stay" fallthrough="true" fallthroughContext="rest">',
        '        <DetectSpaces attribute="blank"/>',
        *(_rule(p, "rest") for p in rest if p.parts == ("comment",)),
        *(_rule(p, "#stay" if p.parts == ("label",) else "rest") for p in first),
        "      </context>",
        f'{_CONTEXT}"rest" lineEndContext="#pop">',
        '        <DetectSpaces attribute="blank"/>',
        *(_rule(pattern, "#stay") for pattern in rest),
        "      </context>",
        "    </contexts>",
        "    <itemDatas>",
        '      <itemData name="blank" defStyleNum="dsNormal"/>',
        *(f'      <itemData name="{part}" defStyleNum="ds{s}"/>' for part, s in _STYLES.items()),
    ]
    return _HEAD + "".join(f"{line}\n" for line in lines) + _TAIL


def _rule(pattern: Pattern, context: str) -> str:
    """Return a rule; blanks and label before the first word of a line are matched by others."""
    expression = pattern.expression.removeprefix(LABEL).removeprefix("^").removeprefix("[ \\t]*")
    known = f'attribute="{pattern.parts[-1]}" context="{context}"'
    return f'        <RegExpr {known} String={quoteattr(expression)} insensitive="true"/>'


if __name__ == "__main__":
    sys.stdout.write(definition())
