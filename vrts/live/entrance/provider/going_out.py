"""The door to the network: a client that begins no connection but to a provider, with limits.

No redirect is followed, no proxy of the environment is used, an answer has only so many bytes, and
all of it has to come within a few seconds.
"""

import contextlib
from collections.abc import AsyncIterator, Generator
from typing import Any, Final

import httpx2
import msgspec
from authlib.common.errors import AuthlibBaseError
from authlib.integrations.httpx_client import AsyncOAuth2Client

from vrts.live.entrance.provider.checking import NotTrusted
from vrts.live.entrance.provider.memory import Trip

LARGEST: Final = 256 * 1024  # bytes of an answer
TIMEOUT_S: Final = 8.0  # for each step of a request
_HEADERS: Final = {"accept": "application/json", "accept-encoding": "identity"}


class NoAnswer(Exception):  # noqa: N818 -- names the situation
    """The provider does not answer, or not as one does."""


class TooLarge(Exception):  # noqa: N818 -- names the situation
    """An answer has more bytes than any of a provider needs."""


class _Counted(httpx2.AsyncByteStream):
    """Passes on what comes, and ends where it is too much."""

    def __init__(self, stream: httpx2.AsyncByteStream) -> None:
        self._stream = stream

    async def __aiter__(self) -> AsyncIterator[bytes]:
        length = 0
        async for part in self._stream:
            length += len(part)
            if length > LARGEST:
                raise TooLarge(f"an answer has more than {LARGEST} bytes")
            yield part

    async def aclose(self) -> None:
        await self._stream.aclose()


class _Limited(httpx2.AsyncHTTPTransport):
    """Carries requests; what comes back is counted."""

    async def handle_async_request(self, request: httpx2.Request) -> httpx2.Response:
        """Ask, and count what is answered."""
        answer = await super().handle_async_request(request)
        assert isinstance(answer.stream, httpx2.AsyncByteStream), "of an asynchronous client"
        return httpx2.Response(
            answer.status_code,
            headers=answer.headers,
            stream=_Counted(answer.stream),
            extensions=answer.extensions,
        )


class Session:
    """What is asked of a provider in one go."""

    def __init__(
        self, id_: str, secret: str, redirect: str, *, scope: str, method: str = "none"
    ) -> None:
        """Begin; nothing is asked yet.

        Args:
            id_: What the provider calls this server.
            secret: That proves it; empty: none is wanted.
            redirect: Address to which browsers come back.
            scope: What it is asked to tell of people.
            method: How the secret is shown to the provider, in the words of OpenID Connect.
        """
        make: Any = AsyncOAuth2Client
        self._client: Any = make(
            id_,
            secret or None,
            token_endpoint_auth_method=method,
            scope=scope,
            redirect_uri=redirect,
            code_challenge_method="S256",
            transport=_Limited(retries=0),
            timeout=httpx2.Timeout(TIMEOUT_S),
            follow_redirects=False,
            trust_env=False,
            headers=_HEADERS,
        )

    async def __aenter__(self) -> "Session":
        """Begin."""
        return self

    async def __aexit__(self, *_: object) -> None:
        """End its connections."""
        await self._client.aclose()

    def address(self, endpoint: str, trip: Trip) -> str:
        """Return the address to which a browser goes."""
        url, _ = self._client.create_authorization_url(
            endpoint, state=trip.state, nonce=trip.nonce, code_verifier=trip.verifier
        )
        return str(url)

    async def object(self, url: str, *, withhold_token: bool = True) -> dict[str, Any]:
        """Return the object that an address answers with.

        Raises:
            NoAnswer: There is none.
        """
        with _as_no_answer():
            answer = await self._client.request("GET", url, withhold_token=withhold_token)
            if answer.status_code != httpx2.codes.OK:
                raise NoAnswer(f"it answers {answer.status_code}")
            return msgspec.json.decode(answer.content, type=dict[str, Any])

    async def token(self, endpoint: str, code: str, verifier: str) -> dict[str, Any]:
        """Return what the provider gives out for a code.

        Raises:
            NoAnswer: There is none.
            NotTrusted: It does not take the code.
        """
        with _as_no_answer():
            try:
                told = await self._client.fetch_token(
                    endpoint,
                    grant_type="authorization_code",
                    code=code,
                    code_verifier=verifier,
                )
            except AuthlibBaseError as problem:
                raise NotTrusted(f"the provider refuses the log-in: {problem.error}") from problem
        return dict(told)


@contextlib.contextmanager
def _as_no_answer() -> Generator[None]:
    try:
        yield
    except (httpx2.HTTPError, httpx2.InvalidURL, TooLarge, ValueError, TimeoutError) as problem:
        raise NoAnswer(str(problem) or type(problem).__name__) from problem
    except AuthlibBaseError as problem:
        raise NoAnswer(str(problem)) from problem
