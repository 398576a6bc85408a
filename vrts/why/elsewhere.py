"""Causes in another future than the one that is shown: what led there to what goes wrong."""

from vrts.check.judgement import Judgement
from vrts.engine.run import Run
from vrts.why.asking import why_at
from vrts.why.chain import Link
from vrts.why.losses import alone

NEAR_S = 0.03  # a tick: contacts are certified between ticks, futures end at one


def in_that_future(run: Run, judgement: Judgement, time_s: float) -> tuple[Link, ...]:
    """Return what led to what goes wrong in another run, as links without a time of their own.

    A reader has another run before the eyes, so each link tells its time in words.

    Args:
        run: The future, a little beyond what goes wrong.
        judgement: The checks of that run.
        time_s: When it goes wrong there [s].
    """
    near = [
        chain.links
        for began_s, chain in alone(run, judgement)
        if chain.links and abs(began_s - time_s) <= NEAR_S
    ]
    links = near[0] if near else why_at(run, time_s).links
    return tuple(_told(link) for link in links)


def _told(link: Link) -> Link:
    if link.time_s is None:
        return link  # data: the same in every future
    return link._replace(time_s=None, says=f"in that future, at {link.time_s:.1f} s, {link.says}")
