"""Zones of time, as options name them."""

import re
from datetime import UTC, datetime, tzinfo

from vrts.cli.shared.console import fail


def zone_named(name: str) -> tzinfo:
    """Return a zone by its name, or by its offset from UTC."""
    from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

    if re.fullmatch(r"[+-]\d\d:?\d\d", name):
        return datetime.strptime(name, "%z").tzinfo or UTC
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        fail(f"there is no zone `{name}`", ("write such as Europe/Vienna, or +01:00",))
