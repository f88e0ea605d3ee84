"""Files written whole, markup, distributions."""
