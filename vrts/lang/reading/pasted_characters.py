"""Characters that word processors put in, reported once for the whole file."""

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.reading.characters import (
    BLANKS,
    INVISIBLE,
    LOOK_ALIKES,
    OPENING_QUOTES,
    SINGLE_QUOTES,
)

PASTED_CHARACTER = Rule("V108", "pasted-character")


def report_pasted_characters(problems: Problems) -> None:
    """Report all look-alikes of the file by kind: pasting is one cause however many it left."""
    kinds: dict[str, list[int]] = {}
    for character, at in problems.look_alikes:
        kinds.setdefault(_kind(character), []).append(at)
    for kind, places in kinds.items():
        first = places[0]
        character = problems.source.text[first]
        entry = LOOK_ALIKES[character]
        lines = sorted({problems.span(at, at).line for at in places[1:]})
        more = ""
        if len(places) > 1:
            shown = ", ".join(str(n) for n in lines[:8]) + (" ..." if len(lines) > 8 else "")
            count = len(places) - 1
            more = f"{count} more {'place' if count == 1 else 'places'}, in " + (
                f"line {shown}" if len(lines) == 1 else f"lines {shown}"
            )
        shown_character = f"`{character}` is " if character.isprintable() else ""
        problems.error(
            PASTED_CHARACTER,
            f"{shown_character}{entry.name}" if shown_character else f"here is {entry.name}",
            first,
            first + 1,
            _instead(entry.replacement),
            notes=(
                "word processors and web pages put such characters in when text is copied",
                *((more,) if more else ()),
            ),
            help=(_remedy(kind, entry.replacement),),
            fix=problems.replace(first, first + 1, entry.replacement),
            data={"places": len(places)},
        )


def _kind(character: str) -> str:
    if character in OPENING_QUOTES:
        return "quotes"
    if character in SINGLE_QUOTES:
        return "apostrophes"
    if character in BLANKS:
        return "blanks"
    if character in INVISIBLE:
        return "invisible"
    return character


def _instead(replacement: str) -> str:
    if replacement == " ":
        return "a plain blank belongs here"
    return f"`{replacement}` belongs here" if replacement else "nothing belongs here"


def _remedy(kind: str, replacement: str) -> str:
    match kind:
        case "quotes":
            return 'replace every curly quote by the straight `"` of the keyboard'
        case "blanks":
            return "replace it by a blank typed on the keyboard"
        case "invisible":
            return "take it out: delete the characters around it and type them again"
        case _:
            return f"type `{replacement}` instead"
