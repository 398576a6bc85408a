"""The plugin: what pytest asks it while tests are read and before they are run."""

import sys
from pathlib import Path

import pytest

from tests import marked
from tests.forked.dividing import Dividing
from tests.forked.groups import THREADED, apart, groups, is_late


class Forked:
    """Divides tests among workers."""

    def __init__(self, config: pytest.Config, count: int) -> None:
        """Set what is read late aside, and know how many workers to fork."""
        self.config, self.count = config, count
        config.args[:], self.late = apart(config.args, config.invocation_params.dir)
        self.is_worker = False

    def pytest_ignore_collect(self, collection_path: Path) -> bool | None:
        """Leave to a worker what is not forked once it is loaded."""
        if self.is_worker or not is_late(collection_path):
            return None
        named = self.config.args_source is pytest.Config.ArgsSource.ARGS
        if named or marked.may_hold(self.config.option.markexpr, collection_path):
            self.late.append(str(collection_path))
        return True

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Run all tests.

        Raises:
            pytest.UsageError: What cannot be forked is loaded.
        """
        if session.testsfailed and not self.config.option.continue_on_collection_errors:
            raise session.Interrupted(f"{session.testsfailed} errors while tests were read")
        if THREADED in sys.modules:
            raise pytest.UsageError(f"a file loads {THREADED} and is not read late: see groups.py")
        from tests.conftest import group

        Dividing(session, groups(session.items, self.late, group), self.begin).run(self.count)
        if session.shouldfail:
            raise session.Failed(session.shouldfail)
        return True

    def begin(self) -> None:
        """Know that this is a worker."""
        self.is_worker = True
