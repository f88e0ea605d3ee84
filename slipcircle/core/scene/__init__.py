"""Scene: arc, friction and effects."""
