// tinygltf, compiled in without the parts of it that open files and decode images.
//
// Not linked: Debian's libdraco holds a tinygltf of its own, built otherwise, and shared libraries of both would share symbols.
#include <fstream>  // which the writing half of tinygltf needs all the same

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
