"""Which browser asks: a secret in a cookie that stays when somebody logs out.

What a supervisor does about somebody, such as muting them, holds for their browser. The cookie says
nothing about anybody, lets nobody in, and is kept as a digest only.
"""

from typing import Final

from starlette.responses import Response

from vrts.live.settings import Settings
from vrts.live.tokens import digest, new_token

KEPT_S: Final = 180 * 86_400  # a term
LONGEST: Final = 128  # characters of a token


def browsers_of(cookies: dict[str, str], settings: Settings) -> frozenset[bytes]:
    """Return what a browser is known by: its cookie, and that of who is logged in."""
    tokens = (cookies.get(name, "") for name in (_name(settings), settings.cookie))
    return frozenset(digest(token) for token in tokens if 0 < len(token) <= LONGEST)


def browser_token(cookies: dict[str, str], settings: Settings) -> str:
    """Return the secret of a browser, a new one where it has none."""
    token = cookies.get(_name(settings), "")
    return token if 0 < len(token) <= LONGEST else new_token()


def keep_browser(answer: Response, token: str, settings: Settings) -> None:
    """Have a browser keep its secret."""
    answer.set_cookie(
        _name(settings),
        token,
        max_age=KEPT_S,
        path="/",
        secure=settings.secure,
        httponly=True,
        samesite="strict",
    )


def _name(settings: Settings) -> str:
    return f"{settings.cookie}_browser"
