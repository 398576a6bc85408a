"""VAL-II for Pygments, so for Sphinx, LaTeX and web pages; registered as the lexer `val2`."""

import re
from collections.abc import Sequence
from typing import Any, ClassVar

from pygments import lexer as pygments_lexer
from pygments.lexer import RegexLexer
from pygments.token import (
    Comment,
    Keyword,
    Name,
    Number,
    Operator,
    Punctuation,
    String,
    Text,
    Whitespace,
)

from vrts.editors.patterns import Pattern, patterns

TOKENS = {
    "comment": Comment.Single,
    "section": Keyword.Namespace,
    "string": String.Double,
    "character": String.Char,
    "label": Name.Label,
    "structure": Keyword,
    "instruction": Keyword.Reserved,
    "qualifier": Keyword.Pseudo,
    "number": Number,
    "format": String.Interpol,
    "function": Name.Builtin,
    "constant": Keyword.Constant,
    "word operator": Operator.Word,
    "string variable": Name.Variable,
    "precision point": Name.Variable.Global,
    "name": Name,
    "operator": Operator,
    "punctuation": Punctuation,
    "blank": Whitespace,
}


def _rule(pattern: Pattern) -> tuple[str, Any]:
    if len(pattern.parts) == 1:
        return pattern.expression, TOKENS[pattern.parts[0]]
    by_groups: Any = getattr(pygments_lexer, "bygroups")  # noqa: B009 -- untyped in the stubs
    return pattern.expression, by_groups(*(TOKENS[part] for part in pattern.parts))


class Val2Lexer(RegexLexer):
    """Lexer for VAL-II, the language of Unimation's PUMA robots."""

    name = "VAL-II"
    aliases: ClassVar[Sequence[str]] = ["val2", "val-ii"]
    filenames: ClassVar[Sequence[str]] = ["*.v2", "*.pg", "*.lc"]
    flags = re.IGNORECASE | re.MULTILINE
    tokens: ClassVar[dict[str, list[object]]] = {
        "root": [*map(_rule, patterns()), (r"\n", Whitespace), (r".", Text)]
    }
