"""What a figure of this run would be on a usual machine: measured by a loop beside it.

Figures are asked of a machine on which `python -c "for i in range(10_000_000): i*i"` takes 0.55 s.
"""

import resource
import subprocess
import sys

LOOP = "for i in range(10_000_000): i*i"
USUAL_S = 0.55  # of the processor, that the loop takes on a usual machine


def slowness() -> float:
    """Return how many times slower than usual the processor is now."""
    before = _children()
    subprocess.run([sys.executable, "-S", "-c", LOOP], check=True)
    return (_children() - before) / USUAL_S


def scaled(name: str, seconds: float, asked: float, slow: tuple[float, float]) -> str:
    """Return a figure in words: as measured, as it would be on a usual machine, and as asked.

    Args:
        name: What was measured.
        seconds: What it took here.
        asked: What it may take on a usual machine [s].
        slow: How much slower than usual the machine was before and after.
    """
    usual = 2.0 * seconds / sum(slow)
    verdict = "met" if usual <= asked else "NOT MET"
    return (
        f"{name}: {seconds:.2f} s here, {usual:.2f} s on a usual machine, asked {asked:.0f} s:"
        f" {verdict} (this machine: {slow[0]:.2f} and {slow[1]:.2f} times slower)"
    )


def _children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
