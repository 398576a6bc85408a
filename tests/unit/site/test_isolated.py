"""The manual is made where `pip install` builds vrts: with what `build-system` names."""

import subprocess
import sys

from tests.places import ROOT

NOT_THERE = (  # packages that vrts runs with, and that its build does not name
    *("argon2", "coal", "cv2", "example_robot_data", "fcl", "lsprotocol", "numpy", "pinocchio"),
    *("prompt_toolkit", "psutil", "pygls", "rerun", "scipy", "serial", "starlette", "trimesh"),
    "uvicorn",
)
PROGRAM = f"""
import sys

sys.modules.update(dict.fromkeys({NOT_THERE!r}))
import vrts.site.__main__
import vrts.site.extension
from vrts.site.build import generated_pages
from vrts.site.configuration import configuration

pages = generated_pages(vrts.site.__main__.ROOT)
print(len(pages), len(configuration()["man_pages"]))
"""


def test_the_manual_is_made_without_what_vrts_runs_with() -> None:
    made = subprocess.run(
        [sys.executable, "-c", PROGRAM], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    pages, manuals = map(int, made.stdout.split())
    assert pages > 60
    assert manuals > 30
