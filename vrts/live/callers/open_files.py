"""How many files and connections the server's process may have open at once."""

import sys
from typing import Final

WANTED: Final = 16_384  # all connections that there may be, and the files of all sessions


def raise_limit() -> int:
    """Raise the limit as far as that is of use and allowed; return what it is now."""
    if sys.platform == "win32":
        return WANTED  # there is no such limit
    import resource  # Windows has none

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    unlimited = resource.RLIM_INFINITY
    if soft == unlimited or soft >= WANTED:
        return WANTED
    wanted = WANTED if hard == unlimited else min(hard, WANTED)
    try:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
    except (OSError, ValueError):  # the system allows less than it says
        return soft
    return wanted
