"""What is to be simulated: arc, friction, effects, and the plan."""
