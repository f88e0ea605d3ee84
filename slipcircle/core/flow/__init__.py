"""The Taylor flow: one engine for every scene. Programs are joined from `generated.flow` and walked lane by lane."""
