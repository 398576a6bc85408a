"""Settings of every test: the same examples in every run, no limits by the clock."""

import signal

from hypothesis import settings

settings.register_profile("vrts", deadline=None, derandomize=True, database=None)
settings.load_profile("vrts")

# shells start what is in the background deaf to Ctrl-C, and every process that a test starts
# inherits that: tests that interrupt one would wait for ever
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
