"""Characters that word processors and web pages put in place of those of a program."""

from typing import NamedTuple

OPENING_QUOTES = "“”„‟«»＂"
SINGLE_QUOTES = "‘’‚‛´`＇"
BLANKS = "\u00a0\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u3000"
INVISIBLE = "\u200b\u200c\u200d\u2060\ufeff\u00ad"


class LookAlike(NamedTuple):
    """What a character is called, and what stands for it in a program."""

    name: str
    replacement: str


_SIGNS = {
    "–": LookAlike("an en dash", "-"),
    "—": LookAlike("an em dash", "-"),
    "−": LookAlike("a typographic minus sign", "-"),
    "‐": LookAlike("a typographic hyphen", "-"),
    "‑": LookAlike("a typographic hyphen", "-"),
    "×": LookAlike("a multiplication sign", "*"),
    "·": LookAlike("a multiplication dot", "*"),
    "÷": LookAlike("a division sign", "/"),
    "⁄": LookAlike("a fraction slash", "/"),
    "≤": LookAlike("a typographic sign", "<="),
    "≥": LookAlike("a typographic sign", ">="),
    "≠": LookAlike("a typographic sign", "<>"),
    "，": LookAlike("a full-width comma", ","),
    "、": LookAlike("a full-width comma", ","),
    "；": LookAlike("a full-width semicolon", ";"),
    "：": LookAlike("a full-width colon", ":"),
    "（": LookAlike("a full-width parenthesis", "("),
    "）": LookAlike("a full-width parenthesis", ")"),
    "＝": LookAlike("a full-width equals sign", "="),
}

LOOK_ALIKES = {
    **_SIGNS,
    **dict.fromkeys(OPENING_QUOTES, LookAlike("a curly quote", '"')),
    **dict.fromkeys(SINGLE_QUOTES, LookAlike("a typographic apostrophe", "'")),
    **dict.fromkeys(BLANKS, LookAlike("a no-break or wide blank", " ")),
    **dict.fromkeys(INVISIBLE, LookAlike("an invisible character", "")),
}

# Signs of other languages, and what to do instead.
STRANGERS = {
    "%": "leave the percent sign out: SPEED takes percent",
    "{": "programs have no braces: structures end with END",
    "}": "programs have no braces: structures end with END",
    "!": "write `<>` for not equal, and begin comments with `;`",
    "&": "write AND",
    "|": "write OR",
    "~": "write NOT",
    "\\": "begin comments with `;`",
    "?": "begin comments with `;`",
    "@": "begin comments with `;`",
    "_": "names begin with a letter",
    "'": "begin comments with `;`, and put text between double quotes",
    "#": "begin comments with `;`; `#` begins the name of a precision point",
    "$": "`$` begins the name of a string variable",
    "^": "there is no power operator: multiply, or use SQR(x)",
    ".": "write a number as 0.5 or .5",
    ";": "",
}
