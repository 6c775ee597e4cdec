"""glTF for programs with skeletons of their own: Unity, Unreal, Mixamo, VRM and its animations."""
