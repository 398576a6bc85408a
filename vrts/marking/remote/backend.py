"""Where a class is marked: which cluster, and how it is reached."""

import re
from enum import Enum
from typing import NamedTuple

from vrts.pipeline.files import CannotRead

_ADDRESS = re.compile(r"((tcp|tls|ws|wss)://)?(\[[0-9A-Fa-f:.]+\]|[\w.-]+):\d{1,5}")


class Scheduler(Enum):
    """What gives out the work."""

    DASK = "dask"
    SLURM = "slurm"
    HTCONDOR = "htcondor"

    @property
    def has_a_queue(self) -> bool:
        """Whether workers are jobs that may have to wait for their turn."""
        return self is not Scheduler.DASK


class Backend(NamedTuple):
    """A cluster."""

    scheduler: Scheduler
    address: str | None = None  # of a Dask scheduler; None: as configured, else workers of our own


def read_backend(text: str) -> Backend:
    """Return what `dask`, `dask:ADDRESS`, `slurm` or `htcondor` names.

    Raises:
        CannotRead: It names none of them.
    """
    name, colon, address = text.partition(":")
    names = [scheduler.value for scheduler in Scheduler]
    if name not in names:
        raise CannotRead(f"there is no backend `{name}`", (f"backends: {', '.join(names)}",))
    scheduler = Scheduler(name)
    if not colon:
        return Backend(scheduler)
    if scheduler.has_a_queue or _ADDRESS.fullmatch(address) is None:
        hint = "name a Dask scheduler, as in `dask:tcp://192.0.2.1:8786`; others have no address"
        raise CannotRead(f"`{text}` is no backend", (hint,))
    return Backend(scheduler, address)
