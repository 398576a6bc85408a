"""`python -m vrts.live.session`: started by the server, not by hand."""

import sys

from vrts.live.session.process import serve

if __name__ == "__main__":
    sys.exit(serve(sys.stdin.fileno(), sys.stdout.fileno()))
