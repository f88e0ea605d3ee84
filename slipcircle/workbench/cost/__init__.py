"""What each way to compute something costs, and its error."""
