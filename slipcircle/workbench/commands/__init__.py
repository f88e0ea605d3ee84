"""Commands of `slipcircle`: one module each, named as it is typed, with `HELP`, `options(parser)`, `run(options)`."""

COMMANDS = ("new", "run", "plan", "sweep", "records", "search", "backanalyse", "sensitivity", "schema", "cost", "info")
