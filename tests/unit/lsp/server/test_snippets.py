"""Arguments by name, as places to fill in, where a client says that it takes such snippets."""

from pathlib import Path
from typing import Any

import pytest

from tests.support_lsp import Client

TEXT = """.PROGRAM main()
 SET p = TRA
 CALL twi
 x = TIME(3)
.END
.PROGRAM twice(a, b, $c)
.END
"""
PLACES = ((1, 12), (2, 9))


def offered(folder: Path, editor: str) -> list[dict[str, Any]]:
    with Client(folder, editor=editor) as client:
        client.open("a.v2", TEXT)
        lists = [client.about("completion", "a.v2", at)["items"] for at in PLACES]
        lists.append(client.about("completion", "a.v2", (3, 9))["items"])
    wanted = ("TRANS", "twice", "TIMER")
    return [
        next(item for item in items if item["label"] == label)
        for items, label in zip(lists, wanted, strict=True)
    ]


@pytest.mark.parametrize(
    ("editor", "texts"),
    [
        (
            "visual-studio-code",
            [
                "TRANS(${1:x}, ${2:y}, ${3:z}, ${4:o}, ${5:a}, ${6:t})",
                "twice(${1:a}, ${2:b}, ${3:\\$c})",
                "TIMER",  # its parentheses are there already
            ],
        ),
        ("emacs@v29.1", ["TRANS", "twice", "TIMER"]),
    ],
)
def test_arguments_are_places_to_fill_in(tmp_path: Path, editor: str, texts: list[str]) -> None:
    found = offered(tmp_path, editor)
    assert [item["textEdit"]["newText"] for item in found] == texts
    assert [item.get("insertTextFormat", 1) for item in found] == [1 + ("$" in t) for t in texts]
