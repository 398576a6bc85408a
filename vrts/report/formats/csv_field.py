"""Texts as fields of comma-separated tables that people open in spreadsheets."""

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n")  # what a spreadsheet takes for more than text
FULL_WIDTH = ("＝", "＋", "－", "＠")  # some read them as the narrow ones
QUOTED = '",;\t\r\n'
TEXT_MARK = "'"  # in front of a field: what follows is text


def text_field(text: str) -> str:
    """Return a foreign text as one field [RFC 4180] that no spreadsheet takes for a formula.

    Numbers are written without this, so that -1.5 stays a number.
    """
    if text.lstrip(" ").startswith((*FORMULA, *FULL_WIDTH)):
        text = TEXT_MARK + text
    if any(character in text for character in QUOTED):
        return '"' + text.replace('"', '""') + '"'
    return text
