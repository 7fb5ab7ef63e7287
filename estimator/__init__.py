"""The product: estimate the poses of a car's cameras from their images while it drives.

This package owns the vocabulary that every other room speaks (SE3, Camera, Rig, FrameBundle, Estimate,
Status). It knows nothing of simulation, truth or scoring.
"""
