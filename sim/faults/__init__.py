"""What goes wrong between lens and recorder: in the images, their stamps, their way, and the rig file."""
