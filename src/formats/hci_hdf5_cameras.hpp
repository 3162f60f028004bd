// The cameras of HCI's older light fields (formats/hci_hdf5_format.cpp), from the attributes of their files.
//
// The cameras are parallel. Neighbours in a row are dH apart and neighbours in a column dV, in the unit of GT_DEPTH, which
// is assumed to be metres. focalLength is in pixels. From camera to camera, pictures are shifted by `shift` pixels. A point
// at planar depth Z moves by
//   d = dH focalLength / Z - shift    pixels from camera to camera,
// to the left as the camera moves right. Points at F = dH focalLength / shift do not move: the views are off-axis pictures
// of one rectangle at that distance. If `shift` is 0, the views share no such plane.
//
// Wanner, Meister, Goldluecke: Datasets and benchmarks for densely sampled 4D light fields, VMV 2013.
#pragma once

#include <map>
#include <string>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Sets field.cameras from the attributes, the grid and the size of the views, or field.poses if no plane has zero
/// disparity. Returns false if attributes of the cameras are missing. Throws Error naming `where` and an attribute that
/// is out of range.
bool set_hdf5_cameras(const std::map<std::string, double>& attributes, LightField& field, const std::string& where);

/// Converts a planar depth Z in the file's unit to z as in LightField::depth; -inf: no surface.
float z_of_hdf5_depth(float depth, const LightField& field);

}  // namespace lippmann
