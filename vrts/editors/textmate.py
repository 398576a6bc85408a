"""VAL-II for TextMate grammars, so for VS Code and its kin.

`python -m vrts.editors.textmate` prints the grammar; it is kept in `val2.tmLanguage.json`.
"""

import json
import sys

from vrts.editors.patterns import Pattern, patterns

SCOPE = "source.val2"
_SCOPES = {
    "comment": "comment.line.semicolon",
    "section": "keyword.other.section",
    "string": "string.quoted.double",
    "character": "constant.character",
    "label": "entity.name.tag.label",
    "structure": "keyword.control",
    "instruction": "keyword.other.instruction",
    "qualifier": "keyword.other.qualifier",
    "number": "constant.numeric",
    "format": "constant.other.format",
    "function": "support.function",
    "constant": "constant.language",
    "word operator": "keyword.operator.word",
    "string variable": "variable.other.string",
    "precision point": "variable.other.joints",
    "name": "variable.other",
    "operator": "keyword.operator",
    "punctuation": "punctuation.separator",
}


def grammar() -> dict[str, object]:
    """Return the grammar."""
    return {
        "name": "VAL-II",
        "scopeName": SCOPE,
        "fileTypes": ["v2", "pg", "lc"],
        "patterns": [_rule(pattern) for pattern in patterns() if pattern.parts != ("blank",)],
    }


def grammar_text() -> str:
    """Return the grammar as the text of its file."""
    return json.dumps(grammar(), indent=2) + "\n"


def _rule(pattern: Pattern) -> dict[str, object]:
    match = f"(?i){pattern.expression}"
    if len(pattern.parts) == 1:
        return {"name": _scope(pattern.parts[0]), "match": match}
    captures = {
        str(number): {"name": _scope(part)}
        for number, part in enumerate(pattern.parts, 1)
        if part != "blank"
    }
    return {"match": match, "captures": captures}


def _scope(part: str) -> str:
    return f"{_SCOPES[part]}.val2"


if __name__ == "__main__":
    sys.stdout.write(grammar_text())
