"""`python -m vrts.live.session`: started by the server, not by hand."""

import signal
import sys

from vrts.live.session.process import serve

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's: it ends its sessions
    sys.exit(serve(sys.stdin.fileno(), sys.stdout.fileno()))
