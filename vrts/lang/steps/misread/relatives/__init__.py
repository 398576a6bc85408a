"""Steps of V+ and AS with a mistake of their own: written as VAL-II or another word has it.

Takes the text of a step, gives what is meant by it; it knows neither names nor other steps.
"""
