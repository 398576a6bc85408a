"""The browser's names of messages are the server's."""

import re
from typing import Any, get_args

import msgspec
import pytest

from vrts.live import actions
from vrts.live.protocol.fields import LONGEST_CHAT, LONGEST_NOTE, VERSION
from vrts.live.protocol.from_clients import FromClient
from vrts.live.protocol.from_server import Control, FromServer
from vrts.live.protocol.listed import Person, WallRow
from vrts.live.session.channel import messages, rows
from vrts.live.session.views import frame
from vrts.web.assets import asset

TEXT = asset("live/protocol.js")
FROM_SESSION = (
    messages.Moved,
    messages.Happened,
    messages.Output,
    messages.Programs,
    messages.Checked,
    messages.Marked,
    messages.Began,
    messages.Done,
    messages.Reached,
    messages.Status,
    messages.Snapshot,
)


def in_browser(name: str) -> dict[str, list[str]]:
    """Return one of the tables of `protocol.js`."""
    body = re.search(rf"export const {name} = \{{(.*?)\n\}};", TEXT, re.DOTALL)
    assert body is not None
    rows = re.findall(r"^  (\w+): \[(.*?)\],$", body[1], re.DOTALL | re.MULTILINE)
    return {kind: re.findall(r'"(\w+)"', fields) for kind, fields in rows}


def at_server(*kinds: Any) -> dict[str, list[str]]:
    """Return the same of message types."""
    return {
        str(kind.__struct_config__.tag): [
            field.encode_name for field in msgspec.structs.fields(kind)
        ]
        for kind in kinds
    }


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("FROM_CLIENT", get_args(FromClient)),
        ("ACTIONS", get_args(actions.Action)),
        ("FROM_SERVER", get_args(FromServer)),
        ("FROM_SESSION", FROM_SESSION),
    ],
)
def test_both_sides_know_the_same_fields(name: str, kinds: tuple[Any, ...]) -> None:
    assert len(kinds) > 5
    assert in_browser(name) == at_server(*kinds)


@pytest.mark.parametrize(
    ("typedef", "kind"),
    [
        ("Person", Person),
        ("WallRow", WallRow),
        ("Control", Control),
        ("Status", messages.Status),
        ("Placed", rows.Placed),
        ("Lost", rows.Lost),
        ("Part", rows.Part),
        ("Marked", messages.Marked),
    ],
)
def test_types_have_the_same_fields(typedef: str, kind: type[msgspec.Struct]) -> None:
    shape = re.search(rf"@typedef \{{\{{([^@]*?)\}}\}} {typedef}\b", TEXT)
    assert shape is not None
    assert set(re.findall(r"(\w+)\??:", shape[1])) == {f.name for f in msgspec.structs.fields(kind)}


def test_versions_limits_and_the_size_of_a_frame_agree() -> None:
    numbers = {name: int(value) for name, value in re.findall(r"const ([A-Z_]+) = ([\d_]+);", TEXT)}
    assert numbers["VERSION"] == VERSION
    assert numbers["LONGEST_PROGRAM"] == actions.LONGEST_PROGRAM
    assert numbers["LONGEST_CHAT"] == LONGEST_CHAT
    assert numbers["LONGEST_NOTE"] == LONGEST_NOTE
    framing = dict(re.findall(r"const ([A-Z]+) = (\d+);", asset("live/frame.js")))
    wanted = {
        "KIND": frame.KIND,
        "VERSION": frame.VERSION,
        "SIZE": frame.LAYOUT.size,
        "RUNNING": frame.RUNNING,
        "MOVING": frame.MOVING,
        "STOPPING": frame.STOPPING,
        "HOLDING": frame.HOLDING,
    }
    assert {name: int(framing[name]) for name in wanted} == wanted


def test_nothing_is_set_as_markup() -> None:
    """Names and texts of others come into the page as text only."""
    from importlib.resources import files

    folder = files("vrts.web").joinpath("live")
    texts = [e.read_text("utf-8") for e in folder.iterdir() if e.name.endswith(".js")]
    for part in ("panels", "pages", "rehearsal"):
        texts += [e.read_text("utf-8") for e in folder.joinpath(part).iterdir()]
    assert len(texts) > 25
    unsafe = re.compile(
        r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function"
    )
    assert [match[0] for text in texts for match in unsafe.finditer(text)] == []
