"""Reads `[robots]` of `course.toml`: how many robots of their own, and when they fall asleep."""

from vrts.base.toml.reading import Table
from vrts.live.rooms.own.limits import OwnLimits

USUAL = OwnLimits()


def read_limits(top: Table) -> OwnLimits:
    """Return what the table says; what it leaves out is as usual."""
    table = top.table("robots")
    if table is None:
        return USUAL
    each = table.integer("each", minimum=1, maximum=64)
    all_ = table.integer("all", minimum=1, maximum=10_000)
    awake = table.integer("awake", minimum=1, maximum=1000)
    each_awake = table.integer("each_awake", minimum=1, maximum=64)
    empty = table.integer("empty_minutes", minimum=1, maximum=1440)
    idle = table.integer("idle_minutes", minimum=1, maximum=1440)
    program = table.integer("program_minutes", minimum=1, maximum=1440)
    table.finish()
    return OwnLimits(
        each=each or USUAL.each,
        all=all_ or USUAL.all,
        awake=awake or USUAL.awake,
        each_awake=each_awake or USUAL.each_awake,
        empty_s=60.0 * empty if empty else USUAL.empty_s,
        idle_s=60.0 * idle if idle else USUAL.idle_s,
        program_s=60.0 * program if program else USUAL.program_s,
    )
