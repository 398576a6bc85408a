"""Steps of V+ and AS with a mistake of their own: written as VAL-II or another word has it.

In: the text of a step. Out: what is meant by it. Knows neither names nor other steps.
"""
