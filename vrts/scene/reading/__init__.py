"""The files of a scene: `scene.toml`, labs, scenarios.

In: texts with places. Out: a scene or a scenario, or what is wrong where.
Opens files only for what a scene names, inside its own folder.
"""
