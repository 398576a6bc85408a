"""`vrts` that writes every connection it begins to the file that `CONNECTIONS` names."""

import os
import sys
from typing import Any

from vrts.cli.main import main

_file = os.open(os.environ["CONNECTIONS"], os.O_CREAT | os.O_WRONLY | os.O_APPEND, 0o600)


def _told(event: str, given: tuple[Any, ...]) -> None:
    if event == "socket.connect" and isinstance(given[1], tuple):
        os.write(_file, f"connect {given[1][0]}:{given[1][1]}\n".encode())
    elif event == "socket.getaddrinfo":
        os.write(_file, f"name {given[0]}\n".encode())
    elif event == "import" and str(given[0]).partition(".")[0] in ("authlib", "httpx2", "joserfc"):
        os.write(_file, f"import {given[0]}\n".encode())


if __name__ == "__main__":
    sys.addaudithook(_told)
    main()
