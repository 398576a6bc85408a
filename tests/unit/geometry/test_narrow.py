"""Which engine answers, and when it is loaded."""

import subprocess
import sys


def test_nothing_heavy_is_loaded_before_the_first_question() -> None:
    asks = "import sys, vrts.geometry.narrow, vrts.scene.reading.scene_file\n"
    says = "print([m for m in ('numpy', 'coal', 'fcl', 'pinocchio') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", asks + says], capture_output=True, text=True, check=True
    )
    assert done.stdout == "[]\n"
