"""Where tests find things: the checkout, and what tests keep beside them."""

from pathlib import Path

TESTS = Path(__file__).parent
ROOT = TESTS.parent
