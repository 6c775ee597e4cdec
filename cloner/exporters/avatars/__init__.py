"""glTF for programs with bones of their own: Unity, Unreal, Mixamo, VRM and its animations."""
