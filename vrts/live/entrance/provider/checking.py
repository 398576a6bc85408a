"""Whether an ID token is what it says: signature, issuer, audience, time and nonce."""

from typing import Any, Final, NamedTuple

from authlib.oidc.core import CodeIDToken
from joserfc import jwt
from joserfc.errors import InvalidKeyIdError, JoseError
from joserfc.jwk import KeySet

# none that a public key would be the secret of, and never "none"
ALGORITHMS: Final = (
    *("RS256", "RS384", "RS512", "PS256", "PS384", "PS512"),
    *("ES256", "ES384", "ES512", "EdDSA"),
)
LEEWAY_S: Final = 60  # that clocks may differ


class Expected(NamedTuple):
    """What a token has to be for."""

    issuer: str
    client: str
    nonce: str
    access_token: str = ""


class UnknownKey(Exception):  # noqa: N818 -- names the situation
    """A token is signed with a key that the provider has not shown: it may be a new one."""


class NotTrusted(Exception):  # noqa: N818 -- names the situation
    """What came back is not what was asked for."""


def claims_of(token: str, keys: dict[str, Any], expected: Expected, now: float) -> dict[str, Any]:
    """Return what an ID token says, once all of it has been checked.

    Args:
        token: As the provider gave it out.
        keys: Public keys of the provider: a JWKS.
        expected: What it has to be for.
        now: Unix time [s].

    Raises:
        UnknownKey: It names a key that is not there.
        NotTrusted: It is not what it should be.
    """
    make: Any = CodeIDToken
    key_set: Any = keys
    options = {
        "iss": {"essential": True, "value": expected.issuer},
        "aud": {"essential": True, "value": expected.client},
    }
    params = {
        "nonce": expected.nonce,
        "client_id": expected.client,
        "access_token": expected.access_token,
    }
    try:
        decoded = jwt.decode(token, KeySet.import_key_set(key_set), algorithms=list(ALGORITHMS))
        checked: Any = make(decoded.claims, decoded.header, options, params)
        checked.validate(int(now), LEEWAY_S)
    except InvalidKeyIdError as problem:
        raise UnknownKey(str(problem)) from problem
    except (JoseError, ValueError, TypeError, KeyError) as problem:
        raise NotTrusted(f"the provider's answer is not to be trusted: {problem}") from problem
    claims: dict[str, Any] = dict(checked)
    if not isinstance(claims.get("sub"), str) or not claims["sub"]:
        raise NotTrusted("the provider does not say whom it means")
    return claims
