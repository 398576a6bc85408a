"""What one process may use. The engine's own limits decide marks; these only protect the others."""

import math
import os
import sys
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

STATE_S = 0.01  # [s] of processor for a state of a future: 30 times what is usual [assumed]
EXECUTION_S = 1.0  # [s] for a changed program: 50 times what is usual [assumed]
STATE_BYTES = 40_000  # four times what is usual [assumed]
GROUP = Path("/proc/self/autogroup")  # of Linux


@dataclass(frozen=True, slots=True)
class Limits:
    """Of one process. Far beyond what the engine's own limits let any program need."""

    cpu_s: int = 120
    wall_s: float = 300.0
    memory: int = 1_500_000_000  # bytes in use beyond what it begins with
    file: int = 64_000_000  # bytes of any file it writes
    files: int = 256  # open at once
    answer: int = 8_000_000  # bytes of its answer
    niceness: int = 0  # beyond its parent's: what may be late to what may not
    among_all: int = 0  # the same to all other sessions of Linux, for which nobody waits


def for_mending(limits: Limits, executions: int) -> Limits:
    """Return what a process may use that executes so many changed programs, too."""
    longer = executions * EXECUTION_S
    return replace(
        limits, cpu_s=limits.cpu_s + math.ceil(longer), wall_s=limits.wall_s + 2.0 * longer
    )


def for_states(states: int) -> Limits:
    """Return what a process may use that looks at so many states of futures, too."""
    usual = Limits()
    longer = states * STATE_S
    return replace(
        usual,
        cpu_s=usual.cpu_s + math.ceil(longer),
        wall_s=usual.wall_s + 2.0 * longer,
        memory=usual.memory + states * STATE_BYTES,
    )


def impose(limits: Limits) -> None:
    """Limit this process, for good, where the system can; the parent watches it besides.

    Memory is limited as data, beyond what is reserved already, and not as address space:
    libraries reserve far more than they use. The parent looks at what is really in use.
    """
    if sys.platform == "win32":
        return  # no such limits there: the watching parent is all there is
    import resource  # Windows has none

    os.nice(limits.niceness)
    _give_way(limits.among_all)
    memory = _reserved() + limits.memory
    bounds = (
        (resource.RLIMIT_CPU, limits.cpu_s, limits.cpu_s + 2),  # a signal first, which tells why
        (resource.RLIMIT_DATA, memory, memory),
        (resource.RLIMIT_FSIZE, limits.file, limits.file),
        (resource.RLIMIT_NOFILE, limits.files, limits.files),
        (resource.RLIMIT_CORE, 0, 0),
    )
    for kind, soft, most in bounds:
        _, hard = resource.getrlimit(kind)
        top = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(kind, (min(soft, top), top))


def for_the_next(cpu_s: int) -> None:
    """Have the system end this process when it uses so much more of the processor from now on [s].

    The limit of before is given up; the one that `impose` has set for good stays.
    """
    if sys.platform == "win32":
        return  # as for `impose`
    import resource  # Windows has none

    used = resource.getrusage(resource.RUSAGE_SELF)
    _, hard = resource.getrlimit(resource.RLIMIT_CPU)
    soft = int(used.ru_utime + used.ru_stime) + cpu_s + 1
    top = soft if hard == resource.RLIM_INFINITY else min(soft, hard)
    resource.setrlimit(resource.RLIMIT_CPU, (top, hard))


def _give_way(niceness: int) -> None:
    """Let others have the processor first, those of other sessions too, for good.

    Where Linux groups processes by session, niceness counts within a group only, so it is the group
    of a process with a session of its own that has to have it.
    """
    if niceness and os.getsid(0) == os.getpid():
        with suppress(OSError):  # there are no groups, or another one was set a moment ago
            GROUP.write_text(str(niceness))


def _reserved() -> int:
    """Return the bytes that the system counts as data of this process now."""
    status = Path("/proc/self/status")
    if not status.is_file():
        return 0
    found = [line for line in status.read_text().splitlines() if line.startswith("VmData:")]
    return int(found[0].split()[1]) * 1024 if found else 0
