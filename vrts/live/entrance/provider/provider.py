"""A provider: where it is, which keys it has, and who comes back from it."""

import asyncio
import hmac
from collections import OrderedDict
from typing import Any, Final, NamedTuple

from vrts.live.entrance.provider.checking import Expected, NotTrusted, UnknownKey, claims_of
from vrts.live.entrance.provider.going_out import NoAnswer, Session
from vrts.live.entrance.provider.memory import LASTS_S, Memory, new_trip
from vrts.live.entrance.provider.settings import ProviderSettings, read_secret, wrong_with
from vrts.live.lasting.clock import steady, wall

FRESH_S: Final = 3600.0  # how long what a provider says of itself is believed
AGAIN_S: Final = 5.0  # after which one that did not answer is asked again
NEW_KEYS_S: Final = 60.0  # after which keys are fetched again because of one that is not known
ALL_S: Final = 15.0  # for everything that one log-in asks of the provider
USED: Final = 10_000  # ways that have come back, and are not taken twice


class ProviderDown(Exception):  # noqa: N818 -- names the situation
    """The provider does not answer, or not as one does."""


class Identity(NamedTuple):
    """Who somebody is for the provider."""

    subject: str  # issuer and subject: what never changes
    known_by: str  # the claim by which people are known at first, in lower case; empty: not told
    verified: bool  # whether the provider has made sure of it


