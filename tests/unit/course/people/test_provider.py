"""Log-in by a real provider of OpenID Connect on loopback, and what is refused."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.support_course import came_in, course_folder
from tests.support_live import LiveServer
from tests.support_provider import FOUND, ProviderServer, Visitor, free_port, went_there

needs_provider = pytest.mark.skipif(not FOUND, reason="Glewlwyd is not installed")

LOGIN = """
[login]
issuer = "{issuer}"
client = "vrts"
secret = "{secret}"
name = "Log in with the school"
"""


class Both(NamedTuple):
    """A server and its provider."""

    server: LiveServer
    provider: ProviderServer

    @property
    def address(self) -> str:
        return f"http://{self.server.host}"


@pytest.fixture(scope="module")
def both(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Both]:
    folder, port = tmp_path_factory.mktemp("provider"), free_port()
    back = f"http://127.0.0.1:{port}/course/login/back"
    with ProviderServer(folder / "provider", (back,)) as provider:
        secret = folder / "secret"
        secret.write_text(f"{provider.secret}\n")
        secret.chmod(0o600)
        login = LOGIN.format(issuer=provider.issuer, secret=secret)
        course = course_folder(folder / "course", guests=False, more=login)
        for user, verified in (("ada", True), ("cy", True), ("eve", True), ("di", False)):
            provider.person(user, f"{user}@example.org", verified=verified)
        with LiveServer(folder / "live", scenes=(str(course),), port=str(port)) as server:
            yield Both(server, provider)


def came(both: Both, user: str) -> tuple[int, str, Visitor]:
    """Log in by the provider; return the status of the last answer, what it says, the browser."""
    visitor = Visitor()
    both.provider.logged_in(user, visitor)
    status, _, said = visitor.ask(went_there(visitor, both.address))
    return status, said.decode(), visitor


def me(both: Both, visitor: Visitor) -> dict[str, object] | None:
    status, _, said = visitor.ask(f"{both.address}/me")
    return json.loads(said) if status == 200 else None


@pytest.mark.thorough
@needs_provider
def test_who_is_on_the_list_comes_in_with_their_role(both: Both) -> None:
    door = both.server.request("GET", "/door").json
    assert door == {"guests": False, "title": "Robotics", "provider": "Log in with the school"}
    status, said, visitor = came(both, "ada")
    assert (status, "You are Ada Lind." in said) == (200, True), said
    found = me(both, visitor)
    assert found is not None
    assert (found["name"], found["supervisor"]) == ("Ada Lind", True)
    status, said, _ = came(both, "ada")  # known by the subject from now on
    assert status == 200
    status, said, student = came(both, "cy")
    assert (me(both, student) or {})["supervisor"] is False


@pytest.mark.thorough
@needs_provider
def test_strangers_and_addresses_that_are_not_verified_are_refused_in_words(both: Both) -> None:
    status, said, visitor = came(both, "eve")
    assert (status, "not on the list" in said) == (403, True)
    assert me(both, visitor) is None
    status, said, visitor = came(both, "di")
    assert (status, "has not made sure of your e-mail address" in said) == (403, True), said
    assert me(both, visitor) is None


@needs_provider
def test_an_answer_counts_once_and_in_the_browser_that_asked(both: Both) -> None:
    visitor = Visitor()
    both.provider.logged_in("ada", visitor)
    back = went_there(visitor, both.address)
    other = Visitor()
    status, _, said = other.ask(back)
    assert (status, b"has not begun to log in" in said) == (403, True)
    started = Visitor()
    both.provider.logged_in("cy", started)
    went_there(started, both.address)
    status, _, said = started.ask(back)  # another's answer in a browser that has begun too
    assert (status, b"belongs to another log-in" in said) == (403, True)
    kept = dict(visitor.cookies[both.server.host])
    assert visitor.ask(back)[0] == 200
    visitor.cookies[both.server.host] = kept
    status, _, said = visitor.ask(back)
    assert (status, b"was used before" in said) == (403, True)


@needs_provider
def test_a_provider_that_is_down_leaves_the_other_ways(both: Both) -> None:
    visitor = Visitor()
    both.provider.logged_in("ada", visitor)
    back = went_there(visitor, both.address)
    both.provider.process.terminate()
    both.provider.process.wait(30.0)
    status, _, said = visitor.ask(back)
    assert (status, b"does not answer now" in said) == (503, True), said
    assert came_in(both.server, "Di Ek")


@pytest.mark.thorough
def test_without_a_provider_the_server_begins_no_connection(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Audited(LiveServer):
        module = "tests.audited_server"

    connections = tmp_path / "connections"
    monkeypatch.setenv("CONNECTIONS", str(connections))
    course = course_folder(tmp_path / "course")
    with Audited(tmp_path / "live", scenes=(str(course),), measured=True) as server:
        cookie = came_in(server, "Ada Lind")
        server.join(cookie).wait("snapshot")
        for path in ("/course/login", "/course/login/back?code=x&state=y"):
            answer = server.request("GET", path)
            assert (answer.status, b"no log-in elsewhere" in answer.body) == (404, True)
    assert connections.read_text() == ""
