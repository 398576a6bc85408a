"""What LinuxCNC did as a log that `vrts validate log` reads."""

from collections.abc import Iterator

from vrts.base.units import DEG
from vrts.dispatch.rehearsing.samples import STEP_S, Samples

EVERY = 4  # samples: a row each 4 ms


def log_text(samples: Samples) -> Iterator[str]:
    """Return the log in pieces that end with a line, from the first motion on."""
    yield "# joints that LinuxCNC commanded, as VAL counts them; pauses are LinuxCNC's own\n"
    yield ",".join(("time_s", *(f"jt{k}_deg" for k in range(1, 7)), "motion")) + "\n"
    begun = samples.moving.argmax() if len(samples.joints) else 0
    degrees = samples.joints / DEG
    for k in range(int(begun), len(degrees), EVERY):
        joints = ",".join(f"{value + 0.0:.5f}" for value in degrees[k])
        yield f"{STEP_S * (k - begun):.3f},{joints},{samples.motions[k]}\n"