class Provider:
    """One provider."""

    def __init__(self, settings: ProviderSettings, redirect: str) -> None:
        """Know where it is; nothing is asked before somebody logs in.

        Args:
            settings: What the course says of it.
            redirect: Address to which browsers come back.
        """
        self.settings = settings
        self._redirect = redirect
        self._memory = Memory()
        self._about: dict[str, Any] = {}
        self._about_until = 0.0
        self._down_until = 0.0
        self._keys: dict[str, Any] = {}
        self._keys_at = 0.0
        self._used: OrderedDict[str, float] = OrderedDict()
        self._asking = asyncio.Lock()

    async def begin(self) -> tuple[str, str]:
        """Return the address to which a browser goes, and what its cookie remembers.

        Raises:
            ProviderDown: It does not answer.
        """
        about = await self._known()
        trip = new_trip(wall())
        async with self._session() as session:
            url = session.address(about["authorization_endpoint"], trip)
        return url, self._memory.sealed(trip)

    async def finish(self, asked: dict[str, str], cookie: str) -> Identity:
        """Return who has come back.

        Args:
            asked: Parameters of the address with which the browser came back.
            cookie: What it remembered.

        Raises:
            ProviderDown: The provider does not answer.
            NotTrusted: What came back is not what was asked for.
        """
        now = wall()
        trip = self._memory.opened(cookie, now)
        if trip is None:
            raise NotTrusted("this browser has not begun to log in, or it took too long")
        if not hmac.compare_digest(asked.get("state", "").encode(), trip.state.encode()):
            raise NotTrusted("the answer belongs to another log-in")
        if trip.state in self._used:
            raise NotTrusted("this answer was used before")
        if asked.get("iss", self.settings.issuer) != self.settings.issuer:
            raise NotTrusted("the answer is of another provider")
        if "error" in asked or not asked.get("code"):
            raise NotTrusted("the provider did not let you in")
        self._use(trip.state, now)
        try:
            async with asyncio.timeout(ALL_S):
                return await self._exchanged(asked["code"], trip.nonce, trip.verifier)
        except TimeoutError as problem:
            raise ProviderDown("it takes too long to answer") from problem

    async def _exchanged(self, code: str, nonce: str, verifier: str) -> Identity:
        about, settings = await self._known(), self.settings
        try:
            secret = await asyncio.to_thread(read_secret, settings.secret)
        except (OSError, ValueError) as problem:
            raise ProviderDown("the file with the secret cannot be read") from problem
        async with self._session(secret, about) as session:
            try:
                told = await session.token(about["token_endpoint"], code, verifier)
                id_token, access = told.get("id_token"), told.get("access_token")
                if not isinstance(id_token, str) or not isinstance(access, str):
                    raise NotTrusted("the provider gave out no ID token")
                expected = Expected(settings.issuer, settings.client, nonce, access)
                claims = await self._checked(id_token, expected)
                if settings.claim not in claims and about.get("userinfo_endpoint"):
                    more = await session.object(about["userinfo_endpoint"], withhold_token=False)
                    if more.get("sub") == claims["sub"]:  # it may be of another else
                        claims = {**more, **claims}
            except NoAnswer as problem:
                raise ProviderDown(str(problem)) from problem
        known = claims.get(settings.claim)
        known_by = known.strip().casefold() if isinstance(known, str) else ""
        verified = claims.get("email_verified") is True or settings.claim != "email"
        return Identity(f"{settings.issuer} {claims['sub']}", known_by, verified)

    async def _checked(self, token: str, expected: Expected) -> dict[str, Any]:
        try:
            return claims_of(token, await self._key_set(), expected, wall())
        except UnknownKey as problem:
            if steady() - self._keys_at < NEW_KEYS_S:
                raise NotTrusted("the token is signed with a key of nobody's") from problem
            self._keys = {}
        try:
            return claims_of(token, await self._key_set(), expected, wall())
        except UnknownKey as problem:
            raise NotTrusted("the token is signed with a key of nobody's") from problem

    async def _known(self) -> dict[str, Any]:
        """Return what the provider says of itself."""
        async with self._asking:
            now = steady()
            if self._about and now < self._about_until:
                return self._about
            if now < self._down_until:
                raise ProviderDown("it did not answer a moment ago")
            try:
                issuer = self.settings.issuer
                where = f"{issuer.rstrip('/')}/.well-known/openid-configuration"
                about = await self._fetched(where)
                if about.get("issuer") != issuer:
                    raise ProviderDown(f"it calls itself `{about.get('issuer')}`")
                for name in ("authorization_endpoint", "token_endpoint", "jwks_uri"):
                    _may_be_asked(about.get(name), name)
                if "userinfo_endpoint" in about:
                    _may_be_asked(about["userinfo_endpoint"], "userinfo_endpoint")
            except ProviderDown:
                self._down_until = steady() + AGAIN_S
                raise
            self._about, self._about_until = about, steady() + FRESH_S
            return about

    async def _key_set(self) -> dict[str, Any]:
        if not self._keys or steady() - self._keys_at > FRESH_S:
            about = await self._known()
            self._keys = await self._fetched(about["jwks_uri"])
            self._keys_at = steady()
        return self._keys

    async def _fetched(self, url: str) -> dict[str, Any]:
        """Return the object that an address of the provider answers with."""
        try:
            async with asyncio.timeout(ALL_S), self._session() as session:
                return await session.object(url)
        except (NoAnswer, TimeoutError) as problem:
            raise ProviderDown(str(problem) or "it takes too long to answer") from problem

    def _session(self, secret: str = "", about: dict[str, Any] | None = None) -> Session:
        settings = self.settings
        supported: object = (about or {}).get("token_endpoint_auth_methods_supported")
        basic = not isinstance(supported, list) or "client_secret_basic" in supported
        method = "client_secret_basic" if basic else "client_secret_post"
        more = "" if settings.claim == "email" else " profile"  # no more than is needed
        return Session(
            settings.client,
            secret,
            self._redirect,
            scope=f"openid email{more}",
            method=method if secret else "none",
        )

    def _use(self, state: str, now: float) -> None:
        self._used[state] = now
        while len(self._used) > USED or now - next(iter(self._used.values())) > LASTS_S:
            self._used.popitem(last=False)


def _may_be_asked(address: object, what: str) -> None:
    """Make sure that an address that a provider names is a safe one.

    Raises:
        ProviderDown: It is not.
    """
    why = wrong_with(address.partition("?")[0]) if isinstance(address, str) else "it has none"
    if why:
        raise ProviderDown(f"its `{what}` cannot be used: {why}")
