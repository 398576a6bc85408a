"""The server as a process: the socket it listens at, the words it begins with, uvicorn."""

import errno
import ipaddress
import socket
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import uvicorn

from vrts.live.callers.open_files import raise_limit
from vrts.live.callers.patient import PatientProtocol
from vrts.live.callers.pieces import InPieces
from vrts.live.door import DoorProtocol
from vrts.live.entrance.by_hand import supervisor_link, working_code
from vrts.live.front.added import Adding
from vrts.live.front.app import application
from vrts.live.front.hop import Hop
from vrts.live.lasting.clock import wall
from vrts.live.lasting.folder_lock import held, holder
from vrts.live.protocol.fields import LONGEST_MESSAGE
from vrts.live.settings import DATABASE, Settings
from vrts.live.store.database import opened
from vrts.live.store.unusable import in_one_sentence, require_whole
from vrts.live.tokens import grouped
from vrts.pipeline.files import CannotRead


class Listening(NamedTuple):
    """Where and how to listen."""

    host: str = "127.0.0.1"
    port: int = 8000  # 0: any that is free
    certificate: Path | None = None  # TLS, with its key
    key: Path | None = None
    proxy: bool = False  # a proxy on this machine does TLS


class Entrances(NamedTuple):
    """How people come in."""

    address: str
    supervisor: str  # token, once
    code: str  # empty: none


def serve(
    settings: Settings,
    listening: Listening,
    rooms: tuple[str, ...],
    say: Callable[[str], None],
    *,
    with_code: bool = True,
    open_link: Callable[[str], None] | None = None,
    adding: Adding | None = None,
) -> None:
    """Serve until interrupted.

    Args:
        settings: What to serve; port and TLS are taken from `listening`.
        listening: Where.
        rooms: Names of the rooms to begin with.
        say: Writes a line of words, `--quiet` or not: nobody comes in without them.
        with_code: Whether there is a class code.
        open_link: Takes the supervisor's link, which lets one browser in, once.
        adding: Makes what another part of vrts adds, such as a course.

    Raises:
        CannotRead: The port cannot be had, another server works in the folder, or its database is
            of no use.
        OSError: The folder cannot be written.
    """
    listener = _listener(listening, settings.folder)
    settings.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    database = settings.folder / DATABASE
    with listener, held(settings.folder), in_one_sentence(database):
        require_whole(database)
        _serve(
            listener,
            settings,
            listening,
            rooms,
            say,
            with_code=with_code,
            open_link=open_link,
            adding=adding,
        )


def _serve(
    listener: socket.socket,
    settings: Settings,
    listening: Listening,
    rooms: tuple[str, ...],
    say: Callable[[str], None],
    *,
    with_code: bool,
    open_link: Callable[[str], None] | None,
    adding: Adding | None,
) -> None:
    port = int(listener.getsockname()[1])
    secure = listening.certificate is not None or listening.proxy
    settings = replace(settings, port=port, secure=secure, names=(*settings.names, listening.host))
    entrances = _entrances(settings, listening, port, with_code=with_code)
    public = [name for name in settings.names if name != listening.host]
    hop = Hop(public, say) if listening.proxy else None
    app = application(
        settings, entrances.address, rooms, with_code=with_code, hop=hop, adding=adding
    )
    for line in greeting(settings, listening, entrances):
        say(line)
    if open_link is not None:
        open_link(f"{entrances.address}/#enter={entrances.supervisor}")
    PatientProtocol.most = raise_limit() // 2  # the others are for WebSockets and sessions
    config = uvicorn.Config(
        InPieces(app),
        http=PatientProtocol,
        ws=DoorProtocol,
        ws_max_size=LONGEST_MESSAGE,
        ws_ping_interval=20.0,
        ws_ping_timeout=20.0,
        ws_per_message_deflate=False,
        lifespan="on",
        log_config=None,
        access_log=False,
        server_header=False,
        date_header=False,  # `Guard` tells the time
        proxy_headers=False,  # `front/hop` reads them
        timeout_graceful_shutdown=5,
        ssl_certfile=listening.certificate,
        ssl_keyfile=listening.key,
    )
    uvicorn.Server(config).run(sockets=[listener])


def _listener(listening: Listening, folder: Path) -> socket.socket:
    """Return the socket that is listened at.

    Raises:
        CannotRead: It cannot be had.
    """
    host, port = listening.host, listening.port
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=2048)
    except OSError as problem:
        if problem.errno == errno.EADDRINUSE:
            number = holder(folder)
            who = "another program" if number is None else f"the server of `{folder}`"
            own = "" if number is None else f" (process {number})"
            hint = "end it, or choose another port: `--port 0` takes any that is free"
            raise CannotRead(f"{who}{own} listens at port {port} already", (hint,)) from problem
        reason = (problem.strerror or str(problem)).partition(" (while")[0].lower()
        hint = "ports below 1024 are for root: choose another with `--port`"
        hints = (hint,) if problem.errno == errno.EACCES else ()
        raise CannotRead(f"cannot listen at {host}, port {port}: {reason}", hints) from problem


def greeting(settings: Settings, listening: Listening, entrances: Entrances) -> list[str]:
    """Return the words the server begins with: the ways in, and what is exposed."""
    lines = [
        f"serving {', '.join(place.id for place in settings.places)} at {entrances.address}",
        f"supervisor, once: {entrances.address}/#enter={entrances.supervisor}",
    ]
    if entrances.code:
        lines.append(
            f"class code: {grouped(entrances.code)}, or {entrances.address}/#enter={entrances.code}"
        )
    lines.append(f"kept in {settings.folder}")
    if is_loopback(listening.host):
        lines.append("only this machine can reach it; `--host 0.0.0.0` opens it to the network")
        return lines
    lines.append(f"EXPOSED: whoever reaches this machine's port {settings.port} gets the page")
    if not settings.secure:
        lines.append(
            "EXPOSED: without TLS everybody on the way can read and change what is sent,"
            " passwords too; see `--tls-cert`"
        )
    return lines


def is_loopback(host: str) -> bool:
    """Return whether only this machine can reach an address."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _is_any(host: str) -> bool:
    """Return whether an address stands for all of this machine."""
    try:
        return ipaddress.ip_address(host).is_unspecified
    except ValueError:
        return False


def _entrances(
    settings: Settings, listening: Listening, port: int, *, with_code: bool
) -> Entrances:
    now = wall()
    connection = opened(settings.folder / DATABASE)
    try:
        token = supervisor_link(connection, now)
        code = working_code(settings.folder, connection, now, wanted=with_code)
    finally:
        connection.close()
    return Entrances(_address(settings, listening, port), token, code)


def _address(settings: Settings, listening: Listening, port: int) -> str:
    """Return where browsers find the server."""
    scheme = "https" if settings.secure else "http"
    own = [name for name in settings.names if name != listening.host]
    if own:
        name = own[0]
    elif _is_any(listening.host):
        name = _outward()
    else:
        name = f"[{listening.host}]" if ":" in listening.host else listening.host
    usual = listening.proxy or port == (443 if settings.secure else 80)
    return f"{scheme}://{name}" if usual else f"{scheme}://{name}:{port}"


def _outward() -> str:
    """Return the address of this machine in its network; nothing is sent to find out."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))
        except OSError:
            return "127.0.0.1"
        return str(probe.getsockname()[0])
