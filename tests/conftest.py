"""Settings of every test: the same examples in every run, no limits by the clock."""

from hypothesis import settings

settings.register_profile("vrts", deadline=None, derandomize=True, database=None)
settings.load_profile("vrts")
