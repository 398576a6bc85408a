"""Every future of a program: what may come from outside, at every moment at which it matters.

In: programs, a scene, an environment. Out: a `Proof`: it holds, or the shortest counterexample as a
scenario, or what is open. Opens no file, reads no clock, starts no process.
"""
