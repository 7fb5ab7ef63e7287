"""What things are made of: textured triangle meshes of houses, plants, furniture and vehicles."""
