"""Tests: facts about slides in the modules here, what they share in `support`, long runs in `campaigns`."""
