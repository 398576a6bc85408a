"""What a server keeps of people: found by name, handed out whole, and forgotten everywhere.

In: a server's folder and a name. Out: a zip of all that is kept of a person, or a folder without.
"""
