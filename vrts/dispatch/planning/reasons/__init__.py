"""What speaks against sending a program, one question a file.

In: a program, its runs, a profile. Out: refusals with their places, some of which can be waived.
Knows neither bundle nor sheet.
"""
