"""Limits, names, origins and secrets, one by one."""

import pytest

from vrts.live.front.origin import Names
from vrts.live.limits import Bucket
from vrts.live.names import LONGEST, display_name, readable
from vrts.live.tokens import digest, new_code, new_token


def test_a_bucket_lets_a_burst_through_and_then_its_rate() -> None:
    bucket = Bucket(rate=10.0, burst=5.0)
    assert [bucket.take(100.0) for _ in range(6)] == [True] * 5 + [False]
    assert bucket.take(100.15)
    assert not bucket.take(100.15)
    assert sum(bucket.take(200.0) for _ in range(20)) == 5, "sleeping saves up no more than a burst"


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ("  Anna  Maria ", "Anna Maria"),
        ("Ａｎｎａ", "Anna"),
        ("a\u202eb", "a�b"),
        ("x\x1b[2Jy", "x␛[2Jy"),
        ("n" * 99, "n" * LONGEST),
        ("", ""),
        (" \u200b ", ""),
        ("<b>", "<b>"),
    ],
)
def test_names_of_rooms_are_visible(given: str, shown: str) -> None:
    assert display_name(given) == shown


def test_texts_keep_their_lines_and_nothing_invisible() -> None:
    assert readable("one\ntwo\u2066\x07 ") == "one\ntwo�␇"


@pytest.mark.parametrize(
    ("host", "known"),
    [
        ("127.0.0.1:8000", True),
        ("localhost", True),
        ("[::1]:8000", True),
        ("192.168.1.20:8000", True),
        ("lab.example.org", True),
        ("LAB.example.org.", True),
        ("evil.example", False),
        ("lab.example.org.evil.example", False),
        ("user@localhost", False),
        ("localhost:port", False),
        ("", False),
        ("2130706433.", False),
    ],
)
def test_a_server_answers_to_its_own_names(host: str, known: bool) -> None:
    assert Names(["lab.example.org"]).known(host) is known


@pytest.mark.parametrize(
    ("origin", "own"),
    [
        ("http://127.0.0.1:8000", True),
        ("http://localhost:8000", False),
        ("http://127.0.0.1:8001", False),
        ("https://evil.example", False),
        ("http://127.0.0.1:8000.evil.example", False),
        ("http://evil@127.0.0.1:8000", False),
        ("null", False),
        ("file://", False),
        ("", False),
        ("http://[", False),
    ],
)
def test_only_pages_from_the_host_itself_may_ask(origin: str, own: bool) -> None:
    assert Names([]).own_page(origin, "127.0.0.1:8000") is own


def test_the_usual_port_may_be_left_out() -> None:
    assert Names(["lab.example.org"]).own_page("https://lab.example.org", "lab.example.org:443")


def test_secrets_are_kept_as_digests_and_codes_read_in_any_case() -> None:
    code = new_code(9)
    assert digest(code) == digest(f" {code[:3].lower()}-{code[3:].lower()} ")
    token = new_token()
    assert digest(token) != digest(token.swapcase())
    assert token.encode() not in digest(token)
