"""`python -m vrts.live.nursery`: started by the server, not by hand."""

import signal
import socket
import sys

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's
    from vrts.live.nursery.forking import serve

    with socket.socket(fileno=sys.stdin.fileno()) as line:
        sys.exit(serve(line))
