"""Lines shown at the rate at which a run happened, or faster, or slower."""

from collections.abc import Callable, Iterable

from vrts.report.screen.replay_text import Told


def show_paced(
    lines: Iterable[Told],
    start_s: float,
    speed: float,
    write: Callable[[str], None],
    clock: Callable[[], float],
    sleep: Callable[[float], None],
) -> None:
    """Write every line when it is due.

    Args:
        lines: In the order in which they are shown.
        start_s: Time of the run at which showing begins [s].
        speed: Seconds of the run a second; 0: all at once. Its sign does not matter.
        write: Takes a line.
        clock: Tells the time [s].
        sleep: Waits for some time [s].
    """
    begun = clock()
    for line in lines:
        if speed != 0.0:
            due = begun + abs((line.time_s - start_s) / speed)
            wait = due - clock()
            if wait > 0.0:
                sleep(wait)
        write(line.text)
