"""A feature in words, for a person to read: what both programs do, say or hold."""

from collections.abc import Sequence

from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.report.plain import one_line

LONGEST = 220  # characters of a sentence

_DEEDS = {
    "Move joint": "MOVE",
    "Move linear": "MOVES",
    "Move joint above": "APPRO",
    "Move linear above": "APPROS",
    "Depart joint": "DEPART",
    "Depart linear": "DEPARTS",
    "Assign": "assign",
    "JumpIf False": "while or if",
    "JumpIf True": "until or if",
    "Signal": "SIGNAL",
    "Wait": "WAIT",
    "Delay": "DELAY",
    "MoveHand open True": "OPENI",
    "MoveHand close True": "CLOSEI",
    "MoveHand open False": "OPEN",
    "MoveHand close False": "CLOSE",
}


def words_of(feature: Feature) -> str:
    """Return a feature in words."""
    tell = {
        Channel.MOTION: _motion,
        Channel.STEPS: _steps,
        Channel.NUMBERS: _numbers,
        Channel.WORDS: _habits,
        Channel.TEXT: _text,
        Channel.OFFSETS: _offsets,
        Channel.MANNER: _manner,
        Channel.LINES: _line,
    }
    said = one_line(tell[feature.channel](feature.kind, feature.key))
    return said if len(said) <= LONGEST else f"{said[: LONGEST - 1]}…"


def _motion(kind: str, key: tuple[object, ...]) -> str:
    match kind, key:
        case "place", (thing, x, y, z, *_):
            return f"the tool stops at the same point, {_vector((x, y, z))} mm from `{thing}`"
        case "near", (thing, *_):
            return f"the tool stops within a few millimetres of the same point beside `{thing}`"
        case "world", _:
            return "the tool stops within a few millimetres of the same point in space"
        case "height", (thing, held, *_):
            what = " with something in the hand" if held else ""
            return f"the tool stops at the same height beside `{thing}`{what}"
        case "axis", _:
            return "the hand has the same unusual direction"
        case "stretch", (straight, held, *_):
            how = "straight " if straight else ""
            what = " with something in the hand" if held else ""
            return f"the tool moves {how}by the same distance in the same direction{what}"
        case "turn", _:
            return "two motions in a row by the same distances in the same directions"
        case "across", _:
            return "two motions in a row that together lead equally far"
        case _:
            return "the same motion"


def _steps(kind: str, key: tuple[object, ...]) -> str:
    if kind == "step":
        return f"a step of the same form: {_step(str(key[0]))}"
    if kind == "exact":
        return f"the same step with the same numbers: {_step(str(key[0]))}"
    return _in_a_row(key)


def _in_a_row(key: tuple[object, ...]) -> str:
    texts = [_step(str(one)) for one in key if isinstance(one, str)]
    return f"the same {len(texts)} steps in a row, whatever stands between: {', '.join(texts)}"


def _manner(kind: str, key: tuple[object, ...]) -> str:
    match kind, key:
        case "manner", (straight, speed, length, hand, *_):
            how = "straight line" if straight else "motion"
            then = f", then the hand is told to {hand}" if hand else ""
            return f"a {how} of about {_number(length, 10)} mm at {speed} %{then}"
        case "deeds", _:
            return "four motions in a row to the same things, with the same orders to the hand"
        case "speed", (step, speed, *_):
            return f"{_step(str(step))} at speed {_speed(str(speed))}"
        case "hand", _:
            return _hand(key)
        case "two hands", _:
            return f"{_hand(key)}; the same at the next order to the hand"
        case _:
            return _in_a_row(key)


def _hand(key: tuple[object, ...]) -> str:
    """Return how the hand comes, is told, and leaves."""
    come, told, waits, away, *_ = key
    parts = [_step(str(one)) for one in (come, told) if one]
    if waits:
        parts.append(f"a wait of {_number(waits)} s")
    parts += [_step(str(away))] if away else []
    return f"the same around the hand, whatever stands between: {', '.join(parts)}"


def _numbers(kind: str, key: tuple[object, ...]) -> str:
    match kind:
        case "value":
            return f"the same taught value to 0.01: {_vector(key)}"
        case "near":
            return "taught values that are within a few millimetres of each other"
        case "turn":
            return "taught values with nearly the same unusual direction"
        case "apart":
            return "two taught values that lie equally far apart, in the same direction"
        case "number":
            return f"the same number in {_step(str(key[0]))}: {_number(key[1])}"
        case "about":
            return f"nearly the same number in {_step(str(key[0]))}"
        case _:
            names = [_step(one) for one in key if isinstance(one, str)]
            return f"nearly the same numbers in a row: in {', '.join(names)}"


def _offsets(_kind: str, key: tuple[object, ...]) -> str:
    axis, by = key
    along = "xyz"[axis] if isinstance(axis, int) and 0 <= axis < 3 else str(axis)
    return f"two taught values that lie exactly {_number(by)} mm apart along {along}"


def _text(_kind: str, _key: tuple[object, ...]) -> str:
    return "the same steps, word for word, except names and numbers"


def _line(_kind: str, key: tuple[object, ...]) -> str:
    return f"the same line, whatever its numbers: `{key[0]}`"


def _habits(kind: str, key: tuple[object, ...]) -> str:
    if kind == "name":
        return f"the name `{key[0]}`"
    if kind in ("layout", "layouts", "all layout"):
        if kind == "layout":
            return f"the same layout: {key[0]}"
        return "the same layout in many ways" if kind == "all layout" else "the same layout"
    where = "a comment" if kind.startswith("comment") else "a text"
    if kind.endswith("whole"):
        return f"{where} with the same words: “{key[0]}”"
    if kind.endswith("words"):
        return f"“{key[0]} {key[1]}” in {where}"
    return f"the word “{key[0]}” in {where}"


def _step(shape: str) -> str:
    """Return the form of a step as programmers know it."""
    head, _, rest = shape.partition("(")
    inside = rest.rpartition(")")[0]
    head, _, said = head.partition(" at ")
    name = next((deed for known, deed in _DEEDS.items() if known == head.rstrip()), head)
    parts = [part for part in inside.split(";") if part not in ("", "-")]
    speed = f" at {_speed(said)}" if said else ""
    return f"{name} {', '.join(parts)}".strip() + speed


def _speed(text: str) -> str:
    return text.replace("percent", " %").replace("mm/s", " mm/s")


def _vector(numbers: Sequence[object]) -> str:
    return "(" + ", ".join(_number(one) for one in numbers) + ")"


def _number(value: object, factor: int = 1) -> str:
    return f"{value * factor:g}" if isinstance(value, int | float) else str(value)
