"""A second generator of classes with copies, written without sight of how copies are found.

People decide (`people`, `deciding`), write a program for a task (`cans`, `project`) and lay it out
(`layout`); copiers disguise one (`disguises`); `classes` puts 300 hand-ins into a folder, and
`judging` compares what `vrts grade` wrote with what is true.
"""
