"""How far the numbers go that name something of the controller."""

OUTPUTS = range(1, 33)  # signals [assumed, manual language/signals#ranges]
INPUTS = range(1001, 1033)
INTERNAL = range(2001, 2257)
HIGHEST_TIMER = 15  # [manual language/settings#timers]
MOST_BITS = 16  # that BITS writes at once [manual language/signals#bits]
HIGHEST_PRIORITY = 127
HIGHEST_SUBSCRIPT = 32767  # [assumed, manual language/numbers#subscripts]
