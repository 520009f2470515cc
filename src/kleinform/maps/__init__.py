"""Maps of the workspace, of singularity loci, and of numbers of assembly modes.

`kleinform.maps.joining` (extra ``maps``) joins assembly modes.
"""

from kleinform.lazy import submodules
from kleinform.maps.components import Components
from kleinform.maps.loci import (
    DirectLocus,
    InverseLocus,
    SignedBoxes,
    direct_locus,
    inverse_locus,
)
from kleinform.maps.mesh import Mesh
from kleinform.maps.modes import ModeMap, conditioning, joint_map, workspace_map
from kleinform.maps.rotation_locus import OrientationLocus, orientation_locus
from kleinform.maps.section import Section
from kleinform.maps.volume import Volume
from kleinform.maps.workspace import Workspace, constant_orientation_workspace
from kleinform.maps.zeros import Triangles

__all__ = [
    "Components",
    "DirectLocus",
    "InverseLocus",
    "Mesh",
    "ModeMap",
    "OrientationLocus",
    "Section",
    "SignedBoxes",
    "Triangles",
    "Volume",
    "Workspace",
    "conditioning",
    "constant_orientation_workspace",
    "direct_locus",
    "inverse_locus",
    "joint_map",
    "orientation_locus",
    "workspace_map",
]

__getattr__ = submodules(__name__, ("joining",))
