"""Reads meshes of trimesh (trimesh.Trimesh) and Open3D (open3d.geometry.TriangleMesh), without importing these packages."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np
from numpy.typing import NDArray

from ._errors import Error


def arrays_of(mesh: Any) -> Dict[str, Any]:
    """Returns arguments for Scene.add_mesh: positions and triangles, and uvs, colors and normals if the mesh stores them. Raises
    Error if `mesh` is not a mesh.

    Leaves out the normals of trimesh, because trimesh computes smooth normals for every mesh, even for boxes.
    """
    faces = getattr(mesh, "faces", None) if hasattr(mesh, "faces") else getattr(mesh, "triangles", None)
    if not hasattr(mesh, "vertices") or faces is None:
        raise Error("triangles", "is missing", "indices (n, 3), or a mesh with vertices and faces, such as those of trimesh and Open3D")
    parts: Dict[str, Any] = {"positions": np.asarray(mesh.vertices), "triangles": np.asarray(faces)}
    if _has(mesh, "vertex_normals"):
        parts["normals"] = np.asarray(mesh.vertex_normals)
    if _has(mesh, "vertex_colors"):
        parts["colors"] = linear_light(np.asarray(mesh.vertex_colors)[:, :3])
    visual: Any = getattr(mesh, "visual", None)
    kind = getattr(visual, "kind", None)
    if kind == "vertex":
        parts["colors"] = linear_light(np.asarray(visual.vertex_colors)[:, :3] / 255.0)
    uvs = getattr(visual, "uv", None) if kind == "texture" else None
    if uvs is not None:
        parts["uvs"] = np.asarray(uvs) * (1, -1) + (0, 1)  # trimesh counts v upwards
    return parts


def texture_of(mesh: Any) -> Optional[NDArray[Any]]:
    """Returns the colour texture of a mesh of trimesh as (y, x, 4), uint8. Returns None if the mesh has no texture."""
    surface = getattr(getattr(mesh, "visual", None), "material", None)
    image = getattr(surface, "baseColorTexture", None) or getattr(surface, "image", None)
    return None if image is None else np.asarray(image.convert("RGBA"))


def linear_light(srgb: NDArray[Any]) -> NDArray[Any]:
    """Converts sRGB values from 0 to 1 to linear light (IEC 61966-2-1)."""
    values = srgb.astype(np.float64)
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4).astype(np.float32)


def _has(mesh: Any, what: str) -> bool:
    question = getattr(mesh, f"has_{what}", None)
    return callable(question) and bool(question())
