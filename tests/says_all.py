"""Words of the environment that make pytest tell all that is not alike.

Of two long texts that takes minutes: a test that fails would look like one that hangs.
"""

from typing import Final

SAYS_ALL: Final = ("CI", "BUILD_NUMBER")
