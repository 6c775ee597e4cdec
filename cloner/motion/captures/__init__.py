"""Motion capture: file readers, joint identification, retargeting."""
