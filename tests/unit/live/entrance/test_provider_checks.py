"""What an ID token has to be: every part of it altered once, with keys of our own."""

import base64
import time
from pathlib import Path
from typing import Any

import pytest
from joserfc import jwt
from joserfc.jwk import ECKey, KeySet, OctKey

from vrts.live.entrance.provider.checking import (
    Expected,
    NotTrusted,
    UnknownKey,
    claims_of,
)
from vrts.live.entrance.provider.memory import LASTS_S, Memory, new_trip
from vrts.live.entrance.provider.settings import wrong_with, wrong_with_secret

NOW = time.time()
ISSUER = "https://id.example.org"
EXPECTED = Expected(ISSUER, "vrts", "a nonce")
KEY = ECKey.generate_key("P-256", {"kid": "one"})
KEYS = KeySet([KEY]).as_dict(private=False)
GOOD: dict[str, Any] = {
    "iss": ISSUER,
    "aud": "vrts",
    "sub": "42",
    "exp": int(NOW) + 300,
    "iat": int(NOW),
    "nonce": "a nonce",
}


def token(key: Any = KEY, kid: str = "one", alg: str = "ES256", **changed: Any) -> str:
    claims = {name: value for name, value in (GOOD | changed).items() if value is not None}
    return jwt.encode({"alg": alg, "kid": kid}, claims, key, algorithms=[alg])


def test_a_good_token_is_read() -> None:
    assert claims_of(token(), dict(KEYS), EXPECTED, NOW)["sub"] == "42"
    assert claims_of(token(aud=["vrts"]), dict(KEYS), EXPECTED, NOW)["sub"] == "42"


@pytest.mark.parametrize(
    "changed",
    [
        {"nonce": "another"},
        {"nonce": None},
        {"iss": "https://evil.example"},
        {"iss": None},
        {"aud": "another"},
        {"aud": None},
        {"aud": ["vrts", "another"], "azp": "another"},
        {"exp": int(NOW) - 300},
        {"exp": None},
        {"iat": int(NOW) + 3000},
        {"sub": None},
        {"sub": 42},
    ],
)
def test_a_token_for_something_else_is_refused(changed: dict[str, Any]) -> None:
    with pytest.raises(NotTrusted):
        claims_of(token(**changed), dict(KEYS), EXPECTED, NOW)


def test_signatures_of_others_and_altered_ones_are_refused() -> None:
    other = ECKey.generate_key("P-256", {"kid": "one"})
    with pytest.raises(NotTrusted):
        claims_of(token(other), dict(KEYS), EXPECTED, NOW)
    with pytest.raises(UnknownKey):
        claims_of(token(ECKey.generate_key("P-256"), "two"), dict(KEYS), EXPECTED, NOW)
    head, body, sign = token().split(".")
    elsewhere = token(sub="1").split(".")[1]
    for altered in (f"{head}.{elsewhere}.{sign}", f"{head}.{body}.", f"{head}.{body}", "", "x"):
        with pytest.raises((NotTrusted, UnknownKey)):
            claims_of(altered, dict(KEYS), EXPECTED, NOW)
    # neither without a signature, nor with what everybody knows as the secret
    bare = base64.urlsafe_b64encode(b'{"alg":"none"}').decode().rstrip("=")
    none = f"{bare}.{body}."
    known = OctKey.import_key("x" * 32)
    for unsigned in (none, token(known, alg="HS256")):
        with pytest.raises((NotTrusted, UnknownKey)):
            claims_of(unsigned, dict(KEYS), EXPECTED, NOW)


def test_a_browser_remembers_its_own_way_for_ten_minutes() -> None:
    memory, trip = Memory(), new_trip(NOW)
    cookie = memory.sealed(trip)
    assert memory.opened(cookie, NOW + 1.0) == trip
    assert memory.opened(cookie, NOW + LASTS_S) is None
    assert memory.opened(cookie, NOW - 1.0) is None
    assert Memory().opened(cookie, NOW + 1.0) is None
    forged = Memory().sealed(new_trip(NOW)).partition(".")[0]
    for altered in ("", ".", "x.y", f"{forged}.{cookie.partition('.')[2]}", f"é{cookie}"):
        assert memory.opened(altered, NOW + 1.0) is None, altered


@pytest.mark.parametrize(
    ("address", "good"),
    [
        ("https://id.example.org", True),
        ("https://id.example.org/realms/school", True),
        ("http://127.0.0.1:8080/x", True),
        ("http://localhost:8080", True),
        ("http://id.example.org", False),
        ("http://127.0.0.1.evil.example", False),
        ("https://user:word@id.example.org", False),
        ("https://id.example.org?x", False),
        ("https://", False),
        ("file:///etc/passwd", False),
        ("https://[", False),
    ],
)
def test_a_provider_is_asked_by_https_except_on_this_machine(address: str, good: bool) -> None:
    assert (wrong_with(address) == "") is good


def test_a_secret_lies_elsewhere_and_is_the_owners_alone(tmp_path: Path) -> None:
    course, secret = tmp_path / "course", tmp_path / "secret"
    course.mkdir()
    assert wrong_with_secret(secret, course) == "there is no such file"
    secret.write_text("x")
    secret.chmod(0o640)
    assert "others may read it" in wrong_with_secret(secret, course)
    secret.chmod(0o600)
    assert wrong_with_secret(secret, course) == ""
    assert "folder of the course" in wrong_with_secret(course / "secret", course)
