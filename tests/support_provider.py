"""Glewlwyd, a real provider of OpenID Connect, on loopback; and a browser that only has cookies."""

import http.client
import http.cookies
import json
import re
import secrets
import shutil
import socket
import sqlite3
import subprocess
import threading
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Final
from urllib.parse import parse_qs, urlsplit

from cryptography.hazmat.primitives import serialization
from cryptography.hazmat.primitives.asymmetric import ec

TABLES: Final = Path("/usr/share/dbconfig-common/data/glewlwyd/install/sqlite3")
SETTINGS: Final = Path("/etc/glewlwyd/glewlwyd.conf")
FOUND: Final = shutil.which("glewlwyd") is not None and TABLES.is_file()
CLIENT: Final = "vrts"
PASSWORD: Final = "a password of the provider"
PLUGIN: Final = "oidc"


class Visitor:
    """Goes from address to address, as a browser does, with cookies of each host and port."""

    def __init__(self) -> None:
        self.cookies: dict[str, dict[str, str]] = {}

    def ask(
        self, url: str, body: Any = None, method: str = "", **headers: str
    ) -> tuple[int, dict[str, str], bytes]:
        """Return status, headers and body of one answer; no redirect is followed."""
        parts = urlsplit(url)
        jar = self.cookies.setdefault(parts.netloc, {})
        sent = {"cookie": "; ".join(f"{k}={v}" for k, v in jar.items())} | headers
        data = None
        if body is not None:
            data, sent["content-type"] = json.dumps(body).encode(), "application/json"
        link = http.client.HTTPConnection(parts.netloc, timeout=60.0)
        try:
            path = parts.path + (f"?{parts.query}" if parts.query else "")
            link.request(method or ("GET" if body is None else "POST"), path, data, sent)
            answer = link.getresponse()
            for line in answer.headers.get_all("set-cookie") or ():
                for name, morsel in http.cookies.SimpleCookie(line).items():
                    jar[name] = morsel.value
            return answer.status, dict(answer.headers.items()), answer.read()
        finally:
            link.close()


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class ProviderServer:
    """The provider, with people of its own."""

    def __init__(self, folder: Path, redirects: tuple[str, ...]) -> None:
        folder.mkdir(exist_ok=True)
        self.port = free_port()
        self.address = f"http://127.0.0.1:{self.port}"
        self.issuer = f"{self.address}/api/{PLUGIN}"
        self.secret = secrets.token_urlsafe(24)
        database = folder / "provider.sqlite"
        connection = sqlite3.connect(database)
        connection.executescript(TABLES.read_text())
        (kept,) = connection.execute(
            "SELECT gumi_parameters FROM g_user_module_instance"
        ).fetchone()
        parameters = json.loads(kept)
        parameters["data-format"]["verified"] = {"multiple": False, "read": True, "write": True}
        connection.execute(
            "UPDATE g_user_module_instance SET gumi_parameters=?", (json.dumps(parameters),)
        )
        connection.commit()
        connection.close()
        text = SETTINGS.read_text()
        for key, value in {
            "port": str(self.port),
            "external_url": f'"{self.address}"',
            "log_mode": '"console"',
        }.items():
            text = re.sub(rf"(?m)^{key}=.*$", f"{key}={value}", text)
        kept = f'database = {{ type = "sqlite3"; path = "{database}"; }};\nbind_address="127.0.0.1"'
        text = re.sub(r"(?m)^@include.*$", kept, text)
        (folder / "provider.conf").write_text(text)
        self.process = subprocess.Popen(
            ["glewlwyd", f"--config-file={folder / 'provider.conf'}"],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        assert self.process.stdout is not None
        said: list[str] = []
        for line in self.process.stdout:
            said.append(line)
            if "started on port" in line:
                break
        else:
            raise AssertionError("".join(said))
        self._reading = threading.Thread(target=self.process.stdout.read)
        self._reading.start()
        self.admin = Visitor()
        try:
            self._begin(redirects)
        except BaseException:
            self.__exit__(None, None, None)
            raise

    def _begin(self, redirects: tuple[str, ...]) -> None:
        until = time.monotonic() + 30.0
        while True:  # it says that it has started just before it listens
            try:
                socket.create_connection(("127.0.0.1", self.port), 5.0).close()
                break
            except ConnectionRefusedError:
                assert time.monotonic() < until, "the provider does not listen"
                time.sleep(0.02)
        self._do("POST", "auth/", {"username": "admin", "password": "password"})
        self._do("POST", "mod/plugin", _plugin(self.issuer))
        self._do("POST", "scope", {"name": "email", "display_name": "email"})
        self._do(
            "POST",
            "client",
            {
                "client_id": CLIENT,
                "name": CLIENT,
                "confidential": True,
                "password": self.secret,
                "enabled": True,
                "redirect_uri": list(redirects),
                "authorization_type": ["code"],
                "scope": ["openid"],
                "token_endpoint_auth_method": ["client_secret_basic"],
            },
        )

    def person(self, user: str, email: str, *, verified: bool = True) -> None:
        """Add somebody."""
        told = {
            "username": user,
            "name": user,
            "email": email,
            "password": PASSWORD,
            "enabled": True,
            "scope": ["openid", "email"],
            "verified": "yes" if verified else "no",
        }
        self._do("POST", "user", told)

    def logged_in(self, user: str, visitor: Visitor) -> None:
        """Have somebody log in at the provider, and let the server know who they are."""
        body = {"username": user, "password": PASSWORD}
        status, _, said = visitor.ask(f"{self.address}/api/auth/", body)
        assert status == 200, said
        grant = {"scope": "openid email"}
        status, _, said = visitor.ask(f"{self.address}/api/auth/grant/{CLIENT}", grant, "PUT")
        assert status == 200, said

    def _do(self, method: str, path: str, body: Any) -> None:
        status, _, said = self.admin.ask(f"{self.address}/api/{path}", body, method)
        assert status == 200, (path, status, said)

    def __enter__(self) -> "ProviderServer":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.process.terminate()
        self.process.wait(30.0)
        self._reading.join()
        assert self.process.stdout is not None
        self.process.stdout.close()


def _plugin(issuer: str) -> dict[str, Any]:
    key = ec.generate_private_key(ec.SECP256R1())
    private = key.private_bytes(
        serialization.Encoding.PEM,
        serialization.PrivateFormat.PKCS8,
        serialization.NoEncryption(),
    )
    public = key.public_key().public_bytes(
        serialization.Encoding.PEM, serialization.PublicFormat.SubjectPublicKeyInfo
    )
    return {
        "module": "oidc",
        "name": PLUGIN,
        "display_name": PLUGIN,
        "enabled": True,
        "parameters": {
            "iss": issuer,
            "jwt-type": "ecdsa",
            "jwt-key-size": "256",
            "key": private.decode(),
            "cert": public.decode(),
            "auth-type-code-enabled": True,
            "auth-type-code-revoke-replayed": True,
            "oauth-as-iss-id": True,
            "allow-non-oidc": False,
            "pkce-allowed": True,
            "pkce-required": True,
            "jwks-show": True,
            "email-claim": "mandatory",
            "claims": [
                {
                    "name": "email_verified",
                    "user-property": "verified",
                    "type": "boolean",
                    "boolean-value-true": "yes",
                    "boolean-value-false": "no",
                    "mandatory": True,
                }
            ],
        },
    }


def went_there(visitor: Visitor, server: str) -> str:
    """Begin to log in at a server; return the address to which the provider leads back."""
    status, headers, said = visitor.ask(f"{server}/course/login")
    assert status == 303, (status, said)
    status, headers, said = visitor.ask(headers["location"])
    assert status == 302, (status, said)
    asked = parse_qs(urlsplit(headers["Location"]).query)  # of the page that asks to go on
    status, headers, said = visitor.ask(f"{asked['callback_url'][0]}&g_continue")
    assert status == 302, (status, said)
    return headers["Location"]
