"""A reverse proxy that does TLS, as small as one can be: it passes `Host` and WebSockets on."""

import socket
import ssl
import subprocess
import threading
from contextlib import ExitStack, suppress
from pathlib import Path
from types import TracebackType


def certificate(folder: Path, name: str) -> tuple[Path, Path]:
    """Make a certificate for a name; return its file and that of its key."""
    certificate, key = folder / "cert.pem", folder / "key.pem"
    words = f"req -x509 -newkey rsa:2048 -nodes -subj /CN={name} -days 2"
    words += f" -addext subjectAltName=DNS:{name} -keyout {key} -out {certificate}"
    subprocess.run(["openssl", *words.split()], check=True, capture_output=True)
    return certificate, key


class TlsProxy:
    """Takes TLS connections and passes them on to a port of this machine in the clear.

    It adds to the head of the first request of a connection from where that came, as proxies do.
    """

    def __init__(self, folder: Path, name: str) -> None:
        self.certificate, key = certificate(folder, name)
        self._context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self._context.load_cert_chain(self.certificate, key)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = int(self._listener.getsockname()[1])
        self.target = 0
        self.client = "192.0.2.1"  # from where connections seem to come
        self._links = ExitStack()
        threading.Thread(target=self._accept, daemon=True).start()

    def __enter__(self) -> "TlsProxy":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._links.close()

    def _accept(self) -> None:
        while True:
            try:
                plain, _ = self._listener.accept()
            except OSError:
                return  # closed
            threading.Thread(target=self._serve, args=(plain, self.client), daemon=True).start()

    def _serve(self, plain: socket.socket, client: str) -> None:
        outside = self._links.enter_context(self._context.wrap_socket(plain, server_side=True))
        inside = self._links.enter_context(socket.create_connection(("127.0.0.1", self.target)))
        outside.settimeout(30.0)
        head = b""
        while b"\r\n\r\n" not in head:
            data = outside.recv(1 << 16)
            if not data:
                return
            head += data
        first, rest = head.split(b"\r\n", 1)
        added = f"X-Forwarded-For: {client}\r\nX-Forwarded-Proto: https\r\n".encode()
        lines = rest.split(b"\r\n")
        known = [n for n, line in enumerate(lines) if line.lower().startswith(b"x-forwarded-for:")]
        if known:  # what the client says itself comes first
            lines[known[0]] += b", " + client.encode()
            added = b"X-Forwarded-Proto: https\r\n"
        inside.sendall(first + b"\r\n" + added + b"\r\n".join(lines))
        threading.Thread(target=_pass_on, args=(inside, outside), daemon=True).start()
        _pass_on(outside, inside)


def _pass_on(source: socket.socket, sink: socket.socket) -> None:
    with suppress(OSError):  # one end is gone
        while data := source.recv(1 << 16):
            sink.sendall(data)
    with suppress(OSError):
        sink.shutdown(socket.SHUT_RDWR)
