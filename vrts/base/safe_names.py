"""Names that are safe as file names on every system."""

import re
import unicodedata

LONGEST_ID = 100  # bytes
RESERVED = frozenset(  # names of devices on Windows, whatever their ending
    (
        "CON",
        "PRN",
        "AUX",
        "NUL",
        *(f"{device}{n}" for device in ("COM", "LPT") for n in "123456789"),
    )
)


def safe(name: str) -> str:
    """Return a name that is safe as a file name on every system.

    Letters of every script stay, with their marks; what is reserved on Windows gets a line.
    """
    plain = unicodedata.normalize("NFC", name)
    kept = re.sub(r"-+", "-", "".join(c if _harmless(c) else "-" for c in plain)).strip("-.")
    short = kept.encode()[:LONGEST_ID].decode(errors="ignore").strip("-.")
    if short.split(".")[0].upper() in RESERVED:
        short = f"_{short}"
    return short or "submission"


def _harmless(character: str) -> bool:
    return character in "_.-" or unicodedata.category(character)[0] in "LMN"
