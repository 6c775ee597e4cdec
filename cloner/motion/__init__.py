"""Motion: captures retargeted to clones, procedural walk and idle, foot planting, faces."""
