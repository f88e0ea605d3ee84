"""The Taylor integrator for all scenes. Programs are assembled from `generated.flow` and integrated lane by lane."""
