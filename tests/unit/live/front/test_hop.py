"""From where a request came, behind a proxy: only what the proxy itself wrote is believed."""

from typing import Any

import pytest
from starlette.datastructures import Headers

from vrts.live.front.hop import UNKNOWN, WARNING, Hop

NAME = "lab.example.org"
Pairs = list[tuple[bytes, bytes]]


def came(hop: Hop, *told: str, peer: str = "127.0.0.1", host: str = NAME) -> str:
    raw: Pairs = [(b"host", host.encode()), *((b"x-forwarded-for", t.encode()) for t in told)]
    scope: dict[str, Any] = {"type": "http", "client": (peer, 5), "headers": raw}
    return hop.client(scope, Headers(scope=scope))


@pytest.mark.parametrize(
    ("told", "address"),
    [
        (("198.51.100.7",), "198.51.100.7"),
        (("203.0.113.9, 198.51.100.7",), "198.51.100.7"),
        (("203.0.113.9", "198.51.100.7"), "198.51.100.7"),
        (("203.0.113.9, 127.0.0.1",), "127.0.0.1"),
        (("198.51.100.7:4711",), "198.51.100.7"),
        (("[2001:db8::7]:4711",), "2001:db8::7"),
        (("2001:db8::7",), "2001:db8::7"),
        (("198.51.100.7, nonsense",), UNKNOWN),
        (("",), UNKNOWN),
    ],
)
def test_the_last_entry_counts(told: tuple[str, ...], address: str) -> None:
    assert came(Hop([NAME], pytest.fail), *told) == address


def test_who_goes_past_the_proxy_says_nothing_about_where_it_is() -> None:
    assert came(Hop([NAME], pytest.fail), "203.0.113.9", peer="192.0.2.5") == "192.0.2.5"


def test_a_proxy_that_writes_no_entry_is_found_out_and_said_once() -> None:
    said: list[str] = []
    hop = Hop([NAME], said.append)
    assert came(hop, host="127.0.0.1:8000") == "127.0.0.1", "this machine asks for itself"
    assert came(hop, "203.0.113.9") == "203.0.113.9"
    assert said == []
    assert came(hop, host=f"{NAME}:443") == UNKNOWN
    assert came(hop, "203.0.113.9") == UNKNOWN, "a client wrote that"
    assert came(hop) == UNKNOWN
    assert said == [WARNING]
