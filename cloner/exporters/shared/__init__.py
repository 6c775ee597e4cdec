"""What several formats share: files, pictures, bones, credits, regions and roughness."""
