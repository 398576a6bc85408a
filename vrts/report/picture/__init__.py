"""Pictures of moments of a run, drawn with numpy alone.

In: a scene, where things are, a camera. Out: PNG.
Knows neither marks nor pages.
"""
