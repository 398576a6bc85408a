"""How many random scenarios of random programs show only what the search of all futures knows."""

import time

from tests.property.test_explored import among_the_futures
from vrts.base.stack import deep_stack

PROGRAMS, SCENARIOS = 300, 34


@deep_stack()
def test_scenarios_show_no_future_that_is_not_explored() -> None:
    """Asked for: 10,000 scenarios of 300 programs. Fails at the first state that is not known."""
    before = time.process_time()
    for number in range(PROGRAMS):
        among_the_futures(number, SCENARIOS)
    took_s = time.process_time() - before
    print(f"\n{PROGRAMS * SCENARIOS:,} scenarios of {PROGRAMS} programs: every state was explored")
    print(f"{took_s:.0f} s of processor time")
