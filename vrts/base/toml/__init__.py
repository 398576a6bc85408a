"""TOML with places, so that whatever is wrong in a file is told where it stands.

In: the text of a file. Out: tables whose getters report problems; diagnostics.
Knows nothing of scenes, tasks or profiles: what keys mean is said by who reads them.
"""
