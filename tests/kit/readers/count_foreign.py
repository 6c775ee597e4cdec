"""Run in a Python of its own: opens one file with one reader and tells how much of it is there."""

import sys

program, path = sys.argv[1:]
if program == "open3d":
    import open3d

    parts = [part.mesh for part in open3d.io.read_triangle_model(path).meshes]
    points = [(len(part.vertices), part.get_min_bound()[1], part.get_max_bound()[1]) for part in parts]
else:
    import assimp_py

    parts = assimp_py.import_file(path, assimp_py.Process_Triangulate).meshes
    ups = [list(part.vertices)[1::3] for part in parts]
    points = [(len(up), min(up), max(up)) for up in ups]
height = max(top for _, _, top in points) - min(low for _, low, _ in points)
sys.stdout.write(f"SEEN {len(points)} {sum(count for count, _, _ in points)} {height:.4f}\n")
