"""Marks one session in a process that was started for it, where processes are not forked."""

from vrts.live.logs.session_marker import SessionMarker
from vrts.marking.submission.alone import main

if __name__ == "__main__":
    main(SessionMarker)
