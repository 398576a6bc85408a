"""How far the numbers go that name something of the controller."""

OUTPUTS = range(1, 33)  # signals [assumed, manual language/signals#ranges]
INPUTS = range(1001, 1033)
INTERNAL = range(2001, 2257)
ANALOG_INPUTS = range(1, 9)  # channels [assumed, manual language/signals#analog]
ANALOG_OUTPUTS = range(1, 5)
LEAST_COUNT, MOST_COUNT = -2048, 2047  # of analog inputs and outputs: 12 bits with a sign
HIGHEST_TIMER = 15  # [manual language/settings#timers]
MOST_BITS = 16  # that BITS writes at once [manual language/signals#bits]
HIGHEST_PRIORITY = 127
HIGHEST_SUBSCRIPT = 32767  # [assumed, manual language/numbers#subscripts]
