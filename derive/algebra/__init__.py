"""From a definition to closed and stable forms, each step proved."""
