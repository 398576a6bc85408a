"""The section `[login]` of `course.toml`: log-in by a provider of OpenID Connect."""

from pathlib import Path
from typing import Final

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.live.entrance.provider.settings import (
    BUTTON,
    ProviderSettings,
    wrong_with,
    wrong_with_secret,
)

LOGIN: Final = Rule("V915", "log-in-provider")
LONGEST_BUTTON: Final = 80  # characters


def read_login(top: Table, problems: Problems, folder: Path) -> ProviderSettings | None:
    """Return the provider of a course; None: there is none, or the section has errors."""
    table = top.table("login")
    if table is None:
        return None
    issuer = table.string("issuer", required=True) or ""
    client = table.string("client", required=True) or ""
    secret = table.string("secret")
    claim = table.string("claim") or "email"
    button = table.string("name") or BUTTON
    table.finish()
    if issuer and (why := wrong_with(issuer)):
        problems.error(LOGIN, f"`{issuer}` cannot be asked: {why}", table.value_span("issuer"))
    path = None if secret is None else (folder / Path(secret).expanduser())
    if path is not None and (why := wrong_with_secret(path, folder)):
        text = f"`{secret}` cannot hold the secret: {why}"
        problems.error(LOGIN, text, table.value_span("secret"))
    if len(button) > LONGEST_BUTTON:
        text = f"a button has at most {LONGEST_BUTTON} characters"
        problems.error(LOGIN, text, table.value_span("name"))
    return ProviderSettings(issuer, client, path, claim, button)
