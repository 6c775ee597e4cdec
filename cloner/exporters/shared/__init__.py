"""Shared parts of exporters: files, pictures, bones, credits, regions and roughness."""
