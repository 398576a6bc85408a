"""A unit for systemd that runs a server: started with the machine and after a crash, fenced in."""

from collections.abc import Sequence
from pathlib import Path
from typing import Final, NamedTuple

USER: Final = "vrts"
PLACE: Final = "/etc/systemd/system/vrts-live.service"
STATE: Final = "vrts-state"  # below /var/lib
PRIVILEGED: Final = 1024  # the ports below need a capability
_HOMES: Final = ("/home", "/root", "/run/user")
_PASSING: Final = ("/tmp", "/var/tmp")  # noqa: S108 -- where nothing is kept


class Service(NamedTuple):
    """What is to be run; all paths are absolute."""

    command: tuple[str, ...]  # program and arguments
    writes: tuple[Path, ...]  # folders in which it writes
    reads: tuple[Path, ...]  # files and folders that it reads
    port: int
    own_key: bool = True  # the key of the logs is the user's usual one


def unit(service: Service) -> str:
    """Return the unit as text, with where to put it and what to do once, in comments."""
    command = " ".join(map(_quoted, service.command))
    places = (Path(service.command[0]), *service.writes, *service.reads)
    homes = _below(places, _HOMES)
    passing = _below(places, _PASSING)
    own_key = int(service.own_key)
    bind = service.port < PRIVILEGED and service.port > 0
    written = "\n".join(f"ReadWritePaths={_path(folder)}" for folder in service.writes)
    folders = " ".join(map(_shell, map(str, service.writes)))
    lines = [
        f"# Put this into {PLACE}, then, as root:",
        f"#   useradd --system --no-create-home --shell /usr/sbin/nologin {USER}",
        f"#   mkdir -p {folders} && chown -R {USER}: {folders}",
        "#   systemctl daemon-reload && systemctl enable --now vrts-live",
        "# The ways in stand in its journal: journalctl -u vrts-live",
        *(f"# User {USER} must be able to read {path}, which is in a home." for path in homes),
        *(
            f"# {path} goes when the machine starts again: choose another place."
            for path in passing
        ),
        "",
        "[Unit]",
        "Description=vrts: a virtual robot that a class shares in the browser",
        "Wants=network-online.target",
        "After=network-online.target",
        "StartLimitIntervalSec=300",
        "StartLimitBurst=10",
        "",
        "[Service]",
        f"ExecStart={command}",
        f"User={USER}",
        f"Group={USER}",
        f"WorkingDirectory={str(service.writes[0]).replace('%', '%%')}",  # read without quotes
        "Environment=PYTHONUNBUFFERED=1",
        # the key that signs the logs lies outside of the folder that it guards
        *([f"StateDirectory={STATE}", f"Environment=XDG_STATE_HOME=/var/lib/{STATE}"] * own_key),
        "Restart=on-failure",
        "RestartSec=2",
        "SuccessExitStatus=130",
        "KillMode=mixed",
        "TimeoutStopSec=20",
        "UMask=0077",
        "",
        "# It may use most of the machine, and leaves it alive.",
        "MemoryHigh=60%",
        "MemoryMax=75%",
        "TasksMax=1024",
        "LimitNOFILE=16384",
        "OOMPolicy=continue",
        "",
        "# It sees nothing that it does not need.",
        "NoNewPrivileges=yes",
        "ProtectSystem=strict",
        written,
        f"ProtectHome={'read-only' if homes else 'yes'}",
        f"PrivateTmp={'no' if passing else 'yes'}",
        "PrivateDevices=yes",
        "ProtectClock=yes",
        "ProtectControlGroups=yes",
        "ProtectHostname=yes",
        "ProtectKernelLogs=yes",
        "ProtectKernelModules=yes",
        "ProtectKernelTunables=yes",
        "ProtectProc=invisible",
        "RestrictAddressFamilies=AF_INET AF_INET6 AF_UNIX",
        "RestrictNamespaces=yes",
        "RestrictRealtime=yes",
        "RestrictSUIDSGID=yes",
        "LockPersonality=yes",
        "SystemCallArchitectures=native",
        "SystemCallFilter=@system-service",
        f"CapabilityBoundingSet={'CAP_NET_BIND_SERVICE' if bind else ''}",
        *(["AmbientCapabilities=CAP_NET_BIND_SERVICE"] if bind else []),
        "",
        "[Install]",
        "WantedBy=multi-user.target",
    ]
    return "\n".join(lines) + "\n"


def _below(places: Sequence[Path], tops: Sequence[str]) -> list[Path]:
    return sorted({place for place in places if any(place.is_relative_to(top) for top in tops)})


def _quoted(word: str) -> str:
    """Return a word of a command line as systemd reads it back."""
    word = word.replace("\\", "\\\\").replace("%", "%%").replace("$", "$$")
    if not word or any(c.isspace() or c in "\"';" for c in word):
        word = '"' + word.replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'
    return word


def _path(path: Path) -> str:
    """Return a path as systemd reads it back where one is expected."""
    text = str(path).replace("%", "%%")
    return f'"{text}"' if " " in text else text


def _shell(word: str) -> str:
    return "'" + word.replace("'", "'\\''") + "'" if not word.isascii() or " " in word else word
