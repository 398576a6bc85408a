"""The manual's table of keys has the keys that the page knows, and no others with Alt."""

import re

from tests.places import ROOT

LIVE = ROOT / "vrts" / "web" / "live"
PAGE = (ROOT / "vrts" / "manual" / "learn" / "browser.md").read_text("utf-8")
TABLE = PAGE.partition("\n## Keys\n")[2]


def source(*names: str) -> str:
    return "\n".join((LIVE / name).read_text("utf-8") for name in names)


def told(keys: list[tuple[str, str]]) -> None:
    """Require that each key stands in the table with what it does."""
    rows = [[cell.strip() for cell in row.split("|")] for row in TABLE.splitlines() if "|" in row]
    for key, does in keys:
        row = next((row for row in rows if key in (row[2], *row[2].split(", "))), [""] * 4)
        assert does in row[3], (key, does)


def test_no_key_is_told_twice_in_one_place() -> None:
    seen: dict[str, list[str]] = {}
    place = ""
    for line in TABLE.partition("\n\nNothing needs")[0].splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) < 5 or cells[1].startswith("---"):
            continue
        place = cells[1] or place
        seen.setdefault(place, []).extend(cells[2].split(", "))
    assert "rehearsal" in seen
    for place, keys in seen.items():
        twice = sorted({key for key in keys if keys.count(key) > 1})
        assert not twice, (place, twice)


def test_every_key_with_alt_is_told_and_there_is_no_other() -> None:
    everything = "\n".join(path.read_text("utf-8") for path in sorted(LIVE.rglob("*.js")))
    known = set(re.findall(r"\bKey([A-Z])\b", everything))
    assert len(known) > 6
    assert set(re.findall(r"(?<!Shift\+)Alt\+([A-Z])\b", TABLE)) == known


def test_the_keys_of_the_editor_are_told_with_the_words_of_the_page() -> None:
    listed = re.search(r"^const KEYS = \[\n(.*?)^\];", source("editor/workbench.js"), re.M | re.S)
    assert listed is not None
    keys = re.findall(r'\["([^"]+)", "([^"]+)"\]', listed[1])
    assert len(keys) > 6
    told(keys)


def test_the_keys_of_a_rehearsal_are_told_with_the_words_of_the_page() -> None:
    bar = source("rehearsal/bar.js")
    steps = re.findall(r'^  \["\w+", "([^"]+)", "([^"]+)", "M', bar, re.M)
    assert len(steps) > 5
    told([(key, text.lower()) for text, key in steps])
    told(re.findall(r'\["((?:F\d|Ctrl)[^"]*)", "([^"]+)"\]', bar))


def test_the_keys_of_the_pendant_and_the_views_are_told() -> None:
    for name in ("PLUS", "MINUS"):
        letters = re.search(rf'^const {name} = "(\w+)"', source("panels/pendant.js"), re.M)
        assert letters is not None
        assert f"| {' '.join(letters[1])} |" in TABLE
    views = re.findall(r'(\d): "(\w+)"', source("panels/views.js"))
    names = [str(view).capitalize() for _, view in views]
    words = ", ".join("Follow hand" if name == "Hand" else name for name in names)
    assert f"| 1 to {len(views)} | {words} |" in TABLE
