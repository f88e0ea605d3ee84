"""Subcommands of `slipcircle`, one module each.

`options(parser)` adds the options to a parser; `run(options)` returns the answer.
"""

GROUPS = {
    "slope": {
        "new": "write a commented scene file to start from",
        "schema": "explain the keys of scene files: every effect, law and unit",
        "search": "find the critical circle of a slope and its factors of safety",
    },
    "motion": {
        "run": "solve scenes and print their motion side by side",
        "backanalyse": "find the friction, or another parameter, that explains an observation",
        "sensitivity": "differentiate the motion with respect to every parameter of a scene",
    },
    "study": {
        "sweep": "solve a scene on a grid, for samples or under earthquake records",
        "records": "list earthquake records with their intensities, or write synthetic ones",
    },
    "developers": {
        "plan": "print the equation of motion of a scene and how it is solved",
        "cost": "measure computing time against accuracy, for a scene or a kernel",
        "info": "print versions and digests of the installed packages",
    },
}
COMMANDS = {name: words for group in GROUPS.values() for name, words in group.items()}
