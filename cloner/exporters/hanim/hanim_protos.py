"""The H-Anim 1.1 prototypes that every exported VRML97 file carries.

References
----------
Humanoid Animation Working Group 1999, Specification for a Standard Humanoid, version 1.1.
"""

PROTOS = """\
PROTO Joint [
  exposedField SFVec3f    center           0 0 0
  exposedField MFNode     children         []
  exposedField MFFloat    llimit           []
  exposedField SFRotation limitOrientation 0 0 1 0
  exposedField SFString   name             ""
  exposedField SFRotation rotation         0 0 1 0
  exposedField SFVec3f    scale            1 1 1
  exposedField SFRotation scaleOrientation 0 0 1 0
  exposedField MFFloat    stiffness        [ 0 0 0 ]
  exposedField SFVec3f    translation      0 0 0
  exposedField MFFloat    ulimit           []
  eventIn      MFNode     addChildren
  eventIn      MFNode     removeChildren
]
{
  Transform {
    center           IS center
    children         IS children
    rotation         IS rotation
    scale            IS scale
    scaleOrientation IS scaleOrientation
    translation      IS translation
    addChildren      IS addChildren
    removeChildren   IS removeChildren
  }
}

PROTO Segment [
  field        SFVec3f  bboxCenter       0 0 0
  field        SFVec3f  bboxSize         -1 -1 -1
  exposedField SFVec3f  centerOfMass     0 0 0
  exposedField MFNode   children         []
  exposedField SFNode   coord            NULL
  exposedField MFNode   displacers       []
  exposedField SFFloat  mass             0
  exposedField MFFloat  momentsOfInertia [ 0 0 0 0 0 0 0 0 0 ]
  exposedField SFString name             ""
  eventIn      MFNode   addChildren
  eventIn      MFNode   removeChildren
]
{
  Group {
    bboxCenter     IS bboxCenter
    bboxSize       IS bboxSize
    children       IS children
    addChildren    IS addChildren
    removeChildren IS removeChildren
  }
}

PROTO Site [
  exposedField SFVec3f    center           0 0 0
  exposedField MFNode     children         []
  exposedField SFString   name             ""
  exposedField SFRotation rotation         0 0 1 0
  exposedField SFVec3f    scale            1 1 1
  exposedField SFRotation scaleOrientation 0 0 1 0
  exposedField SFVec3f    translation      0 0 0
  eventIn      MFNode     addChildren
  eventIn      MFNode     removeChildren
]
{
  Transform {
    center           IS center
    children         IS children
    rotation         IS rotation
    scale            IS scale
    scaleOrientation IS scaleOrientation
    translation      IS translation
    addChildren      IS addChildren
    removeChildren   IS removeChildren
  }
}

PROTO Displacer [
  exposedField MFInt32  coordIndex    []
  exposedField MFVec3f  displacements []
  exposedField SFString name          ""
]
{
  Group { }
}

PROTO Humanoid [
  field        SFVec3f    bboxCenter       0 0 0
  field        SFVec3f    bboxSize         -1 -1 -1
  exposedField SFVec3f    center           0 0 0
  exposedField MFNode     humanoidBody     []
  exposedField MFString   info             []
  exposedField MFNode     joints           []
  exposedField SFString   name             ""
  exposedField SFRotation rotation         0 0 1 0
  exposedField SFVec3f    scale            1 1 1
  exposedField SFRotation scaleOrientation 0 0 1 0
  exposedField MFNode     segments         []
  exposedField MFNode     sites            []
  exposedField SFVec3f    translation      0 0 0
  exposedField SFString   version          "1.1"
  exposedField MFNode     viewpoints       []
]
{
  Transform {
    bboxCenter       IS bboxCenter
    bboxSize         IS bboxSize
    center           IS center
    rotation         IS rotation
    scale            IS scale
    scaleOrientation IS scaleOrientation
    translation      IS translation
    children [
      Group { children IS viewpoints }
      Group { children IS humanoidBody }
    ]
  }
}
"""
